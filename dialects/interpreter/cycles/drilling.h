// Modal drilling cycles as motions: each block with a position, a depth or an R level makes a hole, or several. The
// words of a cycle stay in ModalState::drilling until it ends.
#pragma once

#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

// A drilling code; `argument` as Function::drill has it. Keeps the words of the cycle before it.
void begin_drilling(std::int16_t argument, ModalState& state);
// Carries out the block under the active cycle: takes its words, then drills where it says so. `letters`: the block as
// written where its letters are a radius and an angle (G16), which each repetition adds again; otherwise nullptr.
void drill_holes(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                 BlockResult& result, const PlainBlock* letters = nullptr);

}  // namespace dripfeed::interpreter
