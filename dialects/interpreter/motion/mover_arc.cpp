// Arcs of a block: by centre, radius, opening angle, a point in between, or tangential.
#include <algorithm>

#include "dialects/interpreter/motion/mover.h"
#include "dialects/interpreter/motion/polar.h"
#include "dialects/interpreter/motion/space_arc.h"

namespace dripfeed::interpreter {

using ir::Address;
using ir::MotionKind;

namespace {

constexpr std::array kCenterAddresses = {Address::i, Address::j, Address::k};
constexpr double kFlat_mm = 1e-9;

// Of points of one line: whether the first lies on the path to the second.
bool is_between(const Vector& via, const Vector& end) {
  double along = 0.0;
  double length2 = 0.0;
  for (std::size_t axis = 0; axis < end.size(); ++axis) {
    along += via[axis] * end[axis];
    length2 += end[axis] * end[axis];
  }
  return along >= 0.0 && along <= length2 && length2 > 0.0;
}

}  // namespace

// CIP: through the point that I1 J1 K1 name.
void Mover::arc_via(const Target& target) {
  const PlaneAxes axes = axes_of(state_.modes.plane);
  constexpr std::uint64_t kVia = bit_of(Address::via_i) | bit_of(Address::via_j) | bit_of(Address::via_k);
  if (starts_unknown(axes) || target.unknown != 0 || (block_.unknown & kVia) != 0) return lose(target);
  // What the control makes of either, the manual does not say.
  if ((block_.present & kVia) == 0 || block_.has(Address::turns)) return lose(target, kNoteArcUndefined);
  if (state_.modes.has_matrix && !keeps_shapes(state_.modes.matrix)) return lose(target, kNoteArcInFrame);
  if (state_.modes.has_matrix && (state_.unknown & 7U) != 0) return lose(target);
  const Vector via = vector_to_via();
  const Vector end = vector_to(target);
  const bool rises = std::abs(via[axes.normal]) > kFlat_mm || std::abs(end[axes.normal]) > kFlat_mm;
  if (rises && (state_.unknown >> axes.normal & 1U) != 0) return lose(target);
  const std::optional<SpaceArc> arc = arc_through(via, end);
  if (!arc.has_value())
    return is_between(via, end) ? straight(MotionKind::linear, target) : lose(target, kNoteArcUndefined);
  if (rises) return arc_in_space(*arc, target);
  const bool left = via[axes.p] * end[axes.q] > via[axes.q] * end[axes.p];
  emit_arc(left ? MotionKind::arc_ccw : MotionKind::arc_cw, axes, {arc->center[axes.p], arc->center[axes.q]}, target);
}

// CT: leaves the move before it without a corner.
void Mover::arc_tangent(const Target& target) {
  const PlaneAxes axes = axes_of(state_.modes.plane);
  if (starts_unknown(axes) || target.unknown != 0 || !state_.tangent_known) return lose(target);
  if (state_.modes.has_matrix && !image_of(state_.modes.matrix, axes).stays)
    return arc_in_tilted_plane(ir::Function::arc_tangent, target);
  const PlanePoint tangent = {state_.tangent[axes.p], state_.tangent[axes.q]};
  const PlanePoint to_end = chord(axes, target);
  const PlanePoint left = {-tangent.q, tangent.p};
  const double aside = left.p * to_end.p + left.q * to_end.q;
  if (length_of(tangent) < 1e-9 || std::abs(aside) < 1e-9 * length_of(tangent))
    return straight(MotionKind::linear, target);
  const double factor = (to_end.p * to_end.p + to_end.q * to_end.q) / (2.0 * aside);
  emit_arc(aside > 0.0 ? MotionKind::arc_ccw : MotionKind::arc_cw, axes, {factor * left.p, factor * left.q}, target);
}

void Mover::arc(MotionKind kind, Target target) {
  const PlaneAxes axes = axes_of(state_.modes.plane);
  if (has_unknown_parts(target)) return lose(target);
  if (state_.modes.has_matrix) {
    image_ = image_of(state_.modes.matrix, axes);
    if (!image_.stays)
      return arc_in_tilted_plane(kind == MotionKind::arc_ccw ? ir::Function::arc_ccw : ir::Function::arc_cw, target);
    if (image_.mirrored) kind = kind == MotionKind::arc_ccw ? MotionKind::arc_cw : MotionKind::arc_ccw;
  }
  if (rules_.semantics.arc_without_center_is_line && !has_center() && !block_.has(Address::r)) {
    result_.notes |= kNoteArcIsLine;
    return straight(MotionKind::linear, target);
  }
  const Turn turn = kind == MotionKind::arc_ccw ? Turn::counterclockwise : Turn::clockwise;
  const std::optional<PlanePoint> center = find_center(axes, turn, target);
  if (!center.has_value()) return starts_unknown(axes) ? lose(target) : void();
  const PlanePoint to_end = chord(axes, target);
  const double start_radius = length_of(*center);
  const double end_radius = length_of({to_end.p - center->p, to_end.q - center->q});
  const double gap = std::abs(start_radius - end_radius);
  const bool fits = gap <= tolerance_of(start_radius);
  if (!fits && starts_unknown(axes)) return lose(target);
  // In a check: ten times as wide a machine may well be set (3410).
  constexpr double kWide = 10.0;
  const bool is_check = rules_.semantics.unset_is_unknown && rules_.semantics.has_vacant;
  if (!fits && (!is_check || gap > kWide * tolerance_of(start_radius)))
    return fail(text::DiagnosticId::arc_radius_mismatch, start_radius, end_radius);
  if (!fits) {
    result_.first = start_radius;
    result_.second = end_radius;
  }
  if (block_.has(Address::turns) && block_.at(Address::turns) >= 1.0)
    emit_turns(kind, axes, *center, opening_of(*center, to_end, turn), target);
  emit_arc(kind, axes, *center, target);
}

// Whether a word that the arc is made of has a value that is not known.
bool Mover::has_unknown_parts(const Target& target) const {
  constexpr std::uint64_t kParts = bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k) | bit_of(Address::r) |
                                   bit_of(Address::arc_radius) | bit_of(Address::opening_angle) |
                                   bit_of(Address::turns);
  const PlaneAxes axes = axes_of(state_.modes.plane);
  return ((target.unknown >> axes.p | target.unknown >> axes.q) & 1U) != 0 || (block_.unknown & kParts) != 0;
}

// By radius, by opening angle, or by I J K; sets the fault and gives nothing when there is none.
std::optional<PlanePoint> Mover::find_center(PlaneAxes axes, Turn turn, Target& target) {
  const Address radius_address = rules_.semantics.arc_radius_is_r ? Address::r : Address::arc_radius;
  const PlanePoint to_end = chord(axes, target);
  std::optional<double> radius;
  if (block_.has(radius_address)) {
    radius = rules_.length_mm(block_, radius_address, state_.modes.inch) * image_.scale;
  } else if (!has_center()) {
    if (block_.has(Address::opening_angle))
      radius = radius_by_opening(length_of(to_end), block_.at(Address::opening_angle));
    if (!radius.has_value()) return fail_center(text::DiagnosticId::arc_without_center, 0.0, 0.0);
  }
  if (radius.has_value()) {
    const auto center = center_by_radius(to_end, *radius, turn, tolerance_of(std::abs(*radius)));
    if (!center.has_value()) result_.detail = ir::AlarmDetail::small_radius;
    return center.has_value() ? center
                              : fail_center(text::DiagnosticId::arc_radius_mismatch, std::abs(*radius),
                                            length_of(to_end) - std::abs(*radius));
  }
  const PlanePoint center = center_of_words(axes);
  if (block_.has(Address::opening_angle)) end_by_angle(axes, center, turn, target);
  return center;
}

bool Mover::has_center() const {
  return (block_.present & (bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k))) != 0;
}

// Centre minus start in the active work offset.
PlanePoint Mover::center_of_words(PlaneAxes axes) const {
  const PlanePoint center{center_word(axes.p), center_word(axes.q)};
  if (!state_.modes.has_matrix) return center;
  const Matrix& m = state_.modes.matrix;
  return {m[axes.p * 3 + axes.p] * center.p + m[axes.p * 3 + axes.q] * center.q,
          m[axes.q * 3 + axes.p] * center.p + m[axes.q * 3 + axes.q] * center.q};
}

// I, J or K as centre minus start; a position (I=AC) is a coordinate of its axis, so a diameter on such an axis.
double Mover::center_word(std::size_t axis) const {
  const Address address = kCenterAddresses[axis];
  if (!block_.has(address)) return 0.0;
  const double value = rules_.length_mm(block_, address, state_.modes.inch);
  if ((block_.absolute & bit_of(address)) == 0) return value;
  const double kept = axis == 0 ? value * rules_.x_factor(state_.modes, false) : value;
  if (state_.modes.has_matrix) return radius_of(axis, kept) - programmed_position(rules_, state_)[axis];
  return radius_of(axis, kept + state_.modes.shift[axis] + state_.coordinate_shift[axis] - state_.position[axis]);
}

void Mover::end_by_angle(PlaneAxes axes, PlanePoint center, Turn turn, Target& target) {
  const PlanePoint end = end_by_opening(center, block_.at(Address::opening_angle), turn);
  target.end[axes.p] = state_.position[axes.p] + kept_of(axes.p, end.p);
  target.end[axes.q] = state_.position[axes.q] + kept_of(axes.q, end.q);
  target.commanded |= static_cast<std::uint16_t>((1U << axes.p) | (1U << axes.q));
}

// TURN=n: n full circles before the arc; every axis outside the plane advances in proportion to the angle.
void Mover::emit_turns(MotionKind kind, PlaneAxes axes, PlanePoint center, double opening_deg, const Target& target) {
  const auto turns = static_cast<std::uint32_t>(std::min(block_.at(Address::turns), 999.0));
  const double total_deg = opening_deg + 360.0 * turns;
  const AxisValues start = state_.position;
  for (std::uint32_t i = 1; i <= turns; ++i) {
    Target part = target;
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
      const bool in_plane = axis == axes.p || axis == axes.q;
      part.end[axis] = in_plane ? start[axis] : start[axis] + (target.end[axis] - start[axis]) * 360.0 * i / total_deg;
    }
    emit_arc(kind, axes, center, part);
  }
}

void Mover::emit_arc(MotionKind kind, PlaneAxes axes, PlanePoint center, const Target& target) {
  const PlanePoint to_end = chord(axes, target);
  ir::Motion& motion = emit(kind, target, state_.feed);
  motion.center[axes.p] = center.p;
  motion.center[axes.q] = center.q;
  const PlanePoint outward = {to_end.p - center.p, to_end.q - center.q};
  const double sign = kind == MotionKind::arc_ccw ? 1.0 : -1.0;
  state_.tangent = {};
  state_.tangent[axes.p] = -sign * outward.q;
  state_.tangent[axes.q] = sign * outward.p;
  state_.tangent_known = !starts_unknown(axes);
  finish_corner();
}

}  // namespace dripfeed::interpreter
