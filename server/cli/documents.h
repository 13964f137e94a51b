// What the commands print with --json: one object each, members as the contract names them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/render/render.h"
#include "dialects/compile/renumber/renumber.h"
#include "dialects/compile/restart/restart.h"
#include "dialects/compile/translate/convert.h"
#include "protocol/receive/transfer.h"
#include "server/app/base/report.h"
#include "server/app/lines/line.h"
#include "server/cli/doctor.h"
#include "server/io/line_record.h"
#include "server/simulator/fleet.h"
#include "store/sqlite/archive.h"

namespace dripfeed::cli {

struct WireHashes {
  std::string wire_sha256;
  std::string text_sha256;
};

std::string run_document(const interpreter::RunResult& result);
// {"text","numbers","references","assumptions","refused":[{"line","text"}]}: the text is null where it is refused.
// {"text","preamble_line","rest_line","assumptions","compared_moves","safe_before","safe_after","diagnostics"}: the
// text is null where it is refused, the safe lines where none was looked for or found.
std::string restart_document(const compile::Restart& made, const text::Source& source);
// {"text","mode","because","blocks","bytes","variables","diagnostics"}: the text is null where it is refused.
std::string render_document(const compile::RenderResult& result, const text::Source& family);

// Where the program of a report was rendered from.
struct RenderedFrom {
  std::string file;
  std::string mode;  // "macro"; "" where the family has faults: then the report is about its own text
  std::string because;
  std::vector<std::uint32_t> lines;  // by line of the program: the family's; 0: none
};
// json::check_files of these reports, with "rendered" and each "family_line" where a program comes from a family;
// `families` has one for each report.
std::string check_document(std::span<const app::CheckReport> reports,
                           std::span<const std::optional<RenderedFrom>> families);

// The figures of a rendered family with its lines: each finding has "family_line", each "max_at_line" a
// "max_at_family_line" after it. `lines`: by line of the program, 0: none.
std::string with_family_lines(const std::string& figures, const std::vector<std::uint32_t>& lines);

// Of a command that found nothing to measure: {"measured": false, …} with what kept it from it.
std::string not_measured_document(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source,
                                  bool ran, bool validated, const std::vector<checks::NotChecked>& not_checked);
// `read_back`: the result; empty: none was due. `line`: the record of the line after it.
std::string send_document(const app::LineReport& report, const WireHashes& hashes, std::string_view read_back,
                          const io::LineRecord& line);
// Of a transfer that was refused because the line is torn.
std::string torn_document(const io::LineRecord& line);
// `output`: the file that it went to.
std::string receive_document(const app::Reception& reception, const receive::Transfer& transfer, std::string_view name,
                             std::string_view output);
// {"findings":[{"check","health","text","cure"}],"faults","warnings"}; `cure` is null where nothing is to be done.
std::string doctor_document(const Findings& found);
// Of a backup or what was restored from it.
std::string holding_document(const sqlite::Holding& holding, std::string_view backup);
std::string verify_document(const sqlite::Verification& found);
std::string simulate_document(const simulator::ControlReport& report, const WireHashes& hashes);
// Of a fleet: {"controls":[…],"total":{…}}, each control with its link.
struct FleetMember {
  std::string link;
  simulator::ControlReport report;
  WireHashes hashes;
};
std::string fleet_document(const std::vector<FleetMember>& members);

}  // namespace dripfeed::cli
