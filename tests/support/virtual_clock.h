// A clock that stands still until a test moves it. The wall runs with it from one fixed instant.
#pragma once

#include <atomic>
#include <chrono>

#include "server/app/ports/clock.h"

namespace dripfeed::test {

class VirtualClock final : public app::Clock {
 public:
  static constexpr std::int64_t kWallStart_ms = 1'700'000'000'000;

  [[nodiscard]] feed::Time now() const override { return feed::Time(now_ns_.load()); }
  [[nodiscard]] std::int64_t wall_ms() const override { return kWallStart_ms + now_ns_.load() / 1'000'000; }
  void set(feed::Time now) { now_ns_.store(now.count()); }

 private:
  std::atomic<std::int64_t> now_ns_{1'000'000'000};
};

}  // namespace dripfeed::test
