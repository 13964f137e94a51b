// Sums of the transfers that ended in a time, by machine, part, day or shift. Each sum is that of its rows: what the
// store does not know of a job is in no sum, and how many jobs a sum is of stands with it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"
#include "server/app/jobs/shifts.h"
#include "store/store.h"

namespace dripfeed::app {

enum class SumsBy : std::uint8_t { machine, part, day, shift };
inline constexpr std::array<std::string_view, 4> kSumsByNames = {"machine", "part", "day", "shift"};

// Times in milliseconds.
struct Sums {
  std::uint64_t jobs = 0;
  std::uint64_t done = 0;
  std::uint64_t failed = 0;
  std::uint64_t cancelled = 0;
  std::uint64_t interrupted = 0;
  std::uint64_t bytes = 0;        // on the wire, of those that are done
  std::uint64_t fed = 0;          // jobs that fed at all
  std::int64_t feeding_ms = 0;    // from the first byte to the end, of those that fed
  std::uint64_t held_known = 0;   // jobs whose holds were counted
  std::int64_t held_ms = 0;       // that their controls held
  std::uint64_t holds_known = 0;  // jobs of which it is known how often they held
  std::uint64_t holds = 0;
  std::uint64_t line_known = 0;       // jobs whose line time was counted, and their holds
  std::int64_t line_ms = 0;           // that their characters took on the line
  std::int64_t line_free_ms = 0;      // on the line and not held, of the same jobs
  std::uint64_t forecasts = 0;        // jobs that are done and had a forecast
  std::int64_t forecast_ms = 0;       // of these
  std::int64_t forecast_took_ms = 0;  // from the first byte to the end, of the same jobs
  friend bool operator==(const Sums&, const Sums&) = default;
};

struct SumGroup {
  std::string name;          // "": the part is not known
  std::int64_t from_ms = 0;  // of a day or shift; 0: none
  std::int64_t to_ms = 0;
  Sums sums;
};

struct HistorySums {
  Sums all;
  std::vector<SumGroup> groups;  // machines and parts by name; days and shifts newest first
};

Result<HistorySums> history_sums(store::Store& store, const store::EndedFilter& filter, SumsBy by,
                                 const Shifts& shifts);

}  // namespace dripfeed::app
