// What the checks say, as JSON: the report that is stored with a verdict, and the objects that the command prints.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "checks/accuracy/cmm.h"
#include "server/app/base/report.h"
#include "server/app/library/compare.h"

namespace dripfeed::json {

// The report's members as GET /checks/{id} shows them.
std::string check_report(const app::CheckReport& report);

// {"files":[…]}: one entry a report, under the name of its source.
std::string check_files(std::span<const app::CheckReport> reports);

// Figures alone; null-free: the check must have run. `validated`: the text itself was looked at before it was run.
std::string time_figures(const timing::Report& report, bool validated = true);
// `cmm`: with what a measuring machine found, as "cmm".
std::string accuracy_figures(const accuracy::Report& report, const std::optional<accuracy::CmmReport>& cmm = {},
                             bool validated = true);
std::string gouge_figures(const gouge::Report& report, bool validated = true);

// What was not checked, a sentence each with its line.
std::vector<std::string> not_checked_sentences(const std::vector<checks::NotChecked>& list);

// What came of comparing two programs: {"text","meaning","motions"}.
std::string comparison(const app::Comparison& comparison);
// The same with which two it is about.
struct ComparedSide {
  std::uint64_t program = 0;
  std::string name;
  std::uint64_t revision = 0;
};
std::string comparison(const std::string& compared, const ComparedSide& first, const ComparedSide& second);

}  // namespace dripfeed::json
