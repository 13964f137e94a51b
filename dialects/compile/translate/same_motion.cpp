// How a spindle turns that its position is given for, a run does not state; a tap that is written as a tap has the same
// lead, at the same speed.
#include "dialects/compile/translate/same_motion.h"

#include <algorithm>
#include <cmath>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/passes/round_positions.h"

namespace dripfeed::compile {

namespace {

constexpr double kLeadShare = 2e-4;  // a lead has four decimals

bool alike(double a, double b) { return std::abs(a - b) <= 1e-3 * std::max(std::abs(a), std::abs(b)); }

double lead_mm(const ir::Motion& m) {
  const bool by_time = m.kind == ir::MotionKind::linear && m.feed_mode == ir::FeedMode::per_min;
  return by_time ? m.feed / m.spindle_rpm : m.feed;
}

// A lead below 0 is a left-hand tap, whatever the spindle did before it.
bool turns_alike(const ir::Motion& a, const ir::Motion& b) {
  const ir::Motion& other = a.feed < 0.0 ? b : a;
  return other.spindle == ir::SpindleState::counterclockwise && alike(a.spindle_rpm, b.spindle_rpm);
}

double diameter(const ir::Control& c) { return c.semantics.power_on_diameter == ir::DiameterMode::radius ? 1.0 : 2.0; }

// A tap and its thread; the return between two pecks.
bool may_stand_for(ir::MotionKind a, ir::MotionKind b) {
  using enum ir::MotionKind;
  return (a == linear && (b == thread || b == rapid)) || (b == linear && (a == thread || a == rapid));
}

}  // namespace

bool leaves_end_open(const ir::Motion& a, const ir::Motion& b) {
  return (b.gaps & ir::kEndUnknown) != 0 && (a.gaps & ir::kEndUnknown) == 0;
}

SameMotion::SameMotion(const ir::Control& from, const ir::Control& to, bool inch)
    : x_factor_(diameter(to) / diameter(from)),
      tolerance_mm_(1.1 * std::max(passes::least_increment_mm(from, inch), passes::least_increment_mm(to, inch))) {}

bool SameMotion::same(const ir::Motion& a, const ir::Motion& b, CyclePart part) const {
  const bool of_cycle = part != CyclePart::none;
  if (a.kind == ir::MotionKind::dwell) return b.kind == a.kind && alike(a.feed, b.feed);
  const bool chord = a.kind == ir::MotionKind::spline && b.kind == ir::MotionKind::linear;
  if (a.kind != b.kind && !chord && !(of_cycle && may_stand_for(a.kind, b.kind))) return false;
  if (a.machine_coordinates != b.machine_coordinates || a.comp != b.comp || a.coolant != b.coolant) return false;
  if (!same_end(a, b)) return false;
  if (a.kind != b.kind && !chord) return true;
  // Where the spindle turns back and which speed it has out of the hole, the cycles know; into it, it is the same.
  const bool turns = part == CyclePart::none || part == CyclePart::entry;
  const bool has_center = is_arc(a.kind) || a.kind == ir::MotionKind::thread;
  if (has_center && !std::ranges::equal(a.center, b.center, [&](double x, double y) { return near(x, y); }))
    return false;
  // An S that was given to a spindle that stands is written where it starts.
  const bool stands = a.spindle == ir::SpindleState::stopped && b.spindle == ir::SpindleState::stopped;
  const bool same_speed =
      stands || (alike(a.spindle_rpm, b.spindle_rpm) && alike(a.surface_speed_m_min, b.surface_speed_m_min));
  const bool left = a.kind == ir::MotionKind::thread && (a.feed < 0.0) != (b.feed < 0.0);
  if (left) return std::abs(a.feed + b.feed) <= kLeadShare * std::abs(a.feed) && (!turns || turns_alike(a, b));
  if (turns && (a.spindle != b.spindle || !same_speed)) return false;
  return a.kind == ir::MotionKind::rapid || (alike(a.feed, b.feed) && a.feed_mode == b.feed_mode);
}

bool SameMotion::stays(const ir::Motion& m) const {
  if (m.kind != ir::MotionKind::rapid && m.kind != ir::MotionKind::linear) return false;
  if (m.machine_coordinates || (m.axes_unknown & m.axes_commanded) != 0) return false;
  return std::ranges::equal(m.start, m.end, [&](double x, double y) { return near(x, y); });
}

bool SameMotion::same_of_tap(const ir::Motion& a, const ir::Motion& b) const {
  using enum ir::MotionKind;
  const bool cut = a.kind == linear || a.kind == thread;
  if (!cut) {
    const bool same_kind = a.kind == b.kind && (a.kind == rapid || a.kind == dwell);
    return same_kind && (a.kind == dwell ? alike(a.feed, b.feed) : a.comp == b.comp && same_end(a, b));
  }
  if ((b.kind != linear && b.kind != thread) || a.comp != b.comp || a.coolant != b.coolant || !same_end(a, b))
    return false;
  const bool floats = a.kind == linear && b.kind == linear;
  const double lead = lead_mm(a);
  return alike(a.spindle_rpm, b.spindle_rpm) && (!floats || a.spindle == b.spindle) &&
         std::abs(lead - lead_mm(b)) <= kLeadShare * std::abs(lead);
}

bool SameMotion::same_end(const ir::Motion& a, const ir::Motion& b) const {
  if (leaves_end_open(a, b)) return false;
  const std::uint16_t unknown = a.axes_unknown | b.axes_unknown;
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
    const bool named = ((a.axes_commanded | b.axes_commanded) & (1U << axis)) != 0;
    if (!named && (unknown & (1U << axis)) != 0) continue;
    if (!near(axis == 0 ? a.end[axis] * x_factor_ : a.end[axis], b.end[axis])) return false;
  }
  return true;
}

bool SameMotion::near(double a, double b) const { return std::abs(a - b) <= tolerance_mm_; }

}  // namespace dripfeed::compile
