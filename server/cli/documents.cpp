// The only unit of the command that knows the JSON library.
#include "server/cli/documents.h"

#include <algorithm>
#include <span>
#include <utility>

#include <nlohmann/json.hpp>

#include "server/json/diagnostics.h"
#include "server/json/records.h"
#include "server/json/reports.h"
#include "store/hash/hash.h"

namespace dripfeed::cli {

namespace {

using Document = nlohmann::ordered_json;

std::string dump(const Document& document) {
  return document.dump(-1, ' ', false, Document::error_handler_t::replace) + "\n";
}

// The called program that is meant; null for the one that was given.
Document program_of(const interpreter::RunResult& result, std::uint32_t index) {
  return index == 0 ? Document(nullptr) : Document(result.programs[index]);
}

}  // namespace

std::string run_document(const interpreter::RunResult& result) {
  // An array of a million elements is declared in a line; each name is in the list once, so none is looked for.
  constexpr std::size_t kVariablesShown = 10'000;
  Document variables = Document::object();
  auto& members = static_cast<Document::object_t::Container&>(variables.get_ref<Document::object_t&>());
  for (const interpreter::VariableValue& variable :
       std::span(result.variables).first(std::min(kVariablesShown, result.variables.size()))) {
    Document value = nullptr;
    if (variable.text) {
      value = *variable.text;
    } else if (variable.value) {
      value = *variable.value;
    }
    members.emplace_back(variable.name, std::move(value));
  }
  Document skipped = Document::array();
  for (const interpreter::NotInterpreted& one : result.not_interpreted) {
    skipped.push_back({{"name", one.name},
                       {"program", program_of(result, one.program)},
                       {"line", one.first_line},
                       {"count", one.count},
                       {"effects_known", one.effects_known},
                       {"input", one.is_input}});
  }
  Document alarm = nullptr;
  if (result.ended != interpreter::Ended::end && !result.diagnostics.empty()) {
    const interpreter::RunDiagnostic& last = result.diagnostics.back();
    alarm = {{"program", program_of(result, last.program)},
             {"line", last.line},
             {"alarm", last.diagnostic.alarm},
             {"text", text::message_of(last.diagnostic)}};
    if (!last.diagnostic.notes.empty()) alarm["note"] = last.diagnostic.notes.front().text;
  }
  return dump({{"blocks", result.blocks},
               {"motions", result.motions},
               {"ended", interpreter::name_of(result.ended)},
               {"alarm", alarm},
               {"variables", variables},
               {"variables_left_off", result.variables.size() - variables.size()},
               {"not_interpreted", skipped}});
}

namespace {

Document text_or_null(const std::string& text) { return text.empty() ? Document(nullptr) : Document(text); }
Document line_or_null(std::uint32_t line) { return line == 0 ? Document(nullptr) : Document(line); }

}  // namespace

std::string restart_document(const compile::Restart& made, const text::Source& source) {
  return dump({{"text", text_or_null(made.text)},
               {"preamble_line", line_or_null(made.preamble_line)},
               {"rest_line", line_or_null(made.rest_line)},
               {"assumptions", made.assumptions},
               {"compared_moves", made.compared_moves},
               {"safe_before", line_or_null(made.safe_before)},
               {"safe_after", line_or_null(made.safe_after)},
               {"diagnostics", Document::parse(json::diagnostics(made.diagnostics, source))}});
}

std::string render_document(const compile::RenderResult& result, const text::Source& family) {
  const bool refused = text::has_error(result.diagnostics);
  return dump({{"text", refused ? Document(nullptr) : Document(result.text)},
               {"mode", refused ? Document(nullptr) : Document(compile::name_of(result.mode))},
               {"because", text_or_null(result.because)},
               {"blocks", result.blocks},
               {"bytes", result.bytes},
               {"variables", result.variables},
               {"legend", Document::parse(json::legend(result.legend))},
               {"diagnostics", Document::parse(json::diagnostics(result.diagnostics, family))}});
}

namespace {

Document family_line(std::size_t line, const std::vector<std::uint32_t>& lines) {
  return line_or_null(line > 0 && line <= lines.size() ? lines[line - 1] : 0);
}

// In each row the program's line and the family's.
void add_family_lines(Document& list, const std::vector<std::uint32_t>& lines) {
  for (Document& one : list) one["family_line"] = family_line(one.at("line").get<std::size_t>(), lines);
}

Document with_deepest_lines(const Document& figures, const std::vector<std::uint32_t>& lines) {
  Document out = Document::object();
  for (const auto& [name, value] : figures.items()) {
    out[name] = value.is_object() ? with_deepest_lines(value, lines) : value;
    if (name == "max_at_line") out["max_at_family_line"] = family_line(value.get<std::size_t>(), lines);
  }
  return out;
}

void add_family(Document& file, const RenderedFrom& from) {
  file["file"] = from.file;
  if (from.mode.empty()) return;
  file["rendered"] = {{"mode", from.mode}, {"because", from.because}};
  add_family_lines(file.at("diagnostics"), from.lines);
  for (Document& check : file) {  // each check that ran
    if (check.is_object() && check.contains("findings")) add_family_lines(check.at("findings"), from.lines);
  }
}

}  // namespace

std::string with_family_lines(const std::string& figures, const std::vector<std::uint32_t>& lines) {
  Document document = with_deepest_lines(Document::parse(figures), lines);
  if (document.contains("findings")) add_family_lines(document.at("findings"), lines);
  return dump(document);
}

std::string check_document(std::span<const app::CheckReport> reports,
                           std::span<const std::optional<RenderedFrom>> families) {
  Document document = Document::parse(json::check_files(reports));
  Document& files = document.at("files");
  for (std::size_t i = 0; i < families.size(); ++i)
    if (families[i]) add_family(files.at(i), *families[i]);
  return dump(document);
}

std::string not_measured_document(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source,
                                  bool ran, bool validated, const std::vector<checks::NotChecked>& not_checked) {
  return dump({{"measured", false},
               {"ran", ran},
               {"validated", validated},
               {"diagnostics", Document::parse(json::diagnostics(diagnostics, source))},
               {"not_checked", json::not_checked_sentences(not_checked)}});
}

namespace {

Document line_document(const io::LineRecord& line) {
  return {{"name", line.line},    {"state", io::name_of(line.state)},
          {"what", line.what},    {"why", line.why},
          {"by", line.by},        {"at_ms", line.at_ms},
          {"device", line.device}};
}

}  // namespace

std::string torn_document(const io::LineRecord& line) { return dump({{"torn", true}, {"line", line_document(line)}}); }

std::string send_document(const app::LineReport& report, const WireHashes& hashes, std::string_view read_back,
                          const io::LineRecord& line) {
  return dump({{"bytes", report.total},
               {"wire_sha256", hashes.wire_sha256},
               {"text_sha256", hashes.text_sha256},
               {"handed", report.handed},
               {"clocked", report.clocked},
               {"confirmed", report.confirmed},
               {"holds", report.holds},
               {"hold_s", report.hold_s},
               {"line_use", report.line_use},
               {"cause", report.cause},
               {"read_back", read_back.empty() ? Document(nullptr) : Document(read_back)},
               {"interval", {{"from", report.known.from}, {"to", report.known.to}}},
               {"torn", report.state == app::LineState::torn},
               {"line", line_document(line)}});
}

namespace {

Document verification(const sqlite::Verification& found) {
  Document faults = Document::array();
  for (const sqlite::VerifyFault& fault : found.faults)
    faults.push_back({{"subject", fault.subject}, {"what", fault.what}});
  return {{"whole", found.faults.empty()},
          {"audit", {{"rows", found.audit_rows}, {"head", found.audit_head}}},
          {"ledger", {{"jobs", found.jobs}, {"rows", found.ledger_rows}}},
          {"contents", {{"count", found.contents}, {"bytes", found.content_bytes}}},
          {"torn_machines", found.torn_machines},
          {"faults", std::move(faults)}};
}

}  // namespace

std::string doctor_document(const Findings& found) {
  Document findings = Document::array();
  const auto count = [&](Health health) { return std::ranges::count(found, health, &Finding::health); };
  for (const Finding& one : found) {
    findings.push_back({{"check", one.check},
                        {"health", name_of(one.health)},
                        {"text", one.text},
                        {"cure", one.cure.empty() ? Document(nullptr) : Document(one.cure)}});
  }
  return dump(
      {{"findings", std::move(findings)}, {"faults", count(Health::fault)}, {"warnings", count(Health::warning)}});
}

std::string verify_document(const sqlite::Verification& found) { return dump(verification(found)); }

std::string holding_document(const sqlite::Holding& holding, std::string_view backup) {
  Document document = verification(holding.found);
  document["backup"] = backup;
  document["schema"] = holding.schema;
  document["bytes"] = holding.file_bytes;
  document["holds"] = {{"machines", holding.machines}, {"families", holding.families}, {"parts", holding.parts},
                       {"programs", holding.programs}, {"releases", holding.releases}, {"receipts", holding.receipts},
                       {"tokens", holding.tokens}};
  document["kept"] = holding.kept.empty() ? Document(nullptr) : Document(holding.kept);
  return dump(document);
}

std::string receive_document(const app::Reception& reception, const receive::Transfer& transfer, std::string_view name,
                             std::string_view output) {
  const bool whole = transfer.fault == receive::Fault::none;
  return dump({{"whole", whole},
               {"fault", whole ? Document(nullptr) : Document(receive::name(transfer.fault))},
               {"reason", whole ? Document(nullptr) : Document(receive::message(transfer.fault))},
               {"name", name.empty() ? Document(nullptr) : Document(name)},
               {"code", receive::name(transfer.code)},
               {"bytes", reception.raw.size()},
               {"text_bytes", transfer.text.size()},
               {"text_sha256", hash::sha256_hex(transfer.text)},
               {"parity_errors", transfer.parity_errors},
               {"ended_by", receive::name(reception.ending.by)},
               {"output", output}});
}

namespace {

using Histogram = std::array<std::uint64_t, simulator::kAfterDc3Bins>;

Document histogram_of(const Histogram& after_dc3) {
  Document histogram = Document::array();
  std::size_t used = after_dc3.size();
  while (used > 1 && after_dc3[used - 1] == 0) --used;
  for (std::size_t i = 0; i < used; ++i) histogram.push_back(after_dc3[i]);
  return histogram;
}

// The smallest count that 99 of 100 holds did not pass.
std::uint64_t p99(const Histogram& after_dc3, std::uint64_t holds) {
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < after_dc3.size(); ++i) {
    seen += after_dc3[i];
    if (seen * 100 >= holds * 99) return i;
  }
  return after_dc3.size() - 1;
}

Document control_object(const simulator::ControlReport& report, const WireHashes& hashes) {
  return {{"bytes", report.bytes},
          {"wire_sha256", hashes.wire_sha256},
          {"text_sha256", hashes.text_sha256},
          {"holds", report.holds},
          {"after_dc3_max", report.after_dc3_max},
          {"after_dc3_histogram", histogram_of(report.after_dc3)},
          {"line_use", report.line_use},
          {"parity_errors", report.parity_errors},
          {"framing_errors", report.framing_errors},
          {"alarm", report.alarm.empty() ? Document(nullptr) : Document(report.alarm)},
          {"stalls", report.stalls},
          {"stall_s", report.stall_s},
          {"buffer_min", report.buffer_min},
          {"buffer_max", report.buffer_max},
          {"blocks_run", report.blocks_run},
          {"bytes_run", report.bytes_run},
          {"unfinished_block", report.unfinished_block},
          {"state", simulator::name_of(report.state)}};
}

}  // namespace

std::string simulate_document(const simulator::ControlReport& report, const WireHashes& hashes) {
  return dump(control_object(report, hashes));
}

std::string fleet_document(const std::vector<FleetMember>& members) {
  Document controls = Document::array();
  simulator::ControlReport total;
  std::uint64_t alarms = 0;
  std::uint64_t ended = 0;
  double least_use = 1.0;
  for (const FleetMember& member : members) {
    const simulator::ControlReport& report = member.report;
    Document object = control_object(report, member.hashes);
    object["link"] = member.link;
    controls.push_back(std::move(object));
    total.bytes += report.bytes;
    total.blocks_run += report.blocks_run;
    total.holds += report.holds;
    total.stalls += report.stalls;
    total.stall_s += report.stall_s;
    total.parity_errors += report.parity_errors;
    total.framing_errors += report.framing_errors;
    total.after_dc3_max = std::max(total.after_dc3_max, report.after_dc3_max);
    for (std::size_t i = 0; i < total.after_dc3.size(); ++i) total.after_dc3[i] += report.after_dc3[i];
    alarms += report.alarm.empty() ? 0U : 1U;
    ended += report.state == simulator::ControlState::ended ? 1U : 0U;
    if (report.bytes > 0) least_use = std::min(least_use, report.line_use);
  }
  std::uint64_t closed_holds = 0;
  for (const std::uint64_t count : total.after_dc3) closed_holds += count;
  return dump({{"controls", controls},
               {"total",
                {{"controls", members.size()},
                 {"ended", ended},
                 {"alarms", alarms},
                 {"bytes", total.bytes},
                 {"blocks_run", total.blocks_run},
                 {"holds", total.holds},
                 {"after_dc3_max", total.after_dc3_max},
                 {"after_dc3_p99", p99(total.after_dc3, closed_holds)},
                 {"after_dc3_histogram", histogram_of(total.after_dc3)},
                 {"line_use_min", least_use},
                 {"parity_errors", total.parity_errors},
                 {"framing_errors", total.framing_errors},
                 {"stalls", total.stalls},
                 {"stall_s", total.stall_s}}}});
}

}  // namespace dripfeed::cli
