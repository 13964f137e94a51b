// The system's clocks as app::Clock.
#pragma once

#include <chrono>

#include "server/app/ports/clock.h"

namespace dripfeed::io {

class SteadyClock final : public app::Clock {
 public:
  [[nodiscard]] feed::Time now() const override { return std::chrono::steady_clock::now().time_since_epoch(); }
  [[nodiscard]] std::int64_t wall_ms() const override {
    using std::chrono::milliseconds;
    return std::chrono::duration_cast<milliseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
  }
};

}  // namespace dripfeed::io
