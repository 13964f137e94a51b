// A statement with other expressions: the old one and its arenas stay, so that who compares can see what was changed.
#pragma once

#include "dialects/optimize/expressions.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::optimize {

// Calls `change` for each expression of statement `index` whose value is a number that nothing but the number counts
// of: right sides, conditions, and words of positions, centers, radii and feeds. Keeps the statement in `out` where
// none of them changes, otherwise emits its like. Whether it did.
using ChangeExpression = std::function<ir::ExpressionId(ir::ExpressionId)>;
bool keep_with(ir::Program& program, std::uint32_t index, passes::Rewrite& out, const ChangeExpression& change);

// The same expressions, looked at.
void for_each_changeable(const ir::Program& program, const ir::Statement& statement,
                         const std::function<void(ir::ExpressionId)>& visit);

// Whether the address takes a number that may be written with a point.
bool takes_any_number(ir::Address address);

}  // namespace dripfeed::optimize
