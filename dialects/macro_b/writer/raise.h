// raise: any program to one that a '#'-variable control takes. The steps, in order: labels get numbers, counted loops
// become WHILE, expressions are made legal, blocks are stated in the control's codes, conditions and nesting are
// brought to what it has, and variables get numbers.
#pragma once

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::macro_b {

ir::RaiseResult raise(const ir::Program& program, const ir::Control& from, const ir::Control& to,
                      const Grammar& grammar);

}  // namespace dripfeed::macro_b
