// raise: comparisons of a control that compares with a tolerance, for one that compares exactly.
#pragma once

#include "dialects/ir/program.h"

namespace dripfeed::macro_b {

// The comparison `e` with its tolerance written out; unchanged when both sides are whole numbers.
ir::ExpressionId tolerant_comparison(ir::Program& program, const ir::Expression& e);

}  // namespace dripfeed::macro_b
