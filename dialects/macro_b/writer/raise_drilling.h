// raise: drilling cycles that are called (MCALL CYCLE81(…) and single calls, HOLES1 and HOLES2 between them) as the
// modal cycles of these controls where those do the same, otherwise as the moves that they make.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// Changes `program`, which is still in the terms of `from`; what cannot be written is reported at its place.
std::vector<text::Diagnostic> raise_drilling(ir::Program& program, const ir::Control& from, const ir::Control& to);

}  // namespace dripfeed::macro_b
