// Counts of the lane of writers. They are changed under the lane's lock, a few additions each, and read without it.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "store/use.h"

namespace dripfeed::sql {

class LaneUse {
 public:
  using Clock = std::chrono::steady_clock;

  void waits() { add(waiting_, 1); }
  void begins(Clock::time_point wanted_at) {
    waiting_.fetch_sub(1, std::memory_order_relaxed);
    add(begun_, 1);
    add(waited_ns_, ns_since(wanted_at));
  }
  void ends(Clock::time_point taken_at) {
    add(turns_, 1);
    add(held_ns_, ns_since(taken_at));
  }
  [[nodiscard]] store::WriteUse now() const {
    return {.begun = of(begun_),
            .waiting = of(waiting_),
            .waited = std::chrono::nanoseconds(of(waited_ns_)),
            .turns = of(turns_),
            .held = std::chrono::nanoseconds(of(held_ns_))};
  }

 private:
  using Count = std::atomic<std::uint64_t>;
  static void add(Count& to, std::uint64_t more) { to.fetch_add(more, std::memory_order_relaxed); }
  static std::uint64_t of(const Count& count) { return count.load(std::memory_order_relaxed); }
  static std::uint64_t ns_since(Clock::time_point then) {
    return static_cast<std::uint64_t>(std::chrono::nanoseconds(Clock::now() - then).count());
  }

  Count begun_ = 0;
  Count waiting_ = 0;
  Count waited_ns_ = 0;
  Count turns_ = 0;
  Count held_ns_ = 0;
};

}  // namespace dripfeed::sql
