// Increments that come next after a change of the programmable frame: setting data of a SINUMERIK decides whether they
// take the change along (SD42440 FRAME_OFFSET_INCR_PROG; PG, "Incremental dimensions"), the other controls do not.
#pragma once

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::passes {

//   G52 X5.                TRANS X5
//   G91 G01 X1. Y1.        G91 G1 X=AC(6.) Y1.      from X10.
//   X2.                    X2.
//
// The first increment of an axis whose shift (G52) has changed becomes the position that it leads to, where that is
// known: numbers alone, on a mill, in the text's order from the change to the increment. Others stay as they are.
void place_shifted_increments(ir::Program& program, const ir::Control& from, const ir::Control& to);

}  // namespace dripfeed::passes
