// ASPLINE, BSPLINE, CSPLINE: a spline goes over several blocks, and its path in one of them depends on blocks that come
// later. Each block's straight move stands in the buffer until the curve is known, and is then replaced by the chords
// of its piece.
#pragma once

#include "dialects/interpreter/motion/move.h"
#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

// A block under a spline code. Fault curve_invalid: a weight or degree that no control has.
void move_along_spline(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options,
                       const Target& target, ModalState& state, MotionBuffer& out, BlockResult& result);
// After each block while a spline is active: whether it has ended.
void follow_spline(const BlockRules& rules, ModalState& state, MotionBuffer& out);
// Nothing comes after it.
void end_spline(const BlockRules& rules, ModalState& state, MotionBuffer& out);

}  // namespace dripfeed::interpreter
