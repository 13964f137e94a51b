// Calls without arguments of programs that have parameters.
#pragma once

#include "dialects/compile/dialect/library.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// A program that has parameters starts each time with those that are given and none of the last call's: where they are
// local variables, a call without arguments must be a macro call, too. That a called program has some is known from
// this text (its head, or EXTERN) or from the library, which may be nullptr.
void call_parameters_as_macros(ir::Program& text, ProgramLibrary* library);

}  // namespace dripfeed::compile
