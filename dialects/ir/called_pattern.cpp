// A row is walked from its nearer end; a circle always from its first angle.
#include "dialects/ir/called_pattern.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace dripfeed::ir {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

PlanePoint at(const CalledPattern& pattern, double angle_deg, double radius) {
  const double angle = angle_deg * kRadiansPerDegree;
  return {.first = pattern.origin.first + radius * std::cos(angle),
          .second = pattern.origin.second + radius * std::sin(angle)};
}

double distance(const PlanePoint& a, const PlanePoint& b) { return std::hypot(a.first - b.first, a.second - b.second); }

}  // namespace

std::optional<CalledPattern> called_pattern(const Program& program, const Call& call) {
  const bool is_circle = is_called(call, CalledSort::holes_on_circle);
  if (!is_circle && !is_called(call, CalledSort::holes_in_row)) return std::nullopt;
  bool is_known = true;
  const auto number = [&](CycleValue which) {
    if (value_of(program, call, which) == ExpressionId::none) return 0.0;
    const std::optional<double> value = number_of(program, call, which);
    is_known &= value.has_value();
    return value.value_or(0.0);
  };
  const CalledPattern found = {
      .origin = {.first = number(CycleValue::pattern_first), .second = number(CycleValue::pattern_second)},
      .angle_deg = number(CycleValue::pattern_angle),
      .start = number(CycleValue::pattern_start),
      .step = number(CycleValue::pattern_step),
      .radius = number(CycleValue::pattern_radius),
      .count = number(CycleValue::pattern_count),
      .is_circle = is_circle};
  return is_known ? std::optional(found) : std::nullopt;
}

std::optional<std::vector<PlanePoint>> holes_of(const CalledPattern& pattern, std::optional<PlanePoint> from) {
  double start = pattern.start;
  double step = pattern.step;
  if (pattern.is_circle) {
    if (step == 0.0) step = 360.0 / pattern.count;
  } else if (pattern.count > 1.0) {
    if (!from) return std::nullopt;
    const double last = start + (pattern.count - 1.0) * step;
    const auto from_tool = [&](double along) { return distance(*from, at(pattern, pattern.angle_deg, along)); };
    if (from_tool(last) < from_tool(start)) {
      start = last;
      step = -step;
    }
  }
  std::vector<PlanePoint> holes;
  holes.reserve(static_cast<std::size_t>(pattern.count));
  for (int n = 0; n < pattern.count; ++n)
    holes.push_back(pattern.is_circle ? at(pattern, pattern.angle_deg + n * step, pattern.radius)
                                      : at(pattern, pattern.angle_deg, start + n * step));
  return holes;
}

}  // namespace dripfeed::ir
