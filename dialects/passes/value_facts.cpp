// One walk down each expression.
#include "dialects/passes/value_facts.h"

#include <cmath>

namespace dripfeed::passes {

using ir::ExpressionId;
using ir::Operator;

bool never_negative(const ir::Program& program, ExpressionId id) {
  const ir::Expression& e = program.at(id);
  if (e.op == Operator::constant) return e.value >= 0.0;
  if (e.op == Operator::abs || e.op == Operator::sqrt || e.op == Operator::square || e.op == Operator::exp) return true;
  const bool keeps = e.op == Operator::add || e.op == Operator::multiply || e.op == Operator::divide;
  return keeps && never_negative(program, e.a) && never_negative(program, e.b);
}

bool is_whole(const ir::Program& program, ExpressionId id) {
  const ir::Expression& e = program.at(id);
  if (e.op == Operator::constant) return e.value == std::floor(e.value);
  if (e.op == Operator::truncate || e.op == Operator::round || e.op == Operator::round_up) return true;
  if (e.op == Operator::variable) {
    const ir::Variable& v = program.at(e.variable);
    if (v.bank != ir::Bank::named || v.symbol == ir::SymbolId::none) return false;
    const ir::ValueType type = program.at(v.symbol).type;
    return type == ir::ValueType::integer || type == ir::ValueType::boolean;
  }
  const bool keeps = e.op == Operator::add || e.op == Operator::subtract || e.op == Operator::multiply ||
                     e.op == Operator::negate || e.op == Operator::modulo;
  return keeps && is_whole(program, e.a) && (e.b == ExpressionId::none || is_whole(program, e.b));
}

}  // namespace dripfeed::passes
