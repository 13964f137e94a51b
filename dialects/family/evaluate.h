// Values of a family's expressions, with the derivative by one variable where it is wanted. Angles are degrees. What a
// control does with the same expression is the interpreter's.
#pragma once

#include <cstdint>
#include <span>

#include "dialects/ir/program.h"

namespace dripfeed::family {

// A value and its derivative by the variable of the evaluation.
struct Dual {
  double value = 0.0;
  double slope = 0.0;
};

// What one operator does; nullptr: it is none of the family language.
using UnaryRule = Dual (*)(Dual a);
using BinaryRule = Dual (*)(Dual a, Dual b);
UnaryRule unary_rule(ir::Operator op);
BinaryRule binary_rule(ir::Operator op);

// `values` has one number a symbol of `arena`. The slope is by the symbol `by` (none: 0). Not finite where the
// expression is not defined; conditions are 1 or 0.
Dual evaluate(const ir::Program& arena, ir::ExpressionId expression, std::span<const double> values,
              ir::SymbolId by = ir::SymbolId::none);

// The first node in evaluation order whose operands are finite and whose value is not; none when there is none.
ir::ExpressionId first_undefined(const ir::Program& arena, ir::ExpressionId expression, std::span<const double> values);

// Whether the expression names a symbol for which `is_known` (one entry a symbol) is false.
bool names_unknown(const ir::Program& arena, ir::ExpressionId expression, std::span<const std::uint8_t> is_known);

}  // namespace dripfeed::family
