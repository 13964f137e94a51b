// A block's curve as a chain of spline motions, no chord of it farther from the curve than kCurveChord_mm.
#pragma once

#include <span>
#include <vector>

#include "dialects/interpreter/motion/curve_chords.h"
#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

// Ends of the chords of a curve; `at(t)` gives its points, as ModalState::position, for t from 0 to 1.
template <class At>
std::vector<AxisValues> chords_of(const AxisValues& start, const At& at) {
  std::vector<AxisValues> ends;
  const auto take = [&](const AxisValues& end) {
    if (end != (ends.empty() ? start : ends.back())) ends.push_back(end);
  };
  CurveChords(at, take).run(0.0, 1.0);
  return ends;
}

// The state stands at the last end afterwards. `commanded`: bits of the axes that the curve moves.
void emit_chords(std::span<const AxisValues> ends, std::uint16_t commanded, const BlockRules& rules, ModalState& state,
                 MotionBuffer& out, BlockResult& result);

}  // namespace dripfeed::interpreter
