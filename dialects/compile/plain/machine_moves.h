// Moves to machine positions (G53, SUPA): absolute and by G0 they mean the same on all controls, other ones do not
// (ir::MachineMove).
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
