// The two clocks: a steady one for the line, the wall's for records.
#pragma once

#include <cstdint>

#include "protocol/feed/settings.h"

namespace dripfeed::app {

class Clock {
 public:
  Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  virtual ~Clock() = default;
  [[nodiscard]] virtual feed::Time now() const = 0;        // never steps back
  [[nodiscard]] virtual std::int64_t wall_ms() const = 0;  // since 1970, UTC
};

}  // namespace dripfeed::app
