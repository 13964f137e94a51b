// M99 of a main program, which begins it again, and M99 P100 there, which is a jump: said as jumps, for controls whose
// M99 is only a return. A main program is one that has an end of its own (M30).
#pragma once

#include "dialects/ir/program.h"

namespace dripfeed::passes {

void returns_of_main_as_jumps(ir::Program& program);

}  // namespace dripfeed::passes
