// The block that long programs consist of: a straight cut after a straight cut, coordinates and a feed. `apply` makes
// the same of it, but asks for everything that a block may have besides. Here one question finds out that there is none
// of it.
#pragma once

#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

// Whether the block names nothing but coordinates and a feed, and nothing is in effect that makes more of it than a
// line.
bool is_straight_cut(const PlainBlock& block, const BlockRules& rules, const ModalState& state);
// Carries out such a block: one motion. Gives the notes that it deserves, as BlockResult::notes.
std::uint64_t cut_straight(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out);

}  // namespace dripfeed::interpreter
