// Where a translation depends on a mode that the block does not say: known on all paths, it is stated in the block; not
// known, it is an error that names the paths. What only the order of the text would suggest is never taken.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

// For a translation statement by statement. Blocks get a code of the mode where following the text from the control's
// power-on state would find another one than the paths that lead there.
std::vector<text::Diagnostic> make_modes_explicit(ir::Program& program, const ir::Control& from, const ir::Control& to);

// For running a program by itself: what it takes from a caller that is not there and what is then taken instead, as
// warnings. Words of the spindle that would be lost, because only the caller knows its direction, are errors.
std::vector<text::Diagnostic> assumed_modes(const ir::Program& program, const ir::Control& control);

}  // namespace dripfeed::passes
