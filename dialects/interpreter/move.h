// Moves of a block: where its axis words lead under the modal state, and straight moves, arcs and threads to there.
// Codes have taken effect before; nothing here changes a mode.
#pragma once

#include "dialects/interpreter/apply.h"

namespace dripfeed::interpreter {

struct MoveOptions {
  bool machine_coordinates = false;          // G53
  bool exact_stop = false;                   // G09
  ir::Function motion = ir::Function::none;  // of this block alone (G63)
};

// Carries out the block's axis words (and I J K of an arc) by the active motion code.
void move(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
          MotionBuffer& out, BlockResult& result);
// G28: a rapid to the intermediate point that the words name; the reference point itself is not known.
void return_to_reference(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                         BlockResult& result);
// G52, TRANS. `whole`: axes that are not named lose their shift. `add`: ATRANS.
void shift_locally(const PlainBlock& block, const BlockRules& rules, bool whole, bool add, ModalState& state);
// ROT, SCALE, MIRROR. `replace`: in the place of the whole programmable frame; otherwise on top of it.
void change_frame(const PlainBlock& block, const BlockRules& rules, ir::Function function, bool replace,
                  ModalState& state);
// G92: the current position gets the named values.
void set_coordinates(const PlainBlock& block, const BlockRules& rules, ModalState& state);

// The axes that the block names may be anywhere after it.
void forget_positions(const PlainBlock& block, const BlockRules& rules, ModalState& state);

// What every motion says of the state: plane, feed mode, spindle, compensation, coolant, position.
void fill_common(ir::Motion& motion, const ModalState& state);

}  // namespace dripfeed::interpreter
