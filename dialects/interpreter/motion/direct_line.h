// Direct drawing input: straight moves of which an angle stands for a coordinate (,A).
#pragma once

#include "dialects/interpreter/motion/move.h"

namespace dripfeed::interpreter {

// Whether the block has an angle, or one of the block before waits for it.
bool is_direct_line(const PlainBlock& block, const ModalState& state);
// Carries out such a block. What cannot be computed leaves the axes of the plane unknown, and a note.
void move_direct(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
                 MotionBuffer& out, BlockResult& result);

}  // namespace dripfeed::interpreter
