// raise: expressions that the control cannot take as they are: operators that it lacks, functions that answer in
// another range, comparisons with a tolerance, brackets nested too deep. What needs a value of its own is computed in
// variables before the statement; they are of bank `named` and get their numbers later.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/macro_b/tables/grammar.h"
#include "dialects/passes/labels.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// To be run after lower_counted_loops and before lower_conditions. A WHILE whose condition needs such a variable
// becomes an endless loop that a jump leaves.
std::vector<text::Diagnostic> flatten_expressions(ir::Program& program, const ir::Control& from, const ir::Control& to,
                                                  const Grammar& grammar, passes::FreeNumbers& numbers);

}  // namespace dripfeed::macro_b
