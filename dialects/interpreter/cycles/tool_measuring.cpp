// Fanuc 0i-F B-64604EN, M800/M80 "Automatic tool length measurement": the tool goes by rapid to a distance from the
// place that is named, then slower, and stops where it touches. The difference of the two places goes to the offset in
// effect, which counts from the next move on. On M80 and Mazak R is that distance and F the speed after it; without
// them, and on Fanuc always, parameters say both (6241 to 6256, #8004 to #8006). Which of its values the offset keeps
// the difference in, wear or geometry, is the control's.
#include "dialects/interpreter/cycles/tool_measuring.h"

#include <bit>
#include <cmath>
#include <optional>

#include "dialects/interpreter/motion/mover.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::MotionKind;

constexpr std::uint16_t kX = 1;

// Where it becomes slower; nothing where that is a parameter's, or not on the path. R of a diameter may be either.
std::optional<Target> slow_from(const PlainBlock& block, const BlockRules& rules, const ModalState& state,
                                const Target& target) {
  const bool one = std::has_single_bit(target.commanded);
  const bool diameter = rules.x_is_diameter && target.commanded == kX;
  if (!block.has(Address::r) || !one || diameter || (state.unknown & target.commanded) != 0) return std::nullopt;
  const auto axis = static_cast<std::size_t>(std::countr_zero(target.commanded));
  const double distance = rules.length_mm(block, Address::r, state.modes.inch);
  const double travel = target.end[axis] - state.position[axis];
  if (distance <= 0.0 || distance >= std::abs(travel)) return std::nullopt;
  Target from = target;
  from.end[axis] -= std::copysign(distance, travel);
  return from;
}

// By rapid, and the rest by feed; all by rapid where it is not known how much that is.
void go(const PlainBlock& block, const BlockRules& rules, const Target& target, ModalState& state, MotionBuffer& out,
        BlockResult& result) {
  if (target.commanded == 0 && target.unknown == 0) return;
  const std::optional<Target> from = slow_from(block, rules, state, target);
  Target first = from.value_or(target);
  end_at_touch(first, state);
  emit_move(MotionKind::rapid, first, 0.0, {}, state, out, result);
  if (!from || first.end != from->end) return;
  Target last = target;
  end_at_touch(last, state);
  // F is mm/min whatever the feeds of the program are.
  state.feed_unknown = !block.has(Address::f) || state.modes.feed_mode != ir::FeedMode::per_min;
  emit_move(MotionKind::linear, last, state.feed_unknown ? 0.0 : state.feed, {}, state, out, result);
}

}  // namespace

void measure_tool(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                  BlockResult& result) {
  Mover(block, rules, {}, state, out, result).leave_corners();
  const bool feed_unknown = state.feed_unknown;
  go(block, rules, find_any_target(block, rules, state, false), state, out, result);
  state.feed_unknown = feed_unknown;
  if (((block.present | block.unknown) & bit_of(Address::f)) != 0) {
    // Whether the speed of measuring is the feed from here on the manuals do not say.
    state.feed_unknown = true;
    state.feed = 0.0;
  }
  forget_positions(block, rules, state);
  state.skipped_known &= static_cast<std::uint16_t>(~state.unknown);
  state.tangent_known = false;
  state.gaps |= ir::kLengthsChanged;
  result.notes |= kNoteMeasuringTool;
}

}  // namespace dripfeed::interpreter
