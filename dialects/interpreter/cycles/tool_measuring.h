// G37, and G36, G37 of lathes: the tool goes until it touches, and the control corrects its length in the memory.
#pragma once

#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

// The move to where the touch is expected, or to the touch where it is known. After it neither the position of the axis
// nor the lengths of tools are known.
void measure_tool(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                  BlockResult& result);

}  // namespace dripfeed::interpreter
