// Zero times, zero plus, times one; and numbers that a control can write whole.
#include "dialects/optimize/simplify.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "dialects/optimize/expressions.h"
#include "dialects/text/number.h"

namespace dripfeed::optimize {

namespace {

using ir::ExpressionId;
using ir::Operator;

class Simplifier {
 public:
  Simplifier(ir::Program& program, const ir::Control& control, const interpreter::Arithmetic& arithmetic)
      : program_(program), control_(control), arithmetic_(arithmetic) {}

  ExpressionId simple(ExpressionId id) {
    const ir::Expression e = program_.at(id);
    if (const std::optional<double> value = folded(e)) return program_.add_constant(*value);
    switch (e.op) {
      case Operator::add:
        if (is(e.a, 0.0)) return number_or(e.b, id);
        if (is(e.b, 0.0)) return number_or(e.a, id);
        return id;
      case Operator::subtract:
        if (is(e.b, 0.0)) return number_or(e.a, id);
        if (is(e.a, 0.0) && is_number(program_, control_, e.b)) return program_.add_operator(Operator::negate, e.b);
        return id;
      case Operator::multiply:
        if (is(e.a, 0.0) && !may_fault(program_, e.b)) return program_.add_constant(0.0);
        if (is(e.b, 0.0) && !may_fault(program_, e.a)) return program_.add_constant(0.0);
        if (is(e.a, 1.0)) return number_or(e.b, id);
        if (is(e.b, 1.0)) return number_or(e.a, id);
        return id;
      case Operator::divide: return is(e.b, 1.0) ? number_or(e.a, id) : id;
      case Operator::negate: return program_.at(e.a).op == Operator::negate ? number_or(program_.at(e.a).a, id) : id;
      default: return id;
    }
  }

 private:
  [[nodiscard]] bool is(ExpressionId id, double value) const {
    const ir::Expression& e = program_.at(id);
    return e.op == Operator::constant && e.value == value;
  }
  [[nodiscard]] ExpressionId number_or(ExpressionId operand, ExpressionId whole) const {
    return is_number(program_, control_, operand) ? operand : whole;
  }
  [[nodiscard]] std::optional<double> constant(ExpressionId id) const {
    if (id == ExpressionId::none || program_.at(id).op != Operator::constant) return {};
    return program_.at(id).value;
  }

  // Only of the operators whose result is the same on every control, and only where all its digits can be written.
  [[nodiscard]] std::optional<double> folded(const ir::Expression& e) const {
    const std::optional<double> a = constant(e.a), b = constant(e.b);
    interpreter::Outcome outcome;
    if (a && b && e.op >= Operator::add && e.op <= Operator::divide)
      outcome = arithmetic_.binary(e.op, *a, *b);
    else if (a && e.op == Operator::square)
      outcome = arithmetic_.unary(e.op, *a);
    else
      return {};
    if (outcome.fault != interpreter::Fault::none || !can_be_written(control_, outcome.value)) return {};
    return outcome.value;
  }

  ir::Program& program_;
  const ir::Control& control_;
  const interpreter::Arithmetic& arithmetic_;
};

}  // namespace

bool can_be_written(const ir::Control& control, double value) {
  constexpr std::uint32_t kMostDigits = 8;
  constexpr std::size_t kMostDecimals = 4;
  const std::string text = text::format_shortest(value);
  if (text.find('e') != std::string::npos) return false;
  const std::size_t point = text.find('.');
  if (point != std::string::npos && text.size() - point - 1 > kMostDecimals) return false;
  const auto digits = std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; });
  const std::uint32_t most = control.limits.digits == 0 ? kMostDigits : std::min(control.limits.digits, kMostDigits);
  return static_cast<std::uint32_t>(digits) <= most;
}

ExpressionId simplified(ir::Program& program, const ir::Control& control, const interpreter::Arithmetic& arithmetic,
                        ExpressionId id) {
  return Simplifier(program, control, arithmetic).simple(id);
}

}  // namespace dripfeed::optimize
