// M99 of a main program, which begins it again, and M99 P100 there, which is a jump: said as jumps, for controls whose
// M99 is only a return. A main program is one that has an end of its own (M30).
#pragma once

#include "dialects/ir/program.h"
#include "dialects/passes/flow_graph.h"

namespace dripfeed::passes {

void returns_of_main_as_jumps(ir::Program& program);
// A program that returns and has no end of its own; `range`: one of a text's.
bool is_subprogram(const ir::Program& program);
bool is_subprogram(const ir::Program& program, const StatementRange& range);

}  // namespace dripfeed::passes
