// Arcs are looked at by angle: a level is met where the sine (measured from the travel's direction) fits, and the place
// counts when the angle lies on the arc.
#include "dialects/interpreter/cycles/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dripfeed::interpreter {

namespace {

constexpr double kSmall = 1e-6;  // mm

double angle_of(ShapePoint p, ShapePoint center) {
  return std::atan2(p.level - center.level, p.travel - center.travel);
}

// Share of the arc's turn at which that direction is reached; nothing outside of it.
std::optional<double> share_at(const ShapeSegment& s, double angle) {
  double turned = angle - angle_of(s.from, s.center);
  const double full = 2.0 * std::numbers::pi;
  while (turned * s.turn < 0.0) turned += s.turn > 0.0 ? full : -full;
  while (std::abs(turned) >= full) turned -= s.turn > 0.0 ? full : -full;
  const double share = s.turn == 0.0 ? 0.0 : turned / s.turn;
  if (share > 1.0 + 1e-9)
    return std::abs(turned - (turned > 0 ? full : -full)) < 1e-9 ? std::optional(0.0) : std::nullopt;
  return share;
}

// The points of an arc where a coordinate is largest or smallest lie at multiples of a quarter.
bool turns_back(const ShapeSegment& s, bool in_level, double tolerance_mm) {
  if (!s.arc) return false;
  const double quarter = std::numbers::pi / 2.0;
  for (int k = 0; k < 4; ++k) {
    const bool extreme_of_level = k % 2 == 1;
    if (extreme_of_level != in_level) continue;
    const auto share = share_at(s, k * quarter);
    const double radius = std::hypot(s.from.travel - s.center.travel, s.from.level - s.center.level);
    const double room = std::max(tolerance_mm, kSmall) / std::max(radius, kSmall);
    const double length = std::abs(s.turn);
    if (share && *share * length > std::sqrt(2.0 * room) && (1.0 - *share) * length > std::sqrt(2.0 * room))
      return true;
  }
  return false;
}

}  // namespace

double turn_of(const ShapeSegment& arc, bool positive) {
  constexpr double kFull = 2.0 * std::numbers::pi;
  const double begin = std::atan2(arc.from.level - arc.center.level, arc.from.travel - arc.center.travel);
  const double end = std::atan2(arc.to.level - arc.center.level, arc.to.travel - arc.center.travel);
  double turn = end - begin;
  while (positive && turn <= 1e-12) turn += kFull;
  while (!positive && turn >= -1e-12) turn -= kFull;
  return turn;
}

std::optional<double> travel_at(const ShapeSegment& s, double level) {
  if (!s.arc) {
    const double rise = s.to.level - s.from.level;
    if (std::abs(rise) < 1e-12)
      return std::abs(s.from.level - level) < 1e-9 ? std::optional(s.from.travel) : std::nullopt;
    const double share = (level - s.from.level) / rise;
    if (share < -1e-9 || share > 1.0 + 1e-9) return std::nullopt;
    return s.from.travel + share * (s.to.travel - s.from.travel);
  }
  const double radius = std::hypot(s.from.travel - s.center.travel, s.from.level - s.center.level);
  const double sine = (level - s.center.level) / radius;
  if (std::abs(sine) > 1.0) return std::nullopt;
  const double first = std::asin(sine);
  std::optional<double> best;
  for (const double angle : {first, std::numbers::pi - first}) {
    const auto share = share_at(s, angle);
    if (share && *share >= -1e-9 && (!best || *share < *best)) best = share;
  }
  if (!best) return std::nullopt;
  return s.center.travel + radius * std::cos(angle_of(s.from, s.center) + *best * s.turn);
}

std::vector<ShapeSegment> split_at_turns(const ShapeSegment& s) {
  if (!s.arc) return {s};
  constexpr double kSameShare = 1e-7;
  std::vector<double> shares;
  for (int k = 0; k < 4; ++k)
    if (const auto share = share_at(s, k * std::numbers::pi / 2.0))
      if (*share > kSameShare && *share < 1.0 - kSameShare) shares.push_back(*share);
  std::ranges::sort(shares);
  shares.push_back(1.0);
  const double radius = std::hypot(s.from.travel - s.center.travel, s.from.level - s.center.level);
  const double begin = angle_of(s.from, s.center);
  std::vector<ShapeSegment> parts;
  double last = 0.0;
  for (const double share : shares) {
    ShapeSegment part = s;
    if (!parts.empty()) part.from = parts.back().to;
    const double angle = begin + share * s.turn;
    if (share < 1.0) part.to = {s.center.travel + radius * std::cos(angle), s.center.level + radius * std::sin(angle)};
    part.turn = (share - last) * s.turn;
    last = share;
    parts.push_back(part);
  }
  return parts;
}

bool is_monotonic(const std::vector<ShapeSegment>& shape, double tolerance_mm, std::uint32_t& line, bool& in_level) {
  double travel = 0.0;
  double level = 0.0;
  for (const ShapeSegment& s : shape) {
    const double dw = s.to.travel - s.from.travel;
    const double dl = s.to.level - s.from.level;
    const bool travel_back = (std::abs(dw) > tolerance_mm && dw * travel < 0.0) || turns_back(s, false, tolerance_mm);
    const bool level_back = (std::abs(dl) > tolerance_mm && dl * level < 0.0) || turns_back(s, true, tolerance_mm);
    if (travel_back || level_back) {
      line = s.line;
      in_level = level_back;
      return false;
    }
    if (std::abs(dw) > tolerance_mm) travel = dw;
    if (std::abs(dl) > tolerance_mm) level = dl;
  }
  return true;
}

}  // namespace dripfeed::interpreter
