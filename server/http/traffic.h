// What the HTTP server does, in numbers: connections, bodies, requests by route and the result of them, and how long
// their answers took. Counted without a lock, by whoever works; read by whoever asks.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include "server/http/lanes.h"

namespace dripfeed::http {

class Traffic {
 public:
  using Count = std::atomic<std::uint64_t>;
  static constexpr std::size_t kClasses = 5;  // 1xx to 5xx
  // Upper ends of the buckets of durations, in seconds; the last one has none.
  static constexpr std::array kBuckets_s = {0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1,
                                            0.25,  0.5,    1.0,   2.5,  5.0,   10.0, 60.0};
  struct Durations {
    std::array<Count, kBuckets_s.size() + 1> buckets{};  // each its own, not those below it
    Count sum_ns = 0;
  };

  // `routes`: how many there are. A request of none of them counts as the one after the last.
  explicit Traffic(std::size_t routes) : requests_(routes + 1) {}

  void answered(std::size_t route, Lane lane, unsigned status, std::chrono::nanoseconds took);
  [[nodiscard]] std::size_t routes() const { return requests_.size() - 1; }
  [[nodiscard]] std::uint64_t requests(std::size_t route, std::size_t status_class) const {
    return requests_[route][status_class].load(std::memory_order_relaxed);
  }
  [[nodiscard]] const Durations& durations(Lane lane) const { return durations_[static_cast<std::size_t>(lane)]; }
  Count& at_work(Lane lane) { return at_work_[static_cast<std::size_t>(lane)]; }

  Count connections = 0;
  Count body_bytes = 0;     // room taken for all bodies in memory that are read or answered now
  Count spooled_bytes = 0;  // ... and for those in files
  Count uploads = 0;        // bodies in files

 private:
  std::vector<std::array<Count, kClasses>> requests_;
  std::array<Durations, kLanesAndHere> durations_;
  std::array<Count, kLanesAndHere> at_work_{};  // requests that wait for an answer, in the lane's queue or at its hands
};

// One more while it lives.
class Counted {
 public:
  explicit Counted(Traffic::Count& count) : count_(count) { count_.fetch_add(1, std::memory_order_relaxed); }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  ~Counted() { count_.fetch_sub(1, std::memory_order_relaxed); }

 private:
  Traffic::Count& count_;
};

}  // namespace dripfeed::http
