// Why transfers stood still or broke off, as people at the machines state it: a reason of the shop's list, and a note.
// The audit keeps each one, so none is lost or changed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"
#include "server/app/ports/clock.h"
#include "store/store.h"

namespace dripfeed::app {

struct StopReason {
  store::Id job = 0;
  std::string reason;  // of the list of that time
  std::string note;
  std::string by;
  std::int64_t at_ms = 0;
};

struct StopReasonCount {
  std::string machine;
  std::string reason;
  std::uint64_t count = 0;
};

// The list of a shop that has stated none.
std::vector<std::string> usual_stop_reasons();
// What is wrong with a list, as one sentence; empty: nothing.
std::string why_no_stop_reasons(const std::vector<std::string>& reasons);

class StopReasons {
 public:
  static constexpr std::size_t kLongestNote = 500;

  StopReasons(store::Store& store, const Clock& clock, std::vector<std::string> offered)
      : store_(store), clock_(clock), offered_(std::move(offered)) {}

  [[nodiscard]] const std::vector<std::string>& offered() const { return offered_; }
  // Errors: invalid (a reason that is not on the list; a note of several lines, or too long), not_found (the job),
  // refused (nothing of it was ever sent), the store's.
  Result<StopReason> state(store::Id job, std::string_view reason, std::string_view note, std::string_view actor);
  // Newest first, store::kPageLimitMax at most.
  Result<std::vector<StopReason>> of_job(store::Id job);
  // Those that were stated in a time, the most frequent first; `machine` empty: of all.
  Result<std::vector<StopReasonCount>> counts(std::int64_t from_ms, std::int64_t to_ms, std::string_view machine);

 private:
  store::Store& store_;
  const Clock& clock_;
  std::vector<std::string> offered_;
};

}  // namespace dripfeed::app
