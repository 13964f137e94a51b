// A range that surely holds the second derivative of an expression over a range of its variable, by interval
// arithmetic: what chord bounds of the nominal are proved from.
#pragma once

#include <span>

#include "dialects/curves/point.h"
#include "dialects/ir/program.h"

namespace dripfeed::family {

// Range of d²(expression)/d(by)² while `by` runs over `range` and every other symbol has its value. Infinite where
// nothing can be said (a division by a range that holds zero, a function without a rule). Angles are degrees.
curves::Range second_derivative(const ir::Program& arena, ir::ExpressionId expression, std::span<const double> values,
                                ir::SymbolId by, curves::Range range);

// Both derivatives, likewise.
struct DerivativeRanges {
  curves::Range first;
  curves::Range second;
};
DerivativeRanges derivatives(const ir::Program& arena, ir::ExpressionId expression, std::span<const double> values,
                             ir::SymbolId by, curves::Range range);

}  // namespace dripfeed::family
