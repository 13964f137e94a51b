// One row a figure: its name, how it is computed, and what it says.
#include "server/json/history.h"

#include <array>
#include <optional>
#include <string_view>

#include "server/app/base/wall_time.h"
#include "server/json/csv.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

namespace {

using app::Sums;

constexpr std::array kCounts = {
    SumCount{"jobs", &Sums::jobs, "transfers that ended"},
    SumCount{"done", &Sums::done, "of these"},
    SumCount{"failed", &Sums::failed, "of these"},
    SumCount{"cancelled", &Sums::cancelled, "of these"},
    SumCount{"interrupted", &Sums::interrupted, "of these"},
    SumCount{"bytes", &Sums::bytes, "on the wire, of those that are done"},
    SumCount{"fed", &Sums::fed, "transfers of which something was sent"},
    SumCount{"held_jobs", &Sums::held_known, "transfers whose holds were timed: `held_s` is of these"},
    SumCount{"holds_jobs", &Sums::holds_known, "transfers whose holds were counted: `holds` is of these"},
    SumCount{"holds", &Sums::holds, "by the controls"},
    SumCount{"line_jobs", &Sums::line_known, "transfers whose characters were timed: `line_s` is of these"},
    SumCount{"forecast_jobs", &Sums::forecasts,
             "transfers that are done and had a forecast: `forecast_s` and `forecast_took_s` are of these"},
};

constexpr std::array kTimes = {
    SumTime{"feeding_s", &Sums::feeding_ms, "from the first byte to the end, in seconds"},
    SumTime{"held_s", &Sums::held_ms, "held by the controls, in seconds"},
    SumTime{"line_s", &Sums::line_ms, "that characters took on the lines, in seconds"},
    SumTime{"line_free_s", &Sums::line_free_ms,
            "from the first byte to the end without the holds, of the same transfers, in seconds"},
    SumTime{"forecast_s", &Sums::forecast_ms, "that the checks expected, in seconds"},
    SumTime{"forecast_took_s", &Sums::forecast_took_ms,
            "from the first byte to the end, of the same transfers, in seconds"},
};

double as_seconds(std::int64_t ms) { return static_cast<double>(ms) / 1e3; }

Members sums_members() {
  Members members;
  for (const SumCount& row : kCounts)
    members.push_back({.name = std::string(row.name), .schema = integer(std::string(row.about))});
  for (const SumTime& row : kTimes)
    members.push_back({.name = std::string(row.name), .schema = number(std::string(row.about))});
  members.push_back(
      {.name = "line_use", .schema = or_null(number("`line_s` of `line_free_s`; null: nothing was timed"))});
  return members;
}

void add_cells(Csv& csv, const Sums& sums) {
  for (const SumCount& row : kCounts) csv.cell(sums.*row.member);
  for (const SumTime& row : kTimes) csv.cell(as_seconds(sums.*row.member));
  csv.cell(line_use_of(sums)).end_row();
}

std::string time_cell(std::int64_t at_ms) { return at_ms == 0 ? std::string() : app::rfc3339(at_ms); }

}  // namespace

std::span<const SumCount> sum_counts() { return kCounts; }
std::span<const SumTime> sum_times() { return kTimes; }

std::optional<double> line_use_of(const Sums& sums) {
  if (sums.line_free_ms <= 0) return std::nullopt;
  return static_cast<double>(sums.line_ms) / static_cast<double>(sums.line_free_ms);
}

std::string history_csv(const app::HistorySums& sums, app::SumsBy by) {
  Csv csv;
  csv.cell(app::kSumsByNames[static_cast<std::size_t>(by)]).cell("from").cell("to");
  for (const SumCount& row : kCounts) csv.cell(row.name);
  for (const SumTime& row : kTimes) csv.cell(row.name);
  csv.cell("line_use").end_row();
  for (const app::SumGroup& group : sums.groups) {
    csv.cell(group.name).cell(time_cell(group.from_ms)).cell(time_cell(group.to_ms));
    add_cells(csv, group.sums);
  }
  csv.cell("all").cell("").cell("");
  add_cells(csv, sums.all);
  return csv.take();
}

Schemas history_schemas() {
  return {{"HistorySums",
           object("sums of the transfers that ended in a time",
                  {{"by", one_of(app::kSumsByNames, "what they are grouped by")},
                   {"all", object("of all groups", sums_members())},
                   {"groups",
                    list_of(object("a machine, part, day or shift",
                                   Members{{"name", text("of the machine; number of the part, empty: not known; the "
                                                         "day, or day and start of the shift, by the server's clock")},
                                           {"from_ms", or_null(time_ms("start of the day or shift"))},
                                           {"to_ms", or_null(time_ms("its end"))}} +
                                       sums_members()),
                            "machines and parts by name; days and shifts newest first")}})}};
}

}  // namespace dripfeed::json
