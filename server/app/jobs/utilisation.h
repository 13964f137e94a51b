// How a machine's line was used, by days of this server's clock: from what the store keeps of its jobs. What it does
// not keep is not there; nothing is guessed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/app/base/error.h"
#include "store/store.h"

namespace dripfeed::app {

struct DayOfUse {
  std::string day;  // "2026-11-24"
  std::int64_t from_ms = 0;
  std::int64_t to_ms = 0;  // midnight of the next day, which may be to come
  double feeding_s = 0.0;  // from the first byte of each job to its end, its holds with it; a job that broke off with
                           // the server counts to its last row in the ledger
  std::optional<double> held_s =
      0.0;                        // nothing where it was not counted for a job, or cannot be divided between two days
  std::uint32_t jobs_done = 0;    // that ended on this day
  std::uint32_t jobs_failed = 0;  // ... with those that an end of the server interrupted
  std::uint32_t jobs_cancelled = 0;
  std::uint64_t bytes = 0;  // wire bytes that passed for certain, of the jobs that ended on this day or are on
};

// The last `days` days, oldest first; today is the last.
Result<std::vector<DayOfUse>> utilisation(store::Store& store, const std::string& machine, std::uint32_t days,
                                          std::int64_t now_ms);

}  // namespace dripfeed::app
