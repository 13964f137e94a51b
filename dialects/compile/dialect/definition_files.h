// What a control's definition files declare (GUD), put at the head of a program, as if it stood in it.
#pragma once

#include "dialects/compile/dialect/library.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// One `define` statement of line 0 for each definition of a file, in their order, with an initial value for each symbol
// that is a number; an array whose elements differ has an assignment of line 0 for each element that was given. What
// is initialised with something that is calculated is left out: its value is not known here. The program's own
// variables keep their symbols.
void add_definitions(ir::Program& program, const ir::Control& control, ProgramLibrary& library);

}  // namespace dripfeed::compile
