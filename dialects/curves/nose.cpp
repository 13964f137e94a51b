// Offsets of lines are lines and offsets of arcs are arcs: nothing is approximated but corners between arcs, which are
// trimmed as if they were straight there.
#include "dialects/curves/nose.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dripfeed::curves {

namespace {

constexpr std::array<Point, 10> kTips = {Point{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1},
                                         {1, 0},      {0, 1}, {-1, 0}, {0, -1},  {0, 0}};

}  // namespace

std::optional<Point> tip_of(int quadrant) {
  if (quadrant < 0 || quadrant >= static_cast<int>(kTips.size())) return std::nullopt;
  return kTips[static_cast<std::size_t>(quadrant)];
}

Point into_material(const Nose& nose, Point direction) {
  constexpr double kStraight = 1e-12;
  if (std::fabs(direction.z) <= kStraight) return {nose.tip.z > 0.0 ? 1.0 : -1.0, 0.0};
  const Point left{-direction.x, direction.z};
  return left.x < 0.0 ? left : -1.0 * left;
}

std::optional<PathPiece> cut_surface(const Nose& nose, const PathPiece& tip_path) {
  const PathPiece centers = moved(tip_path, -nose.radius * nose.tip);
  const Point normal = into_material(nose, direction_at(centers, 0.5));
  if (const auto* arc = std::get_if<Arc>(&centers)) {
    const double outwards = dot(normal, point_at(centers, 0.5) - arc->center) > 0.0 ? 1.0 : -1.0;
    const double radius = arc->radius + outwards * nose.radius;
    if (!(radius > 0.0)) return std::nullopt;
    return Arc{arc->center, radius, arc->start_angle, arc->sweep};
  }
  return moved(centers, nose.radius * normal);
}

Corner corner_of(const Nose& nose, Point tip_at, Point direction_before, Point direction_after) {
  Corner corner{nose.center(tip_at), into_material(nose, direction_before), into_material(nose, direction_after), 0.0,
                false};
  const double turn = cross(direction_before, direction_after);  // > 0: to the left
  // The material lies to the right of the path when the normal does: then a turn to the left opens a gap.
  const double side = cross(direction_before, corner.normal_before);
  corner.is_gap = turn * side < 0.0;
  if (!corner.is_gap) {
    const double cosine = std::clamp(dot(direction_before, direction_after), -1.0, 1.0);
    corner.trimmed = cosine > -1.0 ? nose.radius * std::sqrt((1.0 - cosine) / (1.0 + cosine)) : 0.0;
  }
  return corner;
}

}  // namespace dripfeed::curves
