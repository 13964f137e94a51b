// What an expression is worth as far as it can be seen from its form: for passes that may leave a rounding or a test
// out.
#pragma once

#include "dialects/ir/program.h"

namespace dripfeed::passes {

// Surely 0 or more. False where it is not known.
bool never_negative(const ir::Program& program, ir::ExpressionId id);

// Surely a whole number. Variables count where their type says so (INT, BOOL), so what is set must be converted.
bool is_whole(const ir::Program& program, ir::ExpressionId id);

}  // namespace dripfeed::passes
