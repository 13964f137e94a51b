// Equality becomes nearness; the others move their bound.
#include "dialects/macro_b/writer/tolerance.h"

#include "dialects/passes/value_facts.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Operator;

// Values that differ by less are equal on a control that compares with a tolerance of 1e-12 of the value; far below
// what any axis resolves.
constexpr double kEqualWithin = 1e-7;

}  // namespace

ir::ExpressionId tolerant_comparison(ir::Program& program, const ir::Expression& e) {
  // An empty value equals only itself, and whole numbers compare alike everywhere.
  const bool empty = program.at(e.a).op == Operator::vacant || program.at(e.b).op == Operator::vacant;
  if (empty || (passes::is_whole(program, e.a) && passes::is_whole(program, e.b))) return program.add(e);
  const ExpressionId within_this = program.add_constant(kEqualWithin);
  const auto moved = [&](Operator op, Operator by) {
    const ir::Expression& bound = program.at(e.b);
    const double signed_width = by == Operator::add ? kEqualWithin : -kEqualWithin;
    const ExpressionId b = bound.op == Operator::constant ? program.add_constant(bound.value + signed_width, bound.span)
                                                          : program.add_operator(by, e.b, within_this);
    return program.add_operator(op, e.a, b, e.span);
  };
  const auto apart = [&](Operator op) {
    const ExpressionId difference = program.add_operator(Operator::subtract, e.a, e.b);
    return program.add_operator(op, program.add_operator(Operator::abs, difference), within_this, e.span);
  };
  if (e.op == Operator::equal) return apart(Operator::less);
  if (e.op == Operator::not_equal) return apart(Operator::greater_equal);
  if (e.op == Operator::less) return moved(Operator::less, Operator::subtract);
  if (e.op == Operator::less_equal) return moved(Operator::less_equal, Operator::add);
  if (e.op == Operator::greater) return moved(Operator::greater, Operator::add);
  return moved(Operator::greater_equal, Operator::subtract);
}

}  // namespace dripfeed::macro_b
