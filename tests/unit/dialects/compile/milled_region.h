// An oracle for milled regions that knows nothing of paths: a rectangle with round corners as the set of points within
// a distance, and which points a tool has covered, by brute force over its motions.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "dialects/ir/motion.h"

namespace dripfeed::compile::test {

struct Spot {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

// A rectangle around a centre, turned, in the x-y plane.
struct RoundRectangle {
  double length = 0.0;
  double width = 0.0;
  double corner = 0.0;
  double x = 0.0;
  double y = 0.0;
  double angle_deg = 0.0;

  // Of a point from the edge, mm; below 0 inside.
  [[nodiscard]] double distance(const Spot& at) const {
    const Spot local = turned(at);
    const double over_x = std::abs(local.x) - (length / 2.0 - corner);
    const double over_y = std::abs(local.y) - (width / 2.0 - corner);
    return std::hypot(std::max(over_x, 0.0), std::max(over_y, 0.0)) + std::min(std::max(over_x, over_y), 0.0) - corner;
  }
  [[nodiscard]] Spot turned(const Spot& at) const {
    const double a = -angle_deg * std::numbers::pi / 180.0;
    const double dx = at.x - x;
    const double dy = at.y - y;
    return {dx * std::cos(a) - dy * std::sin(a), dx * std::sin(a) + dy * std::cos(a), at.z};
  }
};

// Points of a motion, no more than `step_mm` apart; arcs lie in the x-y plane and may rise.
inline std::vector<Spot> spots_of(const ir::Motion& m, double step_mm) {
  const Spot from = {m.start[0], m.start[1], m.start[2]};
  const Spot to = {m.end[0], m.end[1], m.end[2]};
  const bool is_arc = m.kind == ir::MotionKind::arc_cw || m.kind == ir::MotionKind::arc_ccw;
  const Spot center = {from.x + m.center[0], from.y + m.center[1], 0.0};
  const double begin = std::atan2(from.y - center.y, from.x - center.x);
  double turn = std::atan2(to.y - center.y, to.x - center.x) - begin;
  if (m.kind == ir::MotionKind::arc_ccw && turn <= 1e-9) turn += 2.0 * std::numbers::pi;
  if (m.kind == ir::MotionKind::arc_cw && turn >= -1e-9) turn -= 2.0 * std::numbers::pi;
  const double radius = std::hypot(m.center[0], m.center[1]);
  const double length = is_arc ? std::abs(turn) * radius : std::hypot(to.x - from.x, to.y - from.y, to.z - from.z);
  const int count = std::max(1, static_cast<int>(std::ceil(length / step_mm)));
  std::vector<Spot> out;
  for (int n = 0; n <= count; ++n) {
    const double share = static_cast<double>(n) / count;
    Spot s = {from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share, from.z + (to.z - from.z) * share};
    if (is_arc) {
      s.x = center.x + radius * std::cos(begin + turn * share);
      s.y = center.y + radius * std::sin(begin + turn * share);
    }
    out.push_back(s);
  }
  return out;
}

// How far the farthest point of the region is from what a tool of that radius has covered, which went along those
// spots; 0: all of it is. Points of a grid, without a margin at the edge.
inline double uncovered_mm(const RoundRectangle& region, const std::vector<Spot>& spots, double radius, double grid_mm,
                           double margin_mm) {
  double worst = 0.0;
  const double reach = std::hypot(region.length, region.width) / 2.0;
  for (double x = region.x - reach; x <= region.x + reach; x += grid_mm) {
    for (double y = region.y - reach; y <= region.y + reach; y += grid_mm) {
      if (region.distance({x, y, 0.0}) > -margin_mm) continue;
      double nearest = 1e9;
      for (const Spot& s : spots) nearest = std::min(nearest, (s.x - x) * (s.x - x) + (s.y - y) * (s.y - y));
      worst = std::max(worst, std::sqrt(nearest) - radius);
    }
  }
  return worst;
}

}  // namespace dripfeed::compile::test
