// Straight moves and arcs (with a helix along the other axes) as lengths and directions in all axes.
#include "checks/timing/kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "checks/arcs.h"
#include "dialects/ir/thread_lead.h"

namespace dripfeed::timing {

namespace {

constexpr std::size_t kX = 0;

double norm_of(const AxisVector& v) {
  double square = 0.0;
  for (const double one : v) square += one * one;
  return std::sqrt(square);
}

AxisVector moved_by(const ir::Motion& motion, bool x_is_diameter) {
  AxisVector delta{};
  for (std::size_t i = 0; i < delta.size(); ++i) {
    if ((motion.axes_unknown >> i & 1U) != 0) continue;
    delta[i] = (motion.end[i] - motion.start[i]) * (i == kX && x_is_diameter ? 0.5 : 1.0);
  }
  return delta;
}

void shape_arc(PathShape& shape, const ir::Motion& motion, const AxisVector& delta) {
  const checks::PlaneAxes plane = checks::axes_of(motion.plane);
  // From the centre, start and end in the plane.
  const double start_a = -motion.center[plane.abscissa];
  const double start_o = -motion.center[plane.ordinate];
  const double end_a = start_a + delta[plane.abscissa];
  const double end_o = start_o + delta[plane.ordinate];
  const double turn = motion.kind == ir::MotionKind::arc_ccw ? 1.0 : -1.0;
  double sweep = 2.0 * std::numbers::pi;
  if (std::hypot(delta[plane.abscissa], delta[plane.ordinate]) >= checks::kSamePoint_mm) {
    sweep = turn * (std::atan2(end_o, end_a) - std::atan2(start_o, start_a));
    if (sweep <= 0.0) sweep += 2.0 * std::numbers::pi;
  }
  const double radius = 0.5 * (std::hypot(start_a, start_o) + std::hypot(end_a, end_o));
  const double in_plane = radius * sweep;
  if (!(in_plane > 0.0)) return;
  AxisVector across = delta;
  across[plane.abscissa] = across[plane.ordinate] = 0.0;
  shape.length = std::hypot(in_plane, norm_of(across));
  shape.plane_share = in_plane / shape.length;
  shape.radius = radius;
  shape.abscissa = plane.abscissa;
  shape.ordinate = plane.ordinate;
  for (std::size_t i = 0; i < across.size(); ++i) {
    shape.start_direction[i] = shape.end_direction[i] = across[i] / shape.length;
  }
  const double start_angle = std::atan2(start_o, start_a);
  const double end_angle = start_angle + turn * sweep;
  const double share = turn * shape.plane_share;
  shape.start_direction[plane.abscissa] = -share * std::sin(start_angle);
  shape.start_direction[plane.ordinate] = share * std::cos(start_angle);
  shape.end_direction[plane.abscissa] = -share * std::sin(end_angle);
  shape.end_direction[plane.ordinate] = share * std::cos(end_angle);
}

// Smallest limit[i] / |direction[i]|; on arcs the plane's axes each carry all of the plane's speed at some place.
double along(const PathShape& shape, const AxisVector& limits) {
  double lowest = kNoLimit;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const bool in_plane = shape.plane_share > 0.0 && (i == shape.abscissa || i == shape.ordinate);
    const double share = in_plane ? shape.plane_share : std::fabs(shape.start_direction[i]);
    if (share > 0.0) lowest = std::min(lowest, limits[i] / share);
  }
  return lowest;
}

// Integral from 0 to d of max(1/limit, |u|/k), odd in d: what 1/rpm sums to over diameters.
double inverse_speed_integral(double d, double floor, double k) {
  const double size = std::fabs(d);
  const double knee = floor * k;
  const double sum = size <= knee ? floor * size : floor * knee + (size * size - knee * knee) / (2.0 * k);
  return std::copysign(sum, d);
}

// Mean of 1/rpm over the move, minutes; 0 where the spindle's speed is not known.
double minutes_per_turn(const ir::Motion& motion, bool x_is_diameter, double spindle_max_rpm) {
  const double highest = [&] {
    const double programmed = motion.spindle_rpm;
    if (programmed > 0.0 && spindle_max_rpm > 0.0) return std::min(programmed, spindle_max_rpm);
    return std::max(programmed, spindle_max_rpm);
  }();
  if (!(motion.surface_speed_m_min > 0.0)) return motion.spindle_rpm > 0.0 ? 1.0 / highest : 0.0;
  const double factor = x_is_diameter ? 1.0 : 2.0;
  const double from = factor * ((motion.axes_unknown & 1U) != 0 ? motion.end[kX] : motion.start[kX]);
  const double to = factor * motion.end[kX];
  const double floor = highest > 0.0 ? 1.0 / highest : 0.0;
  const double k = 1000.0 * motion.surface_speed_m_min / std::numbers::pi;  // rpm × mm
  if (std::fabs(to - from) < 1e-6) return std::max(floor, std::fabs(from) / k);
  return (inverse_speed_integral(to, floor, k) - inverse_speed_integral(from, floor, k)) / (to - from);
}

// A profile may say anything above zero: what is next to nothing would make times that are no numbers.
double limit_of(double value) {
  constexpr double kLeast = 1e-6;
  return std::clamp(value, kLeast, kNoLimit);
}

// Of a corner that the control rounds; kNoLimit where nothing turns. With the turn θ: the arc of radius r leaves the
// corner by r·(1/cos(θ/2) - 1) and touches at r·tan(θ/2) from it.
double rounded_corner_speed2(const AxisVector& before, const AxisVector& after, const AxisRates& rates,
                             double room_mm) {
  double cosine = 0.0;
  double acceleration = kNoLimit;
  for (std::size_t i = 0; i < before.size(); ++i) {
    cosine += before[i] * after[i];
    if (before[i] != after[i]) acceleration = std::min(acceleration, rates.acceleration[i]);
  }
  const double half_cosine = std::sqrt(std::max(0.0, 0.5 * (1.0 + cosine)));
  const double half_sine = std::sqrt(std::max(0.0, 0.5 * (1.0 - cosine)));
  if (half_sine <= 0.0) return kNoLimit;
  const double by_room = room_mm * half_cosine / half_sine;
  // 1 - cos by the sine, which keeps its digits where the turn is small.
  const double by_tolerance = rates.contour_tolerance_mm * half_cosine * (1.0 + half_cosine) / (half_sine * half_sine);
  return std::min(acceleration * std::min(by_room, by_tolerance), kNoLimit);
}

}  // namespace

AxisRates rates_of(const checks::Machine& machine) {
  constexpr double kPerSecond = 1.0 / 60.0;
  AxisRates rates;
  rates.rapid.fill(kNoLimit);
  rates.feed.fill(kNoLimit);
  rates.acceleration.fill(kNoLimit);
  rates.jerk.fill(kNoLimit);
  rates.rapid_known = rates.acceleration_known = !machine.axes.empty();
  for (const checks::MachineAxis& axis : machine.axes) {
    const auto i = static_cast<std::size_t>(axis.axis);
    if (axis.rapid_mm_min > 0.0) rates.rapid[i] = limit_of(axis.rapid_mm_min * kPerSecond);
    rates.feed[i] = axis.feed_limit_mm_min > 0.0 ? limit_of(axis.feed_limit_mm_min * kPerSecond) : rates.rapid[i];
    if (axis.acceleration_mm_s2 > 0.0) rates.acceleration[i] = limit_of(axis.acceleration_mm_s2);
    if (axis.jerk_mm_s3 > 0.0) rates.jerk[i] = limit_of(axis.jerk_mm_s3);
    rates.rapid_known = rates.rapid_known && axis.rapid_mm_min > 0.0;
    rates.acceleration_known = rates.acceleration_known && axis.acceleration_mm_s2 > 0.0;
  }
  if (machine.feed_limit_mm_min > 0.0) rates.feed_limit = limit_of(machine.feed_limit_mm_min * kPerSecond);
  rates.sample_s = machine.timing.sample_time_ms * 1e-3;
  rates.contour_tolerance_mm = machine.timing.contour_tolerance_mm;
  return rates;
}

PathShape shape_of(const ir::Motion& motion, bool x_is_diameter) {
  PathShape shape;
  const AxisVector delta = moved_by(motion, x_is_diameter);
  if (checks::is_arc(motion)) {
    shape_arc(shape, motion, delta);
    return shape;
  }
  shape.length = norm_of(delta);
  if (!(shape.length > 0.0)) return shape;
  for (std::size_t i = 0; i < delta.size(); ++i) {
    shape.start_direction[i] = shape.end_direction[i] = delta[i] / shape.length;
  }
  return shape;
}

double speed_limit(const PathShape& shape, const AxisRates& rates, bool is_rapid) {
  double speed = along(shape, is_rapid ? rates.rapid : rates.feed);
  if (!is_rapid) speed = std::min(speed, rates.feed_limit);
  if (shape.plane_share > 0.0) {
    const double both = std::min(rates.acceleration[shape.abscissa], rates.acceleration[shape.ordinate]);
    speed = std::min(speed, std::sqrt(both * std::numbers::sqrt2 / 2.0 * shape.radius) / shape.plane_share);
  }
  return speed;
}

double path_acceleration(const PathShape& shape, const AxisRates& rates) {
  const double acceleration = along(shape, rates.acceleration);
  return shape.plane_share > 0.0 ? acceleration * std::numbers::sqrt2 / 2.0 : acceleration;
}

double path_jerk(const PathShape& shape, const AxisRates& rates) { return along(shape, rates.jerk); }

double mean_acceleration(double acceleration, double jerk, double speed) {
  if (!(jerk < kNoLimit) || !(acceleration < kNoLimit) || !(speed > 0.0)) return acceleration;
  // Below a²/j the acceleration is not reached: two parts of the time sqrt(v/j) each.
  const bool reaches = speed * jerk >= acceleration * acceleration;
  const double ramp_s = reaches ? speed / acceleration + acceleration / jerk : 2.0 * std::sqrt(speed / jerk);
  return speed / ramp_s;
}

double corner_speed2(const AxisVector& before, const AxisVector& after, const AxisRates& rates, double room_mm) {
  if (!(rates.sample_s > 0.0)) return kNoLimit;
  double speed = kNoLimit;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double turned = std::fabs(after[i] - before[i]);
    if (turned > 0.0 && rates.acceleration[i] < kNoLimit) {
      speed = std::min(speed, rates.acceleration[i] * rates.sample_s / turned);
    }
  }
  const double sharp2 = std::min(speed * speed, kNoLimit);
  if (!(rates.contour_tolerance_mm > 0.0)) return sharp2;
  return std::max(sharp2, rounded_corner_speed2(before, after, rates, room_mm));
}

namespace {

// Along the path, mm. A thread's lead counts along the axis that moves most; of one that changes, its mean does.
double distance_per_turn(const ir::Motion& motion, const PathShape& shape) {
  if (motion.kind != ir::MotionKind::thread) return motion.feed;
  double share = 0.0;
  for (std::size_t i = 0; i < 3; ++i) share = std::max(share, std::fabs(shape.start_direction[i]));
  if (!(share > 0.0)) return motion.feed;
  return ir::mean_lead(motion.feed, motion.center[0], share * shape.length) / share;
}

}  // namespace

double feed_speed(const ir::Motion& motion, const PathShape& shape, bool x_is_diameter, double spindle_max_rpm) {
  constexpr double kPerSecond = 1.0 / 60.0;
  if (!(motion.feed > 0.0)) return 0.0;
  switch (motion.feed_mode) {
    case ir::FeedMode::per_min: return motion.feed * kPerSecond;
    case ir::FeedMode::inverse_time: return shape.length * motion.feed * kPerSecond;
    case ir::FeedMode::per_rev: {
      const double minutes = minutes_per_turn(motion, x_is_diameter, spindle_max_rpm);
      if (minutes > 0.0) return distance_per_turn(motion, shape) / minutes * kPerSecond;
      return motion.surface_speed_m_min > 0.0 ? kNoLimit : 0.0;  // at the centre nothing but limits is left
    }
  }
  return 0.0;
}

}  // namespace dripfeed::timing
