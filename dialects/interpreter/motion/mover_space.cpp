// Arcs that lie in no plane of the control's own: CIP in space, and planes that a frame tilts. They come out as chords.
#include <cmath>

#include "dialects/interpreter/motion/chord_moves.h"
#include "dialects/interpreter/motion/mover.h"
#include "dialects/interpreter/motion/polar.h"

namespace dripfeed::interpreter {

using ir::Address;
using ir::Function;
using ir::MotionKind;

namespace {

constexpr std::array kViaAddresses = {Address::via_i, Address::via_j, Address::via_k};
constexpr std::uint64_t kCorners =
    bit_of(Address::chamfer) | bit_of(Address::chamfer_length) | bit_of(Address::rounding);

constexpr double kSame_mm = 1e-9;

// The frame taken off: the axes stand where they are programmed.
ModalState as_programmed(const BlockRules& rules, const ModalState& state) {
  ModalState own = state;
  const Vector at = programmed_position(rules, state);
  own.tangent = multiply(inverse_of(state.modes.matrix), state.tangent);
  own.modes.matrix = kIdentity;
  own.modes.has_matrix = false;
  for (std::size_t axis = 0; axis < at.size(); ++axis) {
    own.position[axis] = axis == 0 && rules.x_is_diameter ? 2.0 * at[axis] : at[axis];
    own.modes.shift[axis] = own.coordinate_shift[axis] = 0.0;
  }
  own.corner = {};
  own.modal_rounding_mm = 0.0;
  return own;
}

}  // namespace

// PGA, "Circular interpolation via intermediate point (CIP)": with G91 it counts from the start, as the end does.
Vector Mover::vector_to_via() const {
  const bool in_frame = state_.modes.has_matrix;
  Vector to_via{};
  if (in_frame) to_via = programmed_position(rules_, state_);
  const Vector start = to_via;
  for (std::size_t axis = 0; axis < to_via.size(); ++axis) {
    const Address address = kViaAddresses[axis];
    if (!block_.has(address)) continue;
    const bool absolute = (block_.absolute & bit_of(address)) != 0;
    const bool adds = !absolute && (!state_.modes.absolute || (block_.incremental & bit_of(address)) != 0);
    double value = rules_.length_mm(block_, address, state_.modes.inch);
    if (axis == 0) value *= rules_.x_factor(state_.modes, adds);
    const double from = state_.position[axis] - state_.modes.shift[axis] - state_.coordinate_shift[axis];
    if (adds)
      to_via[axis] += radius_of(axis, value);
    else
      to_via[axis] = in_frame ? radius_of(axis, value) : radius_of(axis, value - from);
  }
  if (!in_frame) return to_via;
  for (std::size_t axis = 0; axis < to_via.size(); ++axis) to_via[axis] -= start[axis];
  return multiply(state_.modes.matrix, to_via);
}

Vector Mover::vector_to(const Target& target) const {
  Vector travel{};
  for (std::size_t axis = 0; axis < travel.size(); ++axis)
    travel[axis] = radius_of(axis, target.end[axis] - state_.position[axis]);
  return travel;
}

void Mover::arc_in_space(const SpaceArc& arc, const Target& target) {
  const AxisValues start = state_.position;
  const auto at = [&](double t) {
    if (t == 1.0) return target.end;
    AxisValues point{};
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
      point[axis] = start[axis] + t * (target.end[axis] - start[axis]);
    const Vector offset = arc.at(t);
    for (std::size_t axis = 0; axis < offset.size(); ++axis) point[axis] = start[axis] + kept_of(axis, offset[axis]);
    return point;
  };
  std::uint16_t commanded = target.commanded;
  for (std::size_t axis = 0; axis < arc.center.size(); ++axis)
    if (arc.center[axis] != 0.0 || arc.across[axis] != 0.0) commanded |= static_cast<std::uint16_t>(1U << axis);
  leave_corners();
  emit_chords(chords_of(start, at), commanded, rules_, state_, out_, result_);
  state_.tangent = arc.end_tangent();
  state_.tangent_known = true;
}

void Mover::arc_in_tilted_plane(Function function, const Target& target) {
  if (!keeps_shapes(state_.modes.matrix)) return lose(target, kNoteArcInFrame);
  if (((state_.unknown | target.unknown) & 7U) != 0) return lose(target);
  ModalState own = as_programmed(rules_, state_);
  PlainBlock block = block_;
  block.present &= ~kCorners;
  BlockResult result;
  std::vector<ir::Motion> made;
  std::vector<ir::Motion>* const outer = out_.captured();
  out_.capture(&made);
  Mover mover(block, rules_, options_, own, out_, result);
  const Target programmed = find_target(block, rules_, own, false);
  // A full circle ends where it starts: what turning back and forth has rounded is no path.
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::abs(programmed.end[axis] - own.position[axis]) < kSame_mm) own.position[axis] = programmed.end[axis];
  if (function == Function::arc_tangent)
    mover.arc_tangent(programmed);
  else
    mover.arc(function == Function::arc_ccw ? MotionKind::arc_ccw : MotionKind::arc_cw, programmed);
  out_.capture(outer);
  if (result.fault != text::DiagnosticId::count_) {
    result_ = result;
    return;
  }
  if (made.empty()) return lose(target, result.notes);
  for (const ir::Motion& motion : made) bring_out_of_tilted_plane(motion, target);
  result_.notes |= result.notes;
}

void Mover::bring_out_of_tilted_plane(const ir::Motion& motion, const Target& target) {
  const Vector programmed = {radius_of(0, motion.end[0]), motion.end[1], motion.end[2]};
  const Vector at = multiply(state_.modes.matrix, programmed);
  Target part = target;
  part.end = motion.end;
  for (std::size_t axis = 0; axis < at.size(); ++axis) {
    part.end[axis] = kept_of(axis, at[axis]) + state_.modes.shift[axis] + state_.coordinate_shift[axis];
    if (part.end[axis] != state_.position[axis]) part.commanded |= static_cast<std::uint16_t>(1U << axis);
  }
  if (motion.kind == MotionKind::linear) return straight(motion.kind, part);
  const PlaneAxes axes = axes_of(motion.plane);
  const auto travel = [&](std::size_t axis) { return radius_of(axis, motion.end[axis] - motion.start[axis]); };
  const Turn turn = motion.kind == MotionKind::arc_ccw ? Turn::counterclockwise : Turn::clockwise;
  const SpaceArc arc = arc_in_plane(axes, {motion.center[axes.p], motion.center[axes.q]},
                                    {travel(axes.p), travel(axes.q)}, travel(axes.normal), turn);
  arc_in_space(image_of(arc, state_.modes.matrix), part);
}

}  // namespace dripfeed::interpreter
