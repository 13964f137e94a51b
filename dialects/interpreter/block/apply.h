// The one path on which a block takes effect: codes change the modal state, words are read under it, motions and events
// come out. Streams of plain blocks and the machine both use it, so that they cannot differ. Values are computed by the
// caller; calls, jumps and variables are unknown here.
#pragma once

#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

BlockResult apply(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out);

}  // namespace dripfeed::interpreter
