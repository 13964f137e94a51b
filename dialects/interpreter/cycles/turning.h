// Single turning cycles as motions: each block with a position is one pass, four moves around a rectangle (or, with R,
// a trapezoid) back to where it began.
#pragma once

#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

void turn_once(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
               BlockResult& result);

}  // namespace dripfeed::interpreter
