// What changes the programmable frame and the coordinates: shifts, rotations, scales, mirrors and set positions.
#pragma once

#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/ir/function.h"

namespace dripfeed::interpreter {

// G52, TRANS. `whole`: axes that are not named lose their shift. `add`: ATRANS.
void shift_locally(const PlainBlock& block, const BlockRules& rules, bool whole, bool add, ModalState& state);
// G58 and, `fine`, G59.
void shift_axes(const PlainBlock& block, const BlockRules& rules, bool fine, ModalState& state);
// ROT, SCALE, MIRROR. `replace`: in the place of the whole programmable frame; otherwise on top of it.
void change_frame(const PlainBlock& block, const BlockRules& rules, ir::Function function, bool replace,
                  ModalState& state);
// The frame was `before`: increments along the axes that it changes depend on setting data until each is programmed
// absolutely, where the control has such a datum (SINUMERIK, SD42440; PG, "Incremental dimensions").
void mark_shifted(const Modes& before, const BlockRules& rules, ModalState& state);
// G92: the current position gets the named values. `takes_back`: G92.1, the named axes lose such shifts and G52's.
void set_coordinates(const PlainBlock& block, const BlockRules& rules, bool takes_back, ModalState& state);

}  // namespace dripfeed::interpreter
