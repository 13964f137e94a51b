// Moves to places of the machine (G53, SUPA): by G0 both mean the same. G53 goes at rapid whatever is in effect and is
// left out beside G91 (Fanuc, "Machine coordinate system"), SUPA goes as programmed (PG, "Deselecting frames").
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// An error for each block of them that the other control would carry out otherwise, a warning where that is not known.
std::vector<text::Diagnostic> unlike_machine_moves(const ir::Program& program, const ir::Control& from,
                                                   const ir::Control& to);

}  // namespace dripfeed::compile
