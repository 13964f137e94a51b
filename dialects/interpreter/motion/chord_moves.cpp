// Each chord has the block's feed; one that says how long the block takes is shared by length.
#include "dialects/interpreter/motion/chord_moves.h"

#include <cmath>

#include "dialects/interpreter/motion/move.h"

namespace dripfeed::interpreter {

namespace {

double length_of(const AxisValues& a, const AxisValues& b, bool x_is_diameter) {
  return std::hypot((b[0] - a[0]) / (x_is_diameter ? 2.0 : 1.0), b[1] - a[1], b[2] - a[2]);
}

}  // namespace

void emit_chords(std::span<const AxisValues> ends, std::uint16_t commanded, const BlockRules& rules, ModalState& state,
                 MotionBuffer& out, BlockResult& result) {
  const bool shares_time = state.modes.feed_mode == ir::FeedMode::inverse_time;
  double total = 0.0;
  const AxisValues* from = &state.position;
  for (const AxisValues& end : ends) {
    total += length_of(*from, end, rules.x_is_diameter);
    from = &end;
  }
  for (const AxisValues& end : ends) {
    const double own = length_of(state.position, end, rules.x_is_diameter);
    // The feed is 1 / time of the block.
    const double feed = shares_time && own > 0.0 ? state.feed * total / own : state.feed;
    emit_move(ir::MotionKind::spline, {.end = end, .commanded = commanded}, feed, {}, state, out, result);
  }
}

}  // namespace dripfeed::interpreter
