// What a macro was passed, by the names that SINUMERIK has for it ($C_X and $C_X_PROG): here it lies in local
// variables.
#pragma once

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::macro_b {

// $C_X is #24+0, since what was not passed is 0 there; $C_X_PROG==0 is #24 EQ #0. Only in a program that is called:
// elsewhere, and where $C_X_PROG is more than a condition, they stay.
void raise_passed(ir::Program& program, const ir::Control& from);

}  // namespace dripfeed::macro_b
