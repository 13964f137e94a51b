// A curve is halved until the axes, moving evenly from one end of a piece to the other, stay on it.
#include "dialects/interpreter/motion/transformed_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dialects/interpreter/motion/transformed.h"
#include "dialects/interpreter/state/frame.h"

namespace dripfeed::interpreter {

namespace {

using Shape = Transformation::Shape;

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kAtCenter_mm = 1e-6;
constexpr int kDeepest = 16;
constexpr std::size_t kX = 0;

constexpr std::uint16_t bit(std::size_t axis) { return static_cast<std::uint16_t>(1U << axis); }

AxisValues between(const AxisValues& a, const AxisValues& b, double share) {
  AxisValues at{};
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) at[axis] = a[axis] + share * (b[axis] - a[axis]);
  return at;
}

}  // namespace

// At the centre every angle will do: it stays as it is. Elsewhere it is the one nearest to where the axis stands.
AxisValues TransformedPieces::axes_at(const AxisValues& plane) const {
  AxisValues at = plane;
  at[plane_.slot] = plane_.real[plane_.slot];
  if (t_.shape == Shape::cylinder) {
    at[t_.rotary] = plane[plane_.slot] / t_.radius_mm * kDegrees;
    return at;
  }
  const double along = radius_value(kX, plane[kX]);
  const double across = plane[plane_.slot];
  const double radius = std::hypot(along, across);
  at[kX] = kept_value(kX, radius);
  const double now = real_[t_.rotary];
  const double angle = t_.zero_deg + std::atan2(across, along) * kDegrees;
  at[t_.rotary] =
      radius < kAtCenter_mm ? at_center_deg_.value_or(now) : angle + 360.0 * std::round((now - angle) / 360.0);
  return at;
}

// How far the axes are from where they should be when they have gone that share of the path from a to b.
double TransformedPieces::error_of(const AxisValues& a, const AxisValues& b, double share,
                                   const AxisValues& wanted) const {
  const AxisValues at = between(a, b, share);
  if (t_.shape == Shape::cylinder) {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == plane_.slot) continue;
      const double d = radius_value(axis, at[axis] - wanted[axis]);
      sum += d * d;
    }
    const double across = at[t_.rotary] / kDegrees * t_.radius_mm - wanted[plane_.slot];
    return std::sqrt(sum + across * across);
  }
  const double angle = (at[t_.rotary] - t_.zero_deg) / kDegrees;
  const double radius = radius_value(kX, at[kX]);
  return std::hypot(radius * std::cos(angle) - radius_value(kX, wanted[kX]),
                    radius * std::sin(angle) - wanted[plane_.slot]);
}

// On the face or cylinder.
double TransformedPieces::length_of(const AxisValues& a, const AxisValues& b) const {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double d = axis == plane_.slot ? b[axis] - a[axis] : radius_value(axis, b[axis] - a[axis]);
    sum += d * d;
  }
  return std::sqrt(sum);
}

// The feed is that of the tool on the work: a piece of it takes its length's part of a minute.
void TransformedPieces::put(const ir::Motion& motion, const AxisValues& plane_end, double length_mm) {
  ir::Motion& made = out_.add(motion.kind);
  const ir::Place place = made.place;
  const ir::ComputeCounts compute = made.compute;
  made = motion;
  made.place = place;
  made.compute = compute;
  if (ir::is_move(motion.kind) && motion.kind != ir::MotionKind::rapid) made.kind = ir::MotionKind::linear;
  made.center = {};
  made.start = real_;
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
    const bool turned = axis == plane_.slot || axis == t_.rotary || (axis == kX && t_.shape == Shape::face);
    if (!turned) made.start[axis] = motion.start[axis];
  }
  made.end = axes_at(plane_end);
  const auto turned = static_cast<std::uint16_t>(bit(t_.rotary) | (t_.shape == Shape::face ? bit(kX) : 0U));
  const auto plane_bits = static_cast<std::uint16_t>(bit(plane_.slot) | (t_.shape == Shape::face ? bit(kX) : 0U));
  const auto in_axes = [&](std::uint16_t bits) {
    return static_cast<std::uint16_t>((bits & ~(plane_bits | bit(t_.rotary))) |
                                      ((bits & plane_bits) != 0 ? turned : 0U));
  };
  made.axes_commanded = in_axes(motion.axes_commanded);
  made.axes_unknown = static_cast<std::uint16_t>(in_axes(motion.axes_unknown) | (plane_.unknown & bit(plane_.slot)) |
                                                 (t_.rotary_known ? 0U : bit(t_.rotary)));
  real_ = made.end;
  state_.position[t_.rotary] = real_[t_.rotary];
  if (t_.shape == Shape::face) state_.position[kX] = real_[kX];
  if (made.kind != ir::MotionKind::linear || length_mm <= 0.0) return;
  const double per_min = motion.feed_mode == ir::FeedMode::per_rev ? motion.feed * motion.spindle_rpm : motion.feed;
  if (motion.feed_mode == ir::FeedMode::inverse_time || per_min <= 0.0) return;
  made.feed_mode = ir::FeedMode::inverse_time;
  made.feed = per_min / length_mm;
}

template <class Path>
void TransformedPieces::pieces(const ir::Motion& motion, const Path& path, double t0, double t1, int depth) {
  const AxisValues from = path(t0);
  const AxisValues to = path(t1);
  const AxisValues real_from = axes_at(from);
  const AxisValues real_to = axes_at(to);
  bool follows = true;
  for (const double share : {0.25, 0.5, 0.75})
    follows = follows && error_of(real_from, real_to, share, path(t0 + share * (t1 - t0))) <= kTransformedChord_mm;
  const bool counts = std::isfinite(real_to[t_.rotary]) && std::isfinite(real_to[kX]);
  if (follows || depth == kDeepest || !counts) {
    ir::Motion piece = motion;
    piece.start = from;
    if (motion.feed_mode == ir::FeedMode::inverse_time && t1 > t0) piece.feed = motion.feed / (t1 - t0);
    return put(piece, to, length_of(from, to));
  }
  const double middle = 0.5 * (t0 + t1);
  pieces(motion, path, t0, middle, depth + 1);
  pieces(motion, path, middle, t1, depth + 1);
}

// Through the centre the rotary axis turns at a stand: the approach ends there, and the retract begins at its own
// angle.
void TransformedPieces::straight(const ir::Motion& motion) {
  const auto path = [&](double t) { return between(motion.start, motion.end, t); };
  if (t_.shape == Shape::cylinder) return pieces(motion, path, 0.0, 1.0, 0);
  const double x = radius_value(kX, motion.start[kX]);
  const double y = motion.start[plane_.slot];
  const double dx = radius_value(kX, motion.end[kX]) - x;
  const double dy = motion.end[plane_.slot] - y;
  const double square = dx * dx + dy * dy;
  const double nearest = square > 0.0 ? std::clamp(-(x * dx + y * dy) / square, 0.0, 1.0) : 1.0;
  if (nearest > 0.0) pieces(motion, path, 0.0, nearest, 0);
  if (nearest >= 1.0) return;
  if (std::hypot(x + nearest * dx, y + nearest * dy) < kAtCenter_mm) turn_at_center(motion, path(nearest), dx, dy);
  pieces(motion, path, nearest, 1.0, 0);
}

void TransformedPieces::turn_at_center(const ir::Motion& motion, const AxisValues& center, double dx, double dy) {
  const double angle = t_.zero_deg + std::atan2(dy, dx) * kDegrees;
  const double now = real_[t_.rotary];
  const double wanted = angle + 360.0 * std::round((now - angle) / 360.0);
  if (std::abs(wanted - now) < 1e-9) return;
  ir::Motion turn = motion;
  turn.kind = ir::MotionKind::rapid;
  turn.feed = 0.0;
  turn.start = center;
  at_center_deg_ = wanted;
  put(turn, center, 0.0);
  at_center_deg_.reset();
}

void TransformedPieces::arc(const ir::Motion& motion) {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  constexpr double kFirstPieces = 36.0;  // so that no piece turns the rotary axis by half a turn unseen
  const PlaneAxes axes = axes_of(motion.plane);
  const double p0 = radius_value(axes.p, motion.start[axes.p]);
  const double q0 = radius_value(axes.q, motion.start[axes.q]);
  const double p = p0 + motion.center[axes.p];
  const double q = q0 + motion.center[axes.q];
  const double from = std::atan2(q0 - q, p0 - p);
  const double p1 = radius_value(axes.p, motion.end[axes.p]);
  const double q1 = radius_value(axes.q, motion.end[axes.q]);
  double turn = std::atan2(q1 - q, p1 - p) - from;
  const bool ccw = motion.kind == ir::MotionKind::arc_ccw;
  turn -= kTwoPi * std::floor(turn / kTwoPi);
  if (!ccw) turn -= kTwoPi;
  if (std::hypot(p1 - p0, q1 - q0) < 1e-9) turn = ccw ? kTwoPi : -kTwoPi;
  const double r0 = std::hypot(p0 - p, q0 - q);
  const double r1 = std::hypot(p1 - p, q1 - q);
  const auto path = [&](double t) {
    AxisValues at = between(motion.start, motion.end, t);
    const double r = r0 + t * (r1 - r0);
    at[axes.p] = kept_value(axes.p, p + r * std::cos(from + t * turn));
    at[axes.q] = kept_value(axes.q, q + r * std::sin(from + t * turn));
    return at;
  };
  const auto count = static_cast<int>(std::ceil(kFirstPieces * std::abs(turn) / kTwoPi));
  for (int i = 0; i < count; ++i)
    pieces(motion, path, static_cast<double>(i) / count, static_cast<double>(i + 1) / count, 0);
}

bool TransformedPieces::bring(const ir::Motion& motion) {
  const auto plane_bits = static_cast<std::uint16_t>(bit(plane_.slot) | (t_.shape == Shape::face ? bit(kX) : 0U));
  if (!ir::is_move(motion.kind)) {
    put(motion, motion.end, 0.0);
    return true;
  }
  if ((motion.axes_unknown & plane_bits) != 0) {
    put(motion, motion.end, 0.0);
    return false;
  }
  if (motion.kind == ir::MotionKind::arc_cw || motion.kind == ir::MotionKind::arc_ccw)
    arc(motion);
  else
    straight(motion);
  return true;
}

}  // namespace dripfeed::interpreter
