// Single turning cycles as motions: each block with a position is one pass, four moves around a rectangle (or, with R,
// a trapezoid) back to where it began.
#pragma once

#include "dialects/interpreter/apply.h"

namespace dripfeed::interpreter {

void turn_once(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
               BlockResult& result);

}  // namespace dripfeed::interpreter
