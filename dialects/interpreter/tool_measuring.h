// G37, and G36, G37 of lathes: the tool goes until it touches, and the control corrects its length in the memory.
#pragma once

#include "dialects/interpreter/apply.h"

namespace dripfeed::interpreter {

// The way to where the touch is expected, or to the touch where it is known. Behind it neither the place of the axis
// nor the lengths of tools are known.
void measure_tool(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                  BlockResult& result);

}  // namespace dripfeed::interpreter
