// Value, first and second derivative are carried as intervals through each operator: for f(a),
//   (f(a))'' = f''(a)·a'² + f'(a)·a''.
#include "dialects/family/second_derivative.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "dialects/family/evaluate.h"
#include "dialects/family/range_arithmetic.h"

namespace dripfeed::family {

namespace {

using ir::Operator;

constexpr double kDegree = std::numbers::pi / 180.0;
struct Jet {
  Range value;
  Range first;
  Range second;
};
constexpr Jet kUnknown{kAnything, kAnything, kAnything};

// f, f' and f'' over the range of the argument.
struct Outer {
  Range value;
  Range first;
  Range second;
};
constexpr Outer kNoOuter{kAnything, kAnything, kAnything};

Jet chain(const Outer& f, const Jet& a) {
  return {f.value, f.first * a.first, f.second * square(a.first) + f.first * a.second};
}

Outer reciprocal(Range a) {
  if (a.low <= 0.0 && a.high >= 0.0) return kNoOuter;
  const Range r = widened(1.0 / a.high, 1.0 / a.low);
  return {r, -square(r), 2.0 * (r * square(r))};
}

Outer root(Range a) {
  if (a.low <= 0.0) return kNoOuter;
  const Range r = widened(std::sqrt(a.low), std::sqrt(a.high));
  const Range inverse = reciprocal(r).value;
  return {r, 0.5 * inverse, -0.25 * (inverse * square(inverse))};
}

// Sine over a range of degrees: its ends, and 1 or -1 where a quarter turn lies inside.
Range sine(Range a) {
  if (!(a.high - a.low < 360.0)) return {-1.0, 1.0};
  const auto holds = [a](double quarter) {
    return std::floor((a.high - quarter) / 360.0) >= std::ceil((a.low - quarter) / 360.0);
  };
  const auto [low, high] = std::minmax({std::sin(a.low * kDegree), std::sin(a.high * kDegree)});
  return {holds(270.0) ? -1.0 : low - kRounding, holds(90.0) ? 1.0 : high + kRounding};
}
Range cosine(Range a) { return sine({a.low + 90.0, a.high + 90.0}); }

Outer sine_of(Range a) { return {sine(a), kDegree * cosine(a), -(kDegree * kDegree) * sine(a)}; }
Outer cosine_of(Range a) { return {cosine(a), -kDegree * sine(a), -(kDegree * kDegree) * cosine(a)}; }

Outer tangent_of(Range a) {
  if (cosine(a).contains(0.0) || a.high - a.low >= 180.0) return kNoOuter;
  const Range t = widened(std::tan(a.low * kDegree), std::tan(a.high * kDegree));
  const Range slope = Range{1.0, 1.0} + square(t);
  return {t, kDegree * slope, 2.0 * kDegree * kDegree * (t * slope)};
}

Outer arc_tangent_of(Range a) {
  const Range inverse = reciprocal(Range{1.0, 1.0} + square(a)).value;
  return {widened(std::atan(a.low) / kDegree, std::atan(a.high) / kDegree), 1.0 / kDegree * inverse,
          -2.0 / kDegree * (a * square(inverse))};
}

Outer exponential_of(Range a) {
  const Range e = widened(std::exp(a.low), std::exp(a.high));
  return {e, e, e};
}

Outer logarithm_of(Range a) {
  if (a.low <= 0.0) return kNoOuter;
  const Range inverse = reciprocal(a).value;
  return {widened(std::log(a.low), std::log(a.high)), inverse, -square(inverse)};
}

struct OuterRow {
  Operator op;
  Outer (*over)(Range argument);
};
constexpr auto kOuters = std::to_array<OuterRow>({
    {Operator::sin, sine_of},
    {Operator::cos, cosine_of},
    {Operator::tan, tangent_of},
    {Operator::atan, arc_tangent_of},
    {Operator::sqrt, root},
    {Operator::exp, exponential_of},
    {Operator::ln, logarithm_of},
});

Jet sum(const Jet& a, const Jet& b) { return {a.value + b.value, a.first + b.first, a.second + b.second}; }
Jet negated(const Jet& a) { return {-a.value, -a.first, -a.second}; }
Jet product(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + 2.0 * (a.first * b.first) + a.value * b.second};
}
Outer squared(Range a) { return {square(a), 2.0 * a, {2.0, 2.0}}; }

class Enclosure {
 public:
  Enclosure(const ir::Program& arena, std::span<const double> values, ir::SymbolId by, Range range)
      : arena_(arena), values_(values), by_(by), range_(range) {}

  [[nodiscard]] Jet of(ir::ExpressionId id) const {
    const ir::Expression& e = arena_.at(id);
    const int operands = ir::operand_count(e.op);
    if (operands == 0) return leaf(e);
    if (e.op == kAlong) return along(id);
    const Jet a = of(e.a);
    if (operands == 1) return unary(e.op, a);
    // A power multiplies a node with itself: its square is never negative.
    if (e.op == Operator::multiply && e.a == e.b) return chain(squared(a.value), a);
    return binary(e.op, a, of(e.b));
  }

 private:
  [[nodiscard]] Jet along(ir::ExpressionId id) const {
    if (names(arena_, id, by_)) return kUnknown;
    const double value = evaluate(arena_, id, values_).value;
    return {{value, value}, {}, {}};
  }

  [[nodiscard]] Jet leaf(const ir::Expression& e) const {
    if (e.op == Operator::constant) return {{e.value, e.value}, {}, {}};
    if (e.op != Operator::variable) return kUnknown;
    const ir::Variable& v = arena_.at(e.variable);
    if (v.symbol == by_) return {range_, {1.0, 1.0}, {}};
    // An index that depends on the variable names no single number of a list.
    if (v.index != ir::ExpressionId::none && names(arena_, v.index, by_)) return kUnknown;
    const double value = value_of(arena_, v, values_);
    return {{value, value}, {}, {}};
  }

  static Jet unary(Operator op, const Jet& a) {
    if (op == Operator::negate) return negated(a);
    const auto row = std::ranges::find(kOuters, op, &OuterRow::op);
    return row == kOuters.end() ? kUnknown : chain(row->over(a.value), a);
  }

  static Jet binary(Operator op, const Jet& a, const Jet& b) {
    if (op == Operator::add) return sum(a, b);
    if (op == Operator::subtract) return sum(a, negated(b));
    if (op == Operator::multiply) return product(a, b);
    if (op == Operator::divide) return product(a, chain(reciprocal(b.value), b));
    return kUnknown;
  }

  const ir::Program& arena_;
  std::span<const double> values_;
  ir::SymbolId by_;
  Range range_;
};

}  // namespace

DerivativeRanges derivatives(const ir::Program& arena, ir::ExpressionId expression, std::span<const double> values,
                             ir::SymbolId by, curves::Range range) {
  const Jet jet = Enclosure(arena, values, by, range).of(expression);
  return {jet.first, jet.second};
}

curves::Range second_derivative(const ir::Program& arena, ir::ExpressionId expression, std::span<const double> values,
                                ir::SymbolId by, curves::Range range) {
  return derivatives(arena, expression, values, by, range).second;
}

}  // namespace dripfeed::family
