// Hole patterns: the drilling cycle in effect at each place of a circle, a line, an arc or a grid.
#pragma once

#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

// `figure` as ir/hole_pattern.h. The block names the figure; each hole is made as a block with its position would make
// it, and the cycle stays. Without a cycle the places are gone to by rapid moves, with a note. Fault
// hole_pattern_invalid: no holes, no angle between them, a word that the figure does not take.
void drill_pattern(const PlainBlock& block, const BlockRules& rules, std::int16_t figure, ModalState& state,
                   MotionBuffer& out, BlockResult& result);

}  // namespace dripfeed::interpreter
