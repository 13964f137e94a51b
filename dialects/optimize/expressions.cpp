// One recursion each; trees are as deep as a control lets them be nested.
#include "dialects/optimize/expressions.h"

#include <algorithm>

#include "dialects/passes/walk.h"
#include "dialects/text/number.h"

namespace dripfeed::optimize {

namespace {

using ir::ExpressionId;
using ir::Operator;

bool is_function(Operator op) {
  return (op >= Operator::sin && op <= Operator::bin) || op == Operator::atan2 || op == Operator::power ||
         op == Operator::minimum || op == Operator::maximum || op == Operator::bound;
}

bool gives_number(Operator op) {
  return op == Operator::constant || op == Operator::variable || op == Operator::negate ||
         (op >= Operator::logic_not && op <= Operator::bin) || (op >= Operator::add && op <= Operator::greater_equal) ||
         is_function(op);
}

// For all finite operands a number comes out, but for what is too large.
bool is_total(Operator op) {
  switch (op) {
    case Operator::constant:
    case Operator::variable:
    case Operator::negate:
    case Operator::sin:
    case Operator::cos:
    case Operator::square:
    case Operator::abs:
    case Operator::round:
    case Operator::truncate:
    case Operator::round_up:
    case Operator::add:
    case Operator::subtract:
    case Operator::multiply: return true;
    default: return op >= Operator::equal && op <= Operator::greater_equal;
  }
}

bool divides_by_constant(const ir::Program& program, const ir::Expression& e) {
  return e.op == Operator::divide && program.at(e.b).op == Operator::constant && program.at(e.b).value != 0.0;
}

template <class Test>
bool all_nodes(const ir::Program& program, ExpressionId id, Test&& test) {
  bool all = true;
  passes::for_each_node(program, id, [&](ExpressionId node) { all = all && test(program.at(node)); });
  return all;
}

}  // namespace

Place place_at(const ir::Program& program, const Places& places, ExpressionId id) {
  const ir::Expression& e = program.at(id);
  return e.op == Operator::variable ? places.of(program.at(e.variable)) : kNoPlace;
}

bool may_fault(const ir::Program& program, ExpressionId id) {
  return !all_nodes(program, id,
                    [&](const ir::Expression& e) { return is_total(e.op) || divides_by_constant(program, e); });
}

bool is_pure(const ir::Program& program, const Places& places, ExpressionId id) {
  return all_nodes(program, id, [&](const ir::Expression& e) {
    if (e.op != Operator::variable) return gives_number(e.op);
    const Place place = places.of(program.at(e.variable));
    return place != kNoPlace && places.at(place).is_plain;
  });
}

bool is_number(const ir::Program& program, const ir::Control& control, ExpressionId id) {
  const Operator op = program.at(id).op;
  return !control.semantics.has_vacant || (op != Operator::variable && op != Operator::vacant);
}

bool mentions_vacant(const ir::Program& program, ExpressionId id) {
  return !all_nodes(program, id, [](const ir::Expression& e) { return e.op != Operator::vacant; });
}

void add_places(const ir::Program& program, const Places& places, ExpressionId id, std::vector<Place>& out) {
  passes::for_each_node(program, id, [&](ExpressionId node) {
    if (const Place place = place_at(program, places, node); place != kNoPlace) out.push_back(place);
  });
}

std::size_t count_of(const ir::Program& program, const Places& places, ExpressionId id, Place place) {
  std::size_t count = 0;
  passes::for_each_node(program, id, [&](ExpressionId node) {
    count += place_at(program, places, node) == place ? std::size_t{1} : std::size_t{0};
  });
  return count;
}

std::uint32_t depth_of(const ir::Program& program, ExpressionId id) {
  if (id == ExpressionId::none) return 0;
  const ir::Expression& e = program.at(id);
  if (e.op == Operator::constant || e.op == Operator::variable || e.op == Operator::vacant) return 0;
  return 1 + std::max({depth_of(program, e.a), depth_of(program, e.b), depth_of(program, e.c)});
}

std::uint32_t length_of(const ir::Program& program, ExpressionId id) {
  constexpr std::uint32_t kOperator = 4, kFunction = 7, kName = 5;
  if (id == ExpressionId::none) return 0;
  const ir::Expression& e = program.at(id);
  if (e.op == Operator::constant) return static_cast<std::uint32_t>(text::format_shortest(e.value).size()) + 1;
  if (e.op == Operator::variable) {
    const ir::Variable& v = program.at(e.variable);
    if (v.symbol == ir::SymbolId::none) return kName;
    return static_cast<std::uint32_t>(program.strings.at(program.at(v.symbol).name).size());
  }
  return (is_function(e.op) ? kFunction : kOperator) + length_of(program, e.a) + length_of(program, e.b) +
         length_of(program, e.c);
}

double read_cost(const ir::CostModel& model, const PlaceFacts& place) {
  return place.bank == ir::Bank::named ? model.named_read_ms : model.number_read_ms;
}

double cost_of(const ir::Program& program, const ir::CostModel& model, ExpressionId id) {
  double ms = 0.0;
  passes::for_each_node(program, id, [&](ExpressionId node) {
    const ir::Expression& e = program.at(node);
    if (e.op == Operator::variable) {
      const ir::Bank bank = program.at(e.variable).bank;
      ms += bank == ir::Bank::named || bank == ir::Bank::system ? model.named_read_ms : model.number_read_ms;
    } else if (is_function(e.op)) {
      ms += model.function_ms;
    } else if (e.op != Operator::constant) {
      ms += model.operator_ms;
    }
  });
  return ms;
}

ExpressionId rebuilt(ir::Program& program, ExpressionId id, const Replace& replace) {
  if (id == ExpressionId::none) return id;
  ir::Expression e = program.at(id);
  if (e.op != Operator::variable) {
    const ExpressionId a = rebuilt(program, e.a, replace);
    const ExpressionId b = rebuilt(program, e.b, replace);
    const ExpressionId c = rebuilt(program, e.c, replace);
    if (a != e.a || b != e.b || c != e.c) {
      e.a = a, e.b = b, e.c = c;
      id = program.add(e);
    }
  }
  return replace(id);
}

ir::VariableId variable_of(ir::Program& program, const PlaceFacts& place) {
  ir::Variable v;
  v.bank = place.bank;
  v.number = place.number;
  v.symbol = place.symbol;
  return program.add(v);
}

ExpressionId read_of(ir::Program& program, const PlaceFacts& place) {
  ir::Expression e;
  e.op = Operator::variable;
  e.variable = variable_of(program, place);
  return program.add(e);
}

}  // namespace dripfeed::optimize
