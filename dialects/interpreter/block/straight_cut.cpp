// Words to one motion, each field written once.
#include "dialects/interpreter/block/straight_cut.h"

#include "dialects/interpreter/block/feed_word.h"
#include "dialects/interpreter/motion/move.h"
#include "dialects/interpreter/state/axis_words.h"
#include "dialects/interpreter/state/frame.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Function;

bool names_coordinates_and_feed(const PlainBlock& block, const BlockRules& rules) {
  const std::uint64_t marked = block.unknown | block.numbered | block.absolute | block.incremental;
  return (block.present & rules.coordinates) != 0 && (block.present & ~(rules.coordinates | kFeedWord)) == 0 &&
         marked == 0 && block.tool_name == kNoText;
}

bool states_linear_at_most(const PlainBlock& block) {
  if (block.codes.empty()) return true;
  const PlainCode& first = block.codes.front();
  return block.codes.size() == 1 && first.function == Function::linear && first.group == ir::ModalGroup::motion;
}

// No increments, no frame that turns, no cycle, no corner or curve that waits, nothing that bends the path.
bool goes_straight(const ModalState& state) {
  const Modes& modes = state.modes;
  const bool by_code = modes.motion == Function::linear && modes.motion_given && modes.motion_modelled;
  const bool plain = modes.absolute && !modes.has_matrix && !modes.polar_words;
  const bool in_cycle = state.drilling.active || state.turning.active || state.curve.open || state.spline.active;
  const bool waits = state.corner.kind != 0 || state.plane_corner.kind != 0 || state.line.active;
  const bool bends = state.modal_rounding_mm != 0.0 || state.offsets_contour ||
                     state.transformation.shape != Transformation::Shape::none;
  return by_code && plain && !in_cycle && !waits && !bends;
}

// The coordinates go to both places one by one: a copy of what was just written waits until it is in memory.
std::uint16_t go_to(const PlainBlock& block, const BlockRules& rules, ModalState& state, ir::Motion& motion) {
  std::uint16_t commanded = 0;
  for_each_axis_word(block, rules, state.modes, false, [&](std::size_t axis, double value, bool) {
    motion.end[axis] = state.position[axis] = value + state.modes.shift[axis] + state.coordinate_shift[axis];
    commanded |= static_cast<std::uint16_t>(1U << axis);
  });
  return commanded;
}

// What a corner or a tangent circle after it goes by, see Mover::straight.
void take_tangent(const ir::Motion& motion, const BlockRules& rules, ModalState& state) {
  for (std::size_t axis = 0; axis < 3; ++axis) state.tangent[axis] = motion.end[axis] - motion.start[axis];
  if (rules.x_is_diameter) state.tangent[0] /= 2.0;
  const PlaneAxes axes = axes_of(state.modes.plane);
  state.tangent_known = (state.unknown & 7U) == 0 || ((state.unknown >> axes.p | state.unknown >> axes.q) & 1U) == 0;
}

}  // namespace

bool is_straight_cut(const PlainBlock& block, const BlockRules& rules, const ModalState& state) {
  return names_coordinates_and_feed(block, rules) && states_linear_at_most(block) && goes_straight(state);
}

std::uint64_t cut_straight(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out) {
  if (block.has(Address::f)) {
    state.feed = feed_of_word(block, state.modes);
    state.feed_unknown = false;
  }
  ir::Motion& motion = out.add(ir::MotionKind::linear);
  fill_common(motion, state);
  motion.axes_unknown = state.unknown;
  const std::uint16_t commanded = go_to(block, rules, state, motion);
  motion.axes_commanded = commanded;
  motion.feed = state.feed;
  motion.exact_stop = state.modes.exact_stop;
  take_tangent(motion, rules, state);
  state.shifted &= static_cast<std::uint16_t>(~commanded);
  state.unknown &= static_cast<std::uint16_t>(~commanded);
  return state.feed <= 0.0 && !state.feed_unknown ? kNoteNoFeed : 0;
}

}  // namespace dripfeed::interpreter
