// Units and dimensions of the family language. A value is kept in the stored unit of its dimension: mm, degree, second,
// revolution, m/min of surface speed, and mm/min, mm/rev, rpm as they follow; what has more than one of them counts
// time in minutes. So a rendered macro shows the numbers that a person would type.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace dripfeed::family {

// Exponents, doubled so that a square root of a length still has one.
struct Dimension {
  std::int8_t length = 0;
  std::int8_t angle = 0;
  std::int8_t time = 0;
  std::int8_t revolution = 0;
  std::int8_t surface = 0;  // surface speed: of its own, so that it is never taken for a feed

  friend constexpr bool operator==(Dimension, Dimension) = default;
  friend constexpr Dimension operator+(Dimension a, Dimension b) { return a.plus(b, 1); }
  friend constexpr Dimension operator-(Dimension a, Dimension b) { return a.plus(b, -1); }

 private:
  [[nodiscard]] constexpr Dimension plus(Dimension b, int sign) const {
    const auto sum = [sign](std::int8_t p, std::int8_t q) { return static_cast<std::int8_t>(p + sign * q); };
    return {sum(length, b.length), sum(angle, b.angle), sum(time, b.time), sum(revolution, b.revolution),
            sum(surface, b.surface)};
  }
};

inline constexpr Dimension kRatio = {};
inline constexpr Dimension kLength = {.length = 2};
inline constexpr Dimension kAngle = {.angle = 2};
inline constexpr Dimension kTime = {.time = 2};
inline constexpr Dimension kFeedPerMin = {.length = 2, .time = -2};
inline constexpr Dimension kFeedPerRev = {.length = 2, .revolution = -2};
inline constexpr Dimension kSpeed = {.time = -2, .revolution = 2};
inline constexpr Dimension kSurfaceSpeed = {.surface = 2};

// Minutes in one stored unit of time: 1/60 for a pure time (stored in seconds), 1 for everything else.
constexpr double time_scale(Dimension d) { return d == kTime ? 1.0 / 60.0 : 1.0; }

// A unit as written, and how many stored units it is.
struct Unit {
  std::string_view name;
  Dimension dimension;
  double factor = 1.0;
};
std::span<const Unit> units();
// nullptr when no unit has that name ("mm", "mm/rev").
const Unit* find_unit(std::string_view name);

// "a length", "an angle", "a plain number", "mm^2": for messages.
std::string describe(Dimension dimension);
// The unit in which a value of the dimension is stored ("mm", "deg"); "" for a plain number and for what has no unit.
std::string_view stored_unit(Dimension dimension);

// A number with or without a unit ("120 mm", "4.7244 in", "3"), as people write overrides.
struct Quantity {
  double value = 0.0;          // as written
  const Unit* unit = nullptr;  // nullptr: none was written
  [[nodiscard]] double stored() const { return unit == nullptr ? value : value * unit->factor; }
};
// Nothing when it is not a number followed by at most one known unit.
std::optional<Quantity> parse_quantity(std::string_view text);

}  // namespace dripfeed::family
