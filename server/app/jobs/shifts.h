// The shifts of a shop: when each begins, by this server's own clock. A day on which the clock is changed has a shift
// that is longer or shorter.
#pragma once

#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::app {

struct LocalTime {
  std::int64_t from_ms = 0;  // since 1970
  std::int64_t to_ms = 0;
  std::string name;  // of its start: "2026-11-27 06:00", of a day "2026-11-27"
};

class Shifts {
 public:
  // 06:00, 14:00 and 22:00.
  Shifts() = default;
  // "06:00", in any order. Errors: one sentence (no time of day, the same one twice).
  static std::expected<Shifts, std::string> of(std::span<const std::string> begins);
  // The shift in which this moment lies; the night's is of the day on which it began.
  [[nodiscard]] LocalTime shift_of(std::int64_t at_ms) const;

 private:
  std::vector<int> begins_min_ = {6 * 60, 14 * 60, 22 * 60};  // after midnight, rising
};

// The day, from midnight to midnight.
LocalTime day_of(std::int64_t at_ms);

}  // namespace dripfeed::app
