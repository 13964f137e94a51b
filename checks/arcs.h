// Arcs of motions: the axes of their planes, and chords for what draws or sweeps them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "dialects/ir/motion.h"

namespace dripfeed::checks {

struct PlaneAxes {
  std::size_t abscissa;
  std::size_t ordinate;
  std::size_t height;
};
inline PlaneAxes axes_of(ir::Plane plane) {
  constexpr std::array<PlaneAxes, 3> kPlanes = {PlaneAxes{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};  // xy, zx, yz
  return kPlanes[static_cast<std::size_t>(plane)];
}

inline bool is_arc(const ir::Motion& motion) {
  return motion.kind == ir::MotionKind::arc_cw || motion.kind == ir::MotionKind::arc_ccw;
}

// An arc whose ends are as near as this is a full circle.
inline constexpr double kSamePoint_mm = 1e-9;

inline bool is_full_circle(const ir::Motion& motion) {
  const PlaneAxes plane = axes_of(motion.plane);
  return is_arc(motion) && std::hypot(motion.end[plane.abscissa] - motion.start[plane.abscissa],
                                      motion.end[plane.ordinate] - motion.start[plane.ordinate]) < kSamePoint_mm;
}

using AxisValues = std::array<double, ir::kAxisCount>;

// Calls visit(from, to) for chords of an arc or helix, none farther than `error_mm` from it. Diameters of the motion
// must have been halved.
template <class Visit>
void for_chords(const ir::Motion& motion, double error_mm, Visit&& visit) {
  const PlaneAxes plane = axes_of(motion.plane);
  const double center_a = motion.start[plane.abscissa] + motion.center[plane.abscissa];
  const double center_o = motion.start[plane.ordinate] + motion.center[plane.ordinate];
  const auto angle_of = [&](const AxisValues& at) {
    return std::atan2(at[plane.ordinate] - center_o, at[plane.abscissa] - center_a);
  };
  const double radius = std::hypot(motion.center[plane.abscissa], motion.center[plane.ordinate]);
  const double turn = motion.kind == ir::MotionKind::arc_ccw ? 1.0 : -1.0;
  const double full = 2.0 * std::numbers::pi;
  double sweep = std::fmod(turn * (angle_of(motion.end) - angle_of(motion.start)), full);
  if (sweep < 0.0) sweep += full;
  if (is_full_circle(motion)) sweep = full;
  const double angle = std::sqrt(8.0 * error_mm / std::max(radius, error_mm));
  const int chords = std::clamp(static_cast<int>(std::ceil(sweep / angle)), 1, 10000);
  const double start_angle = angle_of(motion.start);
  AxisValues before = motion.start;
  for (int i = 1; i <= chords; ++i) {
    const double part = static_cast<double>(i) / chords;
    AxisValues here = motion.end;
    if (i < chords) {
      here[plane.abscissa] = center_a + radius * std::cos(start_angle + turn * part * sweep);
      here[plane.ordinate] = center_o + radius * std::sin(start_angle + turn * part * sweep);
      here[plane.height] = motion.start[plane.height] + part * (motion.end[plane.height] - motion.start[plane.height]);
    }
    visit(before, here);
    before = here;
  }
}

}  // namespace dripfeed::checks
