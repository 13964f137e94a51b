// Which move the active motion code makes of a block.
#include "dialects/interpreter/motion/move.h"

#include <algorithm>
#include <bit>

#include "dialects/interpreter/motion/direct_line.h"
#include "dialects/interpreter/motion/mover.h"
#include "dialects/interpreter/motion/polar.h"
#include "dialects/interpreter/motion/polynomial_block.h"
#include "dialects/interpreter/motion/spline_block.h"
#include "dialects/interpreter/state/axis_words.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Function;
using ir::MotionKind;

PlainBlock with_coordinates_only(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  constexpr std::uint64_t kPolar = bit_of(Address::polar_angle) | bit_of(Address::polar_radius);
  PlainBlock made = with_coordinates(block, rules, state);
  made.present &= ~kPolar;
  made.unknown &= ~kPolar;
  return made;
}

void move_by(Mover& mover, Function motion, const Target& target) {
  if (motion == Function::arc_cw || motion == Function::arc_ccw)
    return mover.arc(motion == Function::arc_cw ? MotionKind::arc_cw : MotionKind::arc_ccw, target);
  if (motion == Function::arc_via) return mover.arc_via(target);
  if (motion == Function::arc_tangent) return mover.arc_tangent(target);
  if (motion == Function::thread_changing) return mover.changing_thread(target);
  const bool threads = motion == Function::thread || motion == Function::tap || motion == Function::tap_retract;
  mover.straight(motion == Function::linear ? MotionKind::linear
                 : threads                  ? MotionKind::thread
                                            : MotionKind::rapid,
                 target);
}

// What a control makes of words of a polynomial without POLY, the manual does not say.
void leave_place(const PlainBlock& block, const BlockRules& rules, ModalState& state, BlockResult& result) {
  result.notes |= kNotePolynomialAlone;
  forget_positions(block, rules, state);
  state.line = {};
  state.tangent_known = false;
}

// G53 with G91, or with the letters of increments.
void move_by_machine_increment(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options,
                               ModalState& state, MotionBuffer& out, BlockResult& result) {
  const Target target = find_any_target(block, rules, state, false);
  if (rules.semantics.machine_move == ir::MachineMove::programmed && target.incremental == target.commanded)
    return move(block, rules, {false, options.exact_stop, options.motion}, state, out, result);
  result.notes |= kNoteMachineIncrement;
  state.unknown |= target.commanded;
  state.tangent_known = false;
}

}  // namespace

void move(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
          MotionBuffer& out, BlockResult& result) {
  if (has_polar_words(block)) {
    PlainBlock plain = with_coordinates_only(block, rules, state);
    const Function motion = options.motion != Function::none ? options.motion : state.modes.motion;
    if (motion == Function::arc_cw || motion == Function::arc_ccw) plain = with_center_at_pole(plain, rules, state);
    return move(plain, rules, options, state, out, result);
  }
  const Function motion = options.motion != Function::none ? options.motion : state.modes.motion;
  if (motion != Function::polynomial && has_polynomial_words(block)) [[unlikely]]
    return leave_place(block, rules, state, result);
  if (is_direct_line(block, state)) [[unlikely]]
    return move_direct(block, rules, options, state, out, result);
  const Target target = find_any_target(block, rules, state, options.machine_coordinates);
  if (options.machine_coordinates && target.incremental != 0) [[unlikely]]
    return move_by_machine_increment(block, rules, options, state, out, result);
  if (!state.modes.motion_modelled) {
    result.notes |= kNoteMoveNotModelled;
    state.unknown |= target.commanded;
    return;
  }
  if (!state.modes.motion_given) {
    result.notes |= kNoteMotionWithoutCode;
    state.modes.motion_given = true;  // said once
  }
  const bool measures = block.has(Address::measuring) && state.modes.motion == Function::linear;
  if (measures && (target.commanded & state.touch_known) != 0) {
    move_until_touch(block, rules, state, out, result);
    result.notes = (result.notes & ~kNoteSkip) | kNoteMeasuring;
    return;
  }
  if (motion == Function::spline) [[unlikely]] {
    move_along_spline(block, rules, options, target, state, out, result);
  } else if (motion == Function::polynomial) [[unlikely]] {
    move_along_polynomial(block, rules, options, target, state, out, result);
  } else {
    Mover mover(block, rules, options, state, out, result);
    move_by(mover, motion, target);
  }
  if (block.has(Address::measuring)) {
    result.notes |= kNoteMeasuring;
    state.unknown |= target.commanded;
    state.tangent_known = false;
  }
}

void end_at_touch(Target& target, const ModalState& state) {
  double part = 1.0;
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
    const auto bit = static_cast<std::uint16_t>(1U << axis);
    const double travel = target.end[axis] - state.position[axis];
    if ((target.commanded & state.touch_known & ~state.unknown & bit) == 0 || travel == 0.0) continue;
    const double at = (state.touch[axis] - state.position[axis]) / travel;
    if (at >= 0.0) part = std::min(part, at);
  }
  if (part < 1.0)
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
      target.end[axis] = state.position[axis] + (target.end[axis] - state.position[axis]) * part;
}

void move_until_touch(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                      BlockResult& result) {
  Target target = find_any_target(block, rules, state, false);
  end_at_touch(target, state);
  emit_move(MotionKind::linear, target, state.feed, {}, state, out, result);
  result.notes |= kNoteSkip;
  state.skipped = state.position;
  state.skipped_known = static_cast<std::uint16_t>(~state.unknown);
}

void return_to_reference(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                         BlockResult& result) {
  const Target target = find_any_target(block, rules, state, false);
  const auto absolute = static_cast<std::uint16_t>(target.commanded & ~target.incremental);
  // An increment of nothing (G91 G28 Z0) names the axis only: there is no move to the intermediate point.
  if (target.end != state.position || (state.unknown & absolute) != 0)
    Mover(block, rules, {}, state, out, result).straight(MotionKind::rapid, target);
  result.notes &= ~kNoteIncrementalFromUnknown;
  result.notes |= kNoteReferenceUnknown;
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
    if ((target.commanded >> axis & 1U) != 0) state.intermediate[axis] = target.end[axis];
  state.intermediate_known |= target.commanded;
  state.intermediate_known &= static_cast<std::uint16_t>(~(state.unknown & target.commanded));
  forget_positions(block, rules, state);
}

// Through the point where the last G28 went through.
void leave_reference(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                     BlockResult& result) {
  Target through{.end = state.position};
  for (std::uint64_t rest = block.present & rules.axis_addresses; rest != 0; rest &= rest - 1) {
    const std::size_t axis = index_of(rules.axis_words[static_cast<std::size_t>(std::countr_zero(rest))].axis);
    through.commanded |= static_cast<std::uint16_t>(1U << axis);
    through.end[axis] = state.intermediate[axis];
  }
  through.unknown = static_cast<std::uint16_t>(through.commanded & ~state.intermediate_known);
  const MoveOptions options;
  Mover mover(block, rules, options, state, out, result);
  if (through.commanded != 0) mover.straight(MotionKind::rapid, through);
  const Target target = find_any_target(block, rules, state, false);
  if (target.commanded != 0) mover.straight(MotionKind::rapid, target);
}

void forget_positions(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  state.unknown |= axes_of((block.present | block.numbered | block.unknown) & rules.axis_addresses, rules);
}

}  // namespace dripfeed::interpreter
