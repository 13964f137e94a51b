// What an operator gives where an operand is a number that makes it plain, and what it gives on numbers alone. Exact:
// the value is the same to the last bit, for all operands.
#pragma once

#include "dialects/interpreter/arithmetic/arithmetic.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::optimize {

// The node, or a simpler one; its operands are simple already. Never drops what may be an alarm, and never makes a
// variable that may be vacant of what is a number.
ir::ExpressionId simplified(ir::Program& program, const ir::Control& control, const interpreter::Arithmetic& arithmetic,
                            ir::ExpressionId id);

// Whether every control writes the number whole, in a word as well: at most four decimals, and eight digits in all.
bool can_be_written(const ir::Control& control, double value);

}  // namespace dripfeed::optimize
