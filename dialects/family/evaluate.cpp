// Forward differentiation: every operator gives its value and, by the chain rule, its slope.
#include "dialects/family/evaluate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace dripfeed::family {

namespace {

using ir::Operator;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

double truth(bool b) { return b ? 1.0 : 0.0; }

// Quarter turns are exact, as controls have them: cos(90) is 0.
double sin_deg(double a) { return std::fmod(a, 180.0) == 0.0 ? 0.0 : std::sin(a * kDegree); }
double cos_deg(double a) { return std::fmod(std::abs(a), 180.0) == 90.0 ? 0.0 : std::cos(a * kDegree); }

Dual tangent(Dual a) {
  const double c = cos_deg(a.value);
  return c == 0.0 ? Dual{kUndefined} : Dual{sin_deg(a.value) / c, kDegree / (c * c) * a.slope};
}

Dual root(Dual a) {
  const double r = std::sqrt(a.value);
  return {r, r == 0.0 ? 0.0 : a.slope / (2.0 * r)};
}

Dual quotient(Dual a, Dual b) {
  if (b.value == 0.0) return {kUndefined};
  return {a.value / b.value, (a.slope * b.value - a.value * b.slope) / (b.value * b.value)};
}

Dual angle_of_legs(Dual a, Dual b) {
  const double square = a.value * a.value + b.value * b.value;
  return {std::atan2(a.value, b.value) / kDegree, (b.value * a.slope - a.value * b.slope) / square / kDegree};
}

// 1/sqrt(1 - a^2) in degrees: the slope of asin.
double arc_slope(Dual a) { return a.slope / std::sqrt(1.0 - a.value * a.value) / kDegree; }

struct UnaryRow {
  Operator op;
  Dual (*of)(Dual a);
};
constexpr auto kUnary = std::to_array<UnaryRow>({
    {Operator::negate, [](Dual a) { return Dual{-a.value, -a.slope}; }},
    {Operator::logic_not, [](Dual a) { return Dual{truth(a.value == 0.0)}; }},
    {Operator::sin, [](Dual a) { return Dual{sin_deg(a.value), cos_deg(a.value) * kDegree * a.slope}; }},
    {Operator::cos, [](Dual a) { return Dual{cos_deg(a.value), -sin_deg(a.value) * kDegree * a.slope}; }},
    {Operator::tan, tangent},
    {Operator::asin, [](Dual a) { return Dual{std::asin(a.value) / kDegree, arc_slope(a)}; }},
    {Operator::acos, [](Dual a) { return Dual{std::acos(a.value) / kDegree, -arc_slope(a)}; }},
    {Operator::atan,
     [](Dual a) { return Dual{std::atan(a.value) / kDegree, a.slope / (1.0 + a.value * a.value) / kDegree}; }},
    {Operator::sqrt, root},
    {Operator::abs, [](Dual a) { return Dual{std::abs(a.value), a.value < 0.0 ? -a.slope : a.slope}; }},
    {Operator::ln, [](Dual a) { return Dual{a.value > 0.0 ? std::log(a.value) : kUndefined, a.slope / a.value}; }},
    {Operator::exp, [](Dual a) { return Dual{std::exp(a.value), std::exp(a.value) * a.slope}; }},
    {Operator::round, [](Dual a) { return Dual{std::round(a.value)}; }},
    {Operator::truncate, [](Dual a) { return Dual{std::trunc(a.value)}; }},
});

struct BinaryRow {
  Operator op;
  Dual (*of)(Dual a, Dual b);
};
constexpr auto kBinary = std::to_array<BinaryRow>({
    {Operator::add, [](Dual a, Dual b) { return Dual{a.value + b.value, a.slope + b.slope}; }},
    {Operator::subtract, [](Dual a, Dual b) { return Dual{a.value - b.value, a.slope - b.slope}; }},
    {Operator::multiply, [](Dual a, Dual b) { return Dual{a.value * b.value, a.slope * b.value + a.value * b.slope}; }},
    {Operator::divide, quotient},
    {Operator::atan2, angle_of_legs},
    {Operator::minimum, [](Dual a, Dual b) { return b.value < a.value ? b : a; }},
    {Operator::maximum, [](Dual a, Dual b) { return b.value > a.value ? b : a; }},
    {Operator::logic_and, [](Dual a, Dual b) { return Dual{truth(a.value != 0.0 && b.value != 0.0)}; }},
    {Operator::logic_or, [](Dual a, Dual b) { return Dual{truth(a.value != 0.0 || b.value != 0.0)}; }},
    {Operator::equal, [](Dual a, Dual b) { return Dual{truth(a.value == b.value)}; }},
    {Operator::not_equal, [](Dual a, Dual b) { return Dual{truth(a.value != b.value)}; }},
    {Operator::less, [](Dual a, Dual b) { return Dual{truth(a.value < b.value)}; }},
    {Operator::less_equal, [](Dual a, Dual b) { return Dual{truth(a.value <= b.value)}; }},
    {Operator::greater, [](Dual a, Dual b) { return Dual{truth(a.value > b.value)}; }},
    {Operator::greater_equal, [](Dual a, Dual b) { return Dual{truth(a.value >= b.value)}; }},
});

// As ValueWriter has it computed.
Dual along(std::span<const double> xs, std::span<const double> ys, Dual x) {
  if (xs.size() < 2 || ys.size() != xs.size() || !(x.value == x.value)) return {kUndefined};
  if (x.value <= xs.front()) return {ys.front()};
  if (x.value >= xs.back()) return {ys.back()};
  std::size_t n = 1;
  while (n + 1 < xs.size() && xs[n] < x.value) ++n;
  const double slope = (ys[n] - ys[n - 1]) / (xs[n] - xs[n - 1]);
  return {ys[n - 1] + (x.value - xs[n - 1]) * slope, slope * x.slope};
}

Dual leaf(const ir::Program& arena, const ir::Expression& e, std::span<const double> values, ir::SymbolId by) {
  if (e.op == Operator::constant) return {e.value};
  if (e.op != Operator::variable) return {kUndefined};
  const ir::Variable& v = arena.at(e.variable);
  return {value_of(arena, v, values), truth(v.symbol == by)};
}

}  // namespace

std::span<const double> list_in(std::span<const double> values, ir::SymbolId list) {
  const auto first = static_cast<std::size_t>(values[static_cast<std::size_t>(list)]);
  return first == 0 ? std::span<const double>() : values.subspan(first, static_cast<std::size_t>(values[first - 1]));
}

double value_of(const ir::Program& arena, const ir::Variable& variable, std::span<const double> values) {
  if (variable.index == ir::ExpressionId::none) return values[static_cast<std::size_t>(variable.symbol)];
  const std::span<const double> list = list_in(values, variable.symbol);
  const double index = evaluate(arena, variable.index, values).value;
  const bool is_one = index >= 0.0 && index < static_cast<double>(list.size()) && index == std::floor(index);
  return is_one ? list[static_cast<std::size_t>(index)] : kUndefined;
}

PointLists points_of(const ir::Program& arena, const ir::Expression& along) {
  const ir::Expression& points = arena.at(along.b);
  const auto list = [&arena](ir::ExpressionId id) { return arena.at(arena.at(id).variable).symbol; };
  return {list(points.a), list(points.b)};
}

std::uint32_t uses_of(const ir::Program& arena, ir::ExpressionId expression, ir::SymbolId symbol) {
  const ir::Expression& e = arena.at(expression);
  const int operands = ir::operand_count(e.op);
  if (operands > 0) return uses_of(arena, e.a, symbol) + (operands > 1 ? uses_of(arena, e.b, symbol) : 0U);
  if (e.op != Operator::variable) return 0;
  const ir::Variable& v = arena.at(e.variable);
  const std::uint32_t in_index = v.index == ir::ExpressionId::none ? 0U : uses_of(arena, v.index, symbol);
  return in_index + (v.symbol == symbol ? 1U : 0U);
}

bool names(const ir::Program& arena, ir::ExpressionId expression, ir::SymbolId symbol) {
  return uses_of(arena, expression, symbol) > 0;
}

bool interpolates_by(const ir::Program& arena, ir::ExpressionId expression, ir::SymbolId symbol) {
  const ir::Expression& e = arena.at(expression);
  if (e.op == kAlong) return names(arena, expression, symbol);
  const int operands = ir::operand_count(e.op);
  return operands > 0 && (interpolates_by(arena, e.a, symbol) || (operands > 1 && interpolates_by(arena, e.b, symbol)));
}

UnaryRule unary_rule(Operator op) {
  const auto row = std::ranges::find(kUnary, op, &UnaryRow::op);
  return row == kUnary.end() ? nullptr : row->of;
}

BinaryRule binary_rule(Operator op) {
  const auto row = std::ranges::find(kBinary, op, &BinaryRow::op);
  return row == kBinary.end() ? nullptr : row->of;
}

Dual evaluate(const ir::Program& arena, ir::ExpressionId expression, std::span<const double> values, ir::SymbolId by) {
  const ir::Expression& e = arena.at(expression);
  const int operands = ir::operand_count(e.op);
  if (operands == 0) return leaf(arena, e, values, by);
  const Dual a = evaluate(arena, e.a, values, by);
  if (operands == 1) {
    const UnaryRule rule = unary_rule(e.op);
    return rule == nullptr ? Dual{kUndefined} : rule(a);
  }
  if (e.op == kAlong) {
    const PointLists points = points_of(arena, e);
    return along(list_in(values, points.x), list_in(values, points.y), a);
  }
  const BinaryRule rule = binary_rule(e.op);
  return rule == nullptr ? Dual{kUndefined} : rule(a, evaluate(arena, e.b, values, by));
}

ir::ExpressionId first_undefined(const ir::Program& arena, ir::ExpressionId expression,
                                 std::span<const double> values) {
  const ir::Expression& e = arena.at(expression);
  const int operands = ir::operand_count(e.op);
  if (operands > 0) {
    if (const ir::ExpressionId in_a = first_undefined(arena, e.a, values); in_a != ir::ExpressionId::none) return in_a;
  }
  if (operands > 1 && e.op != kAlong) {
    if (const ir::ExpressionId in_b = first_undefined(arena, e.b, values); in_b != ir::ExpressionId::none) return in_b;
  }
  return std::isfinite(evaluate(arena, expression, values).value) ? ir::ExpressionId::none : expression;
}

bool names_unknown(const ir::Program& arena, ir::ExpressionId expression, std::span<const std::uint8_t> is_known) {
  const ir::Expression& e = arena.at(expression);
  const int operands = ir::operand_count(e.op);
  if (operands == 0) {
    if (e.op != Operator::variable) return false;
    const ir::Variable& v = arena.at(e.variable);
    return !is_known[static_cast<std::size_t>(v.symbol)] ||
           (v.index != ir::ExpressionId::none && names_unknown(arena, v.index, is_known));
  }
  return names_unknown(arena, e.a, is_known) || (operands > 1 && names_unknown(arena, e.b, is_known));
}

}  // namespace dripfeed::family
