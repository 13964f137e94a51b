// Moves of a block: straight moves, arcs and threads to where its axis words lead.
// Codes have taken effect before; nothing here changes a mode.
#pragma once

#include "dialects/interpreter/motion/target.h"
#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

struct MoveOptions {
  bool machine_coordinates = false;          // G53
  bool exact_stop = false;                   // G09
  ir::Function motion = ir::Function::none;  // of this block alone (G63)
};

// One motion to the target; the state is there afterwards.
ir::Motion& emit_move(ir::MotionKind kind, const Target& target, double feed, const MoveOptions& options,
                      ModalState& state, MotionBuffer& out, BlockResult& result);

// Carries out the block's axis words (and I J K of an arc) by the active motion code.
void move(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
          MotionBuffer& out, BlockResult& result);
// The touch of any commanded axis ends the path of all.
void end_at_touch(Target& target, const ModalState& state);
// G31: a straight move that ends where the probe is known to touch.
void move_until_touch(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                      BlockResult& result);
// G28: a rapid to the intermediate point that the words name; the reference point itself is not known.
void return_to_reference(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                         BlockResult& result);
// G29: by rapid through the intermediate point of the last G28 or G30, then to the end point.
void leave_reference(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                     BlockResult& result);
// The axes that the block names may be anywhere after it.
void forget_positions(const PlainBlock& block, const BlockRules& rules, ModalState& state);

// What every motion says of the state: plane, feed mode, spindle, compensation, coolant, position.
void fill_common(ir::Motion& motion, const ModalState& state);

}  // namespace dripfeed::interpreter
