// Ranks as the parser has them: 1 comparisons, 2 sums, 3 products, 4 everything that stands for itself. A sign counts
// as a sum except at the very beginning of an expression, because controls differ in where they take one.
#include "dialects/macro_b/writer/print_expression.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "dialects/macro_b/tables/variables.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Operator;

constexpr int kComparison = 1;
constexpr int kSum = 2;
constexpr int kProduct = 3;
constexpr int kItself = 4;

struct Infix {
  Operator op;
  int rank;
  std::string_view spelling;
};
constexpr auto kInfix = std::to_array<Infix>({
    {Operator::add, kSum, "+"},
    {Operator::subtract, kSum, "-"},
    {Operator::bit_or, kSum, " OR "},
    {Operator::bit_xor, kSum, " XOR "},
    {Operator::logic_or, kSum, " OR "},
    {Operator::logic_xor, kSum, " XOR "},
    {Operator::multiply, kProduct, "*"},
    {Operator::divide, kProduct, "/"},
    {Operator::modulo, kProduct, " MOD "},
    {Operator::bit_and, kProduct, " AND "},
    {Operator::logic_and, kProduct, " AND "},
    {Operator::equal, kComparison, " EQ "},
    {Operator::not_equal, kComparison, " NE "},
    {Operator::less, kComparison, " LT "},
    {Operator::less_equal, kComparison, " LE "},
    {Operator::greater, kComparison, " GT "},
    {Operator::greater_equal, kComparison, " GE "},
});

const Infix* infix_of(Operator op) {
  const auto row = std::ranges::find(kInfix, op, &Infix::op);
  return row == kInfix.end() ? nullptr : &*row;
}

bool is_negative(const ir::Expression& e) {
  return e.op == Operator::negate || (e.op == Operator::constant && std::signbit(e.value) && e.value != 0.0);
}

int rank_of(const ir::Expression& e, bool first) {
  if (is_negative(e)) return first ? kItself : kSum - 1;
  const Infix* row = infix_of(e.op);
  return row == nullptr ? kItself : row->rank;
}

constexpr int kMostDecimals = 9;  // what the number printer takes

}  // namespace

bool can_print(const Grammar& grammar, Operator op) {
  return op == Operator::constant || op == Operator::vacant || op == Operator::variable || op == Operator::negate ||
         op == Operator::atan2 || infix_of(op) != nullptr || !spelling_of(grammar, op).empty();
}

std::string ExpressionPrinter::constant(double value, bool has_point) const {
  if (std::isnan(value)) return "#0";
  const double magnitude = std::abs(value);
  const int whole_digits = magnitude < 1.0 ? 1 : static_cast<int>(std::floor(std::log10(magnitude))) + 1;
  const int decimals = std::clamp(static_cast<int>(grammar_.macro_digits) - whole_digits, 0, kMostDecimals);
  std::string out;
  text::append_word_number(out, value, decimals, !has_point);
  return out;
}

// Others of bank `system` are another control's, and are refused before anything of them is printed.
bool ExpressionPrinter::is_parameter(const ir::Variable& v) const {
  if (v.bank != ir::Bank::system || v.name == ir::StringId::none) return false;
  const std::string_view name = program_.strings.at(v.name);
  return name == kParameter || name == kParameterOfAxis;
}

// PRM[n,bit]/[axis]: its name says whether an axis is among the indices.
std::string ExpressionPrinter::parameter(const ir::Variable& variable) const {
  const bool of_axis = program_.strings.at(variable.name) == kParameterOfAxis;
  const ExpressionId bit = of_axis ? variable.index3 : variable.index2;
  const std::string tail = of_axis ? fmt::format("/[{}]", expression(variable.index2)) : "";
  if (bit == ExpressionId::none) return fmt::format("PRM[{}]{}", expression(variable.index), tail);
  return fmt::format("PRM[{},{}]{}", expression(variable.index), expression(bit), tail);
}

std::string ExpressionPrinter::variable(const ir::Variable& variable) const {
  if (is_parameter(variable)) return parameter(variable);
  if (variable.index == ExpressionId::none) return fmt::format("#{}", variable.number);
  return fmt::format("#[{}]", expression(variable.index));
}

std::string ExpressionPrinter::expression(ExpressionId id) const { return operand(id, kComparison, true); }

// `first`: at the beginning of an expression, where a sign may stand.
std::string ExpressionPrinter::operand(ExpressionId id, int least_rank, bool first) const {
  const ir::Expression& e = program_.at(id);
  if (const ExpressionId inner = rounded_operand(e); inner != ExpressionId::none) {
    return fmt::format("{}[{}]", spelling_of(grammar_, Operator::round), expression(inner));
  }
  if (rank_of(e, first) < least_rank) return "[" + expression(id) + "]";
  if (e.op == Operator::constant) return constant(e.value, e.has_point);
  if (e.op == Operator::vacant) return "#0";
  if (e.op == Operator::variable) return variable(program_.at(e.variable));
  if (e.op == Operator::negate) return "-" + operand(e.a, kItself, false);
  return infix_of(e.op) != nullptr ? infix(e) : function(e);
}

// x of ROUND[x*1000]/1000, which is how lowering keeps ROUND[x] of an address; none for all else.
ExpressionId ExpressionPrinter::rounded_operand(const ir::Expression& e) const {
  if (!in_word_ || e.op != Operator::divide || program_.at(e.a).op != Operator::round) return ExpressionId::none;
  const ir::Expression& product = program_.at(program_.at(e.a).a);
  const ir::Expression& divisor = program_.at(e.b);
  if (product.op != Operator::multiply || divisor.op != Operator::constant) return ExpressionId::none;
  const ir::Expression& factor = program_.at(product.b);
  return factor.op == Operator::constant && factor.value == divisor.value ? product.a : ExpressionId::none;
}

std::string ExpressionPrinter::infix(const ir::Expression& e) const {
  const Infix& row = *infix_of(e.op);
  // Conditions joined by AND or OR stand in brackets each, whatever their rank.
  const bool logic = e.op == Operator::logic_and || e.op == Operator::logic_or || e.op == Operator::logic_xor;
  std::string left = logic ? condition(e.a) : operand(e.a, row.rank, true);
  const std::string right = logic ? condition(e.b) : operand(e.b, row.rank + 1, false);
  if (e.op == Operator::divide && right.starts_with('[') && ends_with_atan(e.a)) left = "[" + left + "]";
  return fmt::format("{}{}{}", left, row.spelling, right);
}

// ATAN[a]/[b] would be the angle of a and b.
bool ExpressionPrinter::ends_with_atan(ExpressionId id) const {
  const ir::Expression& e = program_.at(id);
  if (e.op == Operator::atan) return true;
  const Infix* row = infix_of(e.op);
  return row != nullptr && row->rank == kProduct && ends_with_atan(e.b);
}

std::string ExpressionPrinter::function(const ir::Expression& e) const {
  if (e.op == Operator::atan2) {
    return fmt::format("{}[{}]/[{}]", spelling_of(grammar_, Operator::atan), expression(e.a), expression(e.b));
  }
  const std::string_view spelling = spelling_of(grammar_, e.op);
  if (ir::operand_count(e.op) == 2) return fmt::format("{}[{},{}]", spelling, expression(e.a), expression(e.b));
  return fmt::format("{}[{}]", spelling, expression(e.a));
}

std::string ExpressionPrinter::word_value(ExpressionId id) const {
  const ir::Expression& e = program_.at(id);
  if (e.op == Operator::constant) return constant(e.value, e.has_point);
  // #1, but [PRM[1]].
  const auto is_numbered = [&](const ir::Expression& v) {
    return v.op == Operator::variable && !is_parameter(program_.at(v.variable));
  };
  if (is_numbered(e) || e.op == Operator::vacant) return expression(id);
  if (e.op == Operator::negate && is_numbered(program_.at(e.a))) return expression(id);
  ExpressionPrinter printer = *this;
  printer.in_word_ = true;
  return e.op == Operator::negate ? "-" + printer.condition(e.a) : printer.condition(id);
}

std::uint32_t ExpressionPrinter::depth(ExpressionId id) const {
  const std::string printed = expression(id);
  std::uint32_t open = 0;
  std::uint32_t deepest = 0;
  for (const char c : printed) {
    if (c == '[') deepest = std::max(deepest, ++open);
    if (c == ']') --open;
  }
  return deepest;
}

}  // namespace dripfeed::macro_b
