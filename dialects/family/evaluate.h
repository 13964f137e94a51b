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

// Operators of families alone, beyond those of controls. interpolate(xs, ys, x) is kAlong(x, kPoints(xs, ys)), the
// lists as variables without an index. Straight between neighbouring points; before the first and after the last point
// its value. A program that was built has none of them.
constexpr ir::Operator own_operator(std::uint8_t row) {
  return static_cast<ir::Operator>(static_cast<std::uint8_t>(ir::Operator::count_) + 1U + row);
}
inline constexpr ir::Operator kAlong = own_operator(0);
inline constexpr ir::Operator kPoints = own_operator(1);

// The lists of a kAlong.
struct PointLists {
  ir::SymbolId x = ir::SymbolId::none;
  ir::SymbolId y = ir::SymbolId::none;
};
PointLists points_of(const ir::Program& arena, const ir::Expression& along);

// The numbers of a list in `values`. They lie after those of the symbols: at the list's symbol stands where the first
// is, and one before that how many there are.
std::span<const double> list_in(std::span<const double> values, ir::SymbolId list);

// `values` has one number a symbol of `arena`, and those of the lists. The slope is by the symbol `by` (none: 0). Not
// finite where the expression is not defined; conditions are 1 or 0.
Dual evaluate(const ir::Program& arena, ir::ExpressionId expression, std::span<const double> values,
              ir::SymbolId by = ir::SymbolId::none);

// A name's value, or that of a list's number; not finite where the index is none of the list's.
double value_of(const ir::Program& arena, const ir::Variable& variable, std::span<const double> values);

// Whether the expression names the symbol.
bool names(const ir::Program& arena, ir::ExpressionId expression, ir::SymbolId symbol);

// How often the expression, taken as a tree, names the symbol.
std::uint32_t uses_of(const ir::Program& arena, ir::ExpressionId expression, ir::SymbolId symbol);

// Whether it interpolates at points that depend on the symbol.
bool interpolates_by(const ir::Program& arena, ir::ExpressionId expression, ir::SymbolId symbol);

// The first node in evaluation order whose operands are finite and whose value is not; none when there is none.
ir::ExpressionId first_undefined(const ir::Program& arena, ir::ExpressionId expression, std::span<const double> values);

// Whether the expression names a symbol for which `is_known` (one entry a symbol) is false.
bool names_unknown(const ir::Program& arena, ir::ExpressionId expression, std::span<const std::uint8_t> is_known);

}  // namespace dripfeed::family
