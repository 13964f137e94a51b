// Data of the control that outlives a program and is shared by all of them (GUD), as long as no one knows its
// definition: here each program would get a number of its own for it.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/macro_b/writer/place_globals.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// Errors at their places, for global data that no definition file declares: what is read before the program sets it, or
// what a program which calls or is called has in common with others. What one program by itself sets first is a
// variable like any other.
std::vector<text::Diagnostic> refuse_global_data(const ir::Program& program, const PlacedGlobals& placed,
                                                 const ir::Control& to);

}  // namespace dripfeed::macro_b
