// What a person reads at the control: no operation that changes nothing, no variable that a number can stand for.
#include "dialects/family/value_writer.h"

#include <cmath>

#include "dialects/family/evaluate.h"

namespace dripfeed::family {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

bool chooses(Operator op) { return op == Operator::minimum || op == Operator::maximum; }
bool takes_statements(Operator op) { return chooses(op) || op == kAlong; }

// The value where people would write it: with four decimals at most.
std::optional<double> folded(Operator op, double a, double b) {
  constexpr double kRaster = 1e4;
  double value = 0.0;
  if (op == Operator::add) {
    value = a + b;
  } else if (op == Operator::subtract) {
    value = a - b;
  } else if (op == Operator::multiply) {
    value = a * b;
  } else if (op == Operator::divide && b != 0.0) {
    value = a / b;
  } else {
    return std::nullopt;
  }
  return std::round(value * kRaster) / kRaster == value ? std::optional(value) : std::nullopt;
}

}  // namespace

ExpressionId ValueWriter::copy(ExpressionId id) {
  const ir::Expression& e = family_.arena.at(id);
  if (e.op == Operator::constant) return program_.add_constant(e.value, e.span);
  if (e.op == Operator::variable) return copy_variable(family_.arena.at(e.variable));
  if (e.op == kAlong) return interpolate(e);
  const ExpressionId a = copy(e.a);
  if (e.op == Operator::negate) return negated(a);
  if (ir::operand_count(e.op) == 1) return program_.add_operator(e.op, a, ExpressionId::none, e.span);
  const ExpressionId b = copy(e.b);
  return chooses(e.op) ? choose(e.op, a, b) : calculate(e.op, a, b);
}

ExpressionId ValueWriter::copy_variable(const ir::Variable& v) {
  if (names_.is_fixed(v.symbol)) return emit_.constant(names_.value_of(v.symbol));
  if (v.index == ExpressionId::none) return emit_.variable(v.symbol);
  if (names_.is_decided(v.index))
    return emit_.variable(v.symbol, whole(evaluate(family_.arena, v.index, names_.values()).value));
  return emit_.variable(v.symbol, copy(v.index));
}

ExpressionId ValueWriter::choose(Operator op, ExpressionId a, ExpressionId b) {
  const ir::SymbolId chosen = emit_.new_symbol("chosen");
  const ir::SymbolId other = emit_.new_symbol("other");
  emit_.assign(chosen, a);
  emit_.assign(other, b);
  emit_.open(StatementKind::if_begin, emit_.binary(op == Operator::minimum ? Operator::less : Operator::greater,
                                                   emit_.variable(other), emit_.variable(chosen)));
  emit_.assign(chosen, emit_.variable(other));
  emit_.close(StatementKind::if_end);
  return emit_.variable(chosen);
}

// place = x, within the points; point = 1; while there is a next one and xs[point] < place: point = point + 1. The
// value lies between point - 1 and point.
ExpressionId ValueWriter::interpolate(const ir::Expression& along) {
  const PointLists lists = points_of(family_.arena, along);
  const auto last = static_cast<double>(list_in(names_.values(), lists.x).size() - 1);
  const ExpressionId x = copy(along.a);
  const ir::SymbolId place = emit_.new_symbol("place");
  const ir::SymbolId point = emit_.new_symbol("point");
  emit_.assign(place, x);
  limit(place, Operator::less, lists.x, 0.0);
  limit(place, Operator::greater, lists.x, last);
  emit_.assign(point, emit_.constant(1.0));
  const auto at = [&](ir::SymbolId list) { return emit_.variable(list, emit_.variable(point)); };
  const auto before = [&](ir::SymbolId list) {
    return emit_.variable(list, emit_.binary(Operator::subtract, emit_.variable(point), whole(1.0)));
  };
  emit_.open(
      StatementKind::while_begin,
      emit_.binary(Operator::logic_and, emit_.binary(Operator::less, emit_.variable(point), emit_.constant(last)),
                   emit_.binary(Operator::less, at(lists.x), emit_.variable(place))));
  emit_.assign(point, emit_.binary(Operator::add, emit_.variable(point), emit_.constant(1.0)));
  emit_.close(StatementKind::while_end);
  const ExpressionId offset = emit_.binary(Operator::subtract, emit_.variable(place), before(lists.x));
  const ExpressionId rise = emit_.binary(Operator::subtract, at(lists.y), before(lists.y));
  const ExpressionId run = emit_.binary(Operator::subtract, at(lists.x), before(lists.x));
  const ir::SymbolId value = emit_.new_symbol("between");
  const ExpressionId gained = emit_.binary(Operator::divide, emit_.binary(Operator::multiply, offset, rise), run);
  emit_.assign(value, emit_.binary(Operator::add, before(lists.y), gained));
  return emit_.variable(value);
}

void ValueWriter::limit(ir::SymbolId value, Operator beyond, ir::SymbolId list, double index) {
  const auto end = [&] { return emit_.variable(list, whole(index)); };
  emit_.open(StatementKind::if_begin, emit_.binary(beyond, emit_.variable(value), end()));
  emit_.assign(value, end());
  emit_.close(StatementKind::if_end);
}

bool ValueWriter::needs_statements(ExpressionId id) const {
  const ir::Expression& e = family_.arena.at(id);
  if (takes_statements(e.op)) return true;
  const int operands = ir::operand_count(e.op);
  if (operands > 0) return needs_statements(e.a) || (operands > 1 && needs_statements(e.b));
  if (e.op != Operator::variable) return false;
  const ExpressionId index = family_.arena.at(e.variable).index;
  return index != ExpressionId::none && needs_statements(index);
}

// The larger or smaller of two is found in the target itself, where the value does not name it: the target takes the
// one that is computed and is then compared with the other.
void ValueWriter::assign(ir::SymbolId target, ExpressionId id) {
  const ir::Expression e = family_.arena.at(id);
  if (!chooses(e.op) || names(family_.arena, id, target)) return emit_.assign(target, copy(id));
  const bool a_is_number = names_.is_decided(e.a);
  emit_.assign(target, copy(a_is_number ? e.b : e.a));
  const Bound other = bound(a_is_number ? e.a : e.b, "other");
  emit_.open(StatementKind::if_begin, emit_.binary(e.op == Operator::minimum ? Operator::greater : Operator::less,
                                                   emit_.variable(target), say(other)));
  emit_.assign(target, say(other));
  emit_.close(StatementKind::if_end);
}

std::optional<double> ValueWriter::number(ExpressionId id) const {
  const ir::Expression& e = program_.at(id);
  return e.op == Operator::constant ? std::optional(e.value) : std::nullopt;
}

ExpressionId ValueWriter::calculate(Operator op, ExpressionId a, ExpressionId b) {
  const std::optional<double> left = number(a);
  const std::optional<double> right = number(b);
  if (op == Operator::add && left == 0.0) return b;
  if ((op == Operator::add || op == Operator::subtract) && right == 0.0) return a;
  if (op == Operator::multiply && left == 1.0) return b;
  if ((op == Operator::multiply || op == Operator::divide) && right == 1.0) return a;
  if (left && right) {
    if (const std::optional<double> value = folded(op, *left, *right)) return emit_.constant(*value);
  }
  const std::optional<ExpressionId> of_a = negative(a);
  const std::optional<ExpressionId> of_b = negative(b);
  if (op == Operator::multiply || op == Operator::divide) {
    if (op == Operator::multiply && (left == -1.0 || right == -1.0)) return negated(left == -1.0 ? b : a);
    if (of_a && !left) return negated(calculate(op, *of_a, b));
    if (of_b) return negated(calculate(op, a, *of_b));
  }
  if (op == Operator::add && of_b) return calculate(Operator::subtract, a, *of_b);
  if (op == Operator::add && of_a && !left) return calculate(Operator::subtract, b, *of_a);
  if (op == Operator::subtract && of_b) return calculate(Operator::add, a, *of_b);
  return emit_.binary(op, a, b);
}

ExpressionId ValueWriter::negated(ExpressionId id) {
  if (const std::optional<ExpressionId> of = negative(id)) return *of;
  if (const std::optional<double> value = number(id)) return emit_.constant(-*value);
  return program_.add_operator(Operator::negate, id, ExpressionId::none, program_.at(id).span);
}

std::optional<ExpressionId> ValueWriter::negative(ExpressionId id) {
  const ir::Expression& e = program_.at(id);
  if (e.op == Operator::negate) return e.a;
  if (e.op == Operator::constant && e.value < 0.0) return emit_.constant(-e.value);
  return std::nullopt;
}

ValueWriter::Bound ValueWriter::bound(ExpressionId id, std::string_view stem) {
  const ir::Expression& e = family_.arena.at(id);
  if (e.op == Operator::constant) return {.value = e.value};
  if (e.op == Operator::variable) {
    const ir::Variable& v = family_.arena.at(e.variable);
    if (names_.is_fixed(v.symbol)) return {.value = names_.value_of(v.symbol)};
    if (v.index == ExpressionId::none && !names_.is_set(v.symbol)) return {.symbol = v.symbol};
    if (v.index != ExpressionId::none && !names_.is_set(v.symbol) && names_.is_decided(v.index))
      return {.symbol = v.symbol, .value = evaluate(family_.arena, v.index, names_.values()).value, .is_of_list = true};
  }
  const ExpressionId value = copy(id);
  if (const std::optional<double> known = number(value)) return {.value = *known};
  const Bound out{.symbol = emit_.new_symbol(stem)};
  emit_.assign(out.symbol, value);
  return out;
}

ExpressionId ValueWriter::say(const Bound& bound) {
  if (bound.symbol == ir::SymbolId::none) return emit_.constant(bound.value);
  return bound.is_of_list ? emit_.variable(bound.symbol, whole(bound.value)) : emit_.variable(bound.symbol);
}

}  // namespace dripfeed::family
