// The figures of sums of the past: one table, of which the document (records.cpp), its schema and the rows of a
// spreadsheet are written.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "server/app/jobs/history.h"

namespace dripfeed::json {

struct SumCount {
  std::string_view name;
  std::uint64_t app::Sums::* member;
  std::string_view about;
};
struct SumTime {
  std::string_view name;  // in seconds
  std::int64_t app::Sums::* member;
  std::string_view about;
};
std::span<const SumCount> sum_counts();
std::span<const SumTime> sum_times();
// Nothing where nothing was timed.
std::optional<double> line_use_of(const app::Sums& sums);

// The sum of all is its last row.
std::string history_csv(const app::HistorySums& sums, app::SumsBy by);

}  // namespace dripfeed::json
