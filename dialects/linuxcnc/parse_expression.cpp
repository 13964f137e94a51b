// Spellings of operators and functions are tables.
#include "dialects/linuxcnc/parse_expression.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "dialects/linuxcnc/tables.h"
#include "dialects/text/number.h"

namespace dripfeed::linuxcnc {

namespace {

using ir::ExpressionId;
using ir::Operator;
using enum text::DiagnosticId;

constexpr double kEqual = 0.0001;  // operands nearer than this are equal
constexpr std::uint32_t kDeepest = 64;
constexpr double kHighestParameter = 5601.0;

struct OperatorRow {
  std::string_view spelling;
  int rank;
  Operator op;
};
// A longer spelling before one that it begins with.
constexpr auto kOperators = std::to_array<OperatorRow>({
    {"**", 5, Operator::power},
    {"*", 4, Operator::multiply},
    {"/", 4, Operator::divide},
    {"mod", 4, Operator::modulo},
    {"+", 3, Operator::add},
    {"-", 3, Operator::subtract},
    {"eq", 2, Operator::equal},
    {"ne", 2, Operator::not_equal},
    {"ge", 2, Operator::greater_equal},
    {"gt", 2, Operator::greater},
    {"le", 2, Operator::less_equal},
    {"lt", 2, Operator::less},
    {"and", 1, Operator::logic_and},
    {"or", 1, Operator::logic_or},
    {"xor", 1, Operator::logic_xor},
});

struct FunctionRow {
  std::string_view spelling;
  Operator op;
};
constexpr auto kFunctions = std::to_array<FunctionRow>({
    {"abs", Operator::abs},
    {"acos", Operator::acos},
    {"asin", Operator::asin},
    {"atan", Operator::atan2},
    {"cos", Operator::cos},
    {"exp", Operator::exp},
    {"fix", Operator::truncate},
    {"fup", Operator::round_up},
    {"ln", Operator::ln},
    {"round", Operator::round},
    {"sin", Operator::sin},
    {"sqrt", Operator::sqrt},
    {"tan", Operator::tan},
});

bool is_digit(char c) { return (c >= '0' && c <= '9') || c == '.'; }

}  // namespace

ExpressionId ExpressionReader::fail(text::DiagnosticId id, std::vector<std::string> arguments) {
  faults_.fail(id, line_->span(std::min(at_, line_->text.size()), std::min(at_ + 1, line_->text.size())),
               std::move(arguments));
  return ExpressionId::none;
}

ExpressionId ExpressionReader::combine(Operator op, ExpressionId a, ExpressionId b) {
  if (faults_.failed()) return ExpressionId::none;
  return program_.add_operator(op, a, b, line_->span(std::min(began_, at_), at_));
}

ExpressionId ExpressionReader::constant(double value) { return program_.add_constant(value, {}, true); }

ExpressionId ExpressionReader::value() {
  const std::size_t begin = at_;
  if (++depth_ > kDeepest) return fail(bracket_nesting_too_deep, {std::to_string(depth_), std::to_string(kDeepest)});
  const char c = line_->at(at_);
  ExpressionId result = ExpressionId::none;
  if (c == '[') {
    result = bracketed();
  } else if (c == '#') {
    const auto read = parameter();
    if (read) result = program_.add_variable(*read);
  } else if (c == '+' || c == '-') {
    ++at_;
    result = value();
    began_ = begin;
    if (c == '-' && !faults_.failed()) {
      const ir::Expression& e = program_.at(result);
      result = e.op == Operator::constant ? program_.add_constant(-e.value, line_->span(begin, at_), e.has_point)
                                          : combine(Operator::negate, result);
    }
  } else if (is_digit(c)) {
    result = number();
  } else {
    result = function();
  }
  --depth_;
  return result;
}

ExpressionId ExpressionReader::number() {
  const std::size_t begin = at_;
  while (is_digit(line_->at(at_))) ++at_;
  const std::string_view written = line_->rest(begin).substr(0, at_ - begin);
  const auto decimal = text::read_decimal(written);
  if (!decimal || decimal->length != written.size()) return fail(malformed_number, {std::string(written)});
  return program_.add_constant(decimal->value, line_->span(begin, at_), decimal->has_point);
}

ExpressionId ExpressionReader::bracketed() {
  if (line_->at(at_) != '[') return fail(missing_bracket, {"["});
  const std::size_t begin = at_++;
  const ExpressionId inner = operation(1);
  if (faults_.failed()) return ExpressionId::none;
  if (line_->at(at_) != ']') return fail(missing_bracket, {"the ] for this bracket"});
  ++at_;
  // A bracket is calculated: its span distinguishes it from a number that was written.
  const ir::Expression e = program_.at(inner);
  return e.op == Operator::constant ? program_.add_constant(e.value, line_->span(begin, at_)) : inner;
}

ExpressionId ExpressionReader::operation(int least_rank) {
  const std::size_t begin = at_;
  ExpressionId left = value();
  while (!faults_.failed()) {
    const auto row = std::ranges::find_if(
        kOperators, [&](const OperatorRow& r) { return line_->rest(at_).starts_with(r.spelling); });
    if (row == kOperators.end() || row->rank < least_rank) break;
    at_ += row->spelling.size();
    const ExpressionId right = operation(row->rank + 1);
    began_ = begin;
    if (!faults_.failed()) left = join(row->spelling, left, right);
  }
  return left;
}

ExpressionId ExpressionReader::join(std::string_view spelling, ExpressionId a, ExpressionId b) {
  const auto difference = [&](ExpressionId x, ExpressionId y) { return combine(Operator::subtract, x, y); };
  const auto is_near = [&] {
    return combine(Operator::less, combine(Operator::abs, difference(a, b)), constant(kEqual));
  };
  if (spelling == "eq") return is_near();
  if (spelling == "ne") return combine(Operator::logic_not, is_near());
  if (spelling == "le") return combine(Operator::less, difference(a, b), constant(kEqual));
  if (spelling == "ge") return combine(Operator::less, difference(b, a), constant(kEqual));
  if (spelling == "mod") {
    const ExpressionId rest = combine(Operator::modulo, a, b);
    const ExpressionId is_below = combine(Operator::less, rest, constant(0.0));
    return combine(Operator::add, rest, combine(Operator::multiply, is_below, combine(Operator::abs, b)));
  }
  return combine(std::ranges::find(kOperators, spelling, &OperatorRow::spelling)->op, a, b);
}

ExpressionId ExpressionReader::function() {
  const std::size_t begin = at_;
  if (line_->rest(at_).starts_with("exists")) return exists();
  const auto row =
      std::ranges::find_if(kFunctions, [&](const FunctionRow& r) { return line_->rest(at_).starts_with(r.spelling); });
  if (row == kFunctions.end()) return fail(missing_operand, {std::string(1, line_->at(at_))});
  at_ += row->spelling.size();
  const ExpressionId a = bracketed();
  if (row->op == Operator::atan2) {
    if (faults_.failed()) return ExpressionId::none;
    if (line_->at(at_) != '/') return fail(syntax_error, {"ATAN needs two values: ATAN[a]/[b]"});
    ++at_;
    const ExpressionId b = bracketed();
    began_ = begin;
    return combine(Operator::atan2, a, b);
  }
  began_ = begin;
  // FUP goes up; down is the reverse.
  if (row->op == Operator::truncate)
    return combine(Operator::negate, combine(Operator::round_up, combine(Operator::negate, a)));
  return combine(row->op, a);
}

// EXISTS[#<name>]: whether anything has set it by then.
ExpressionId ExpressionReader::exists() {
  at_ += std::string_view("exists").size();
  const std::size_t close = line_->text.find(']', at_);
  if (line_->at(at_) != '[' || line_->at(at_ + 1) != '#' || close == std::string::npos)
    return fail(syntax_error, {"EXISTS needs a parameter in brackets"});
  at_ += 2;
  if (line_->at(at_) == '<') {
    const std::size_t end = line_->text.find('>', at_);
    if (end == std::string::npos || line_->at(end + 1) != ']')
      return fail(syntax_error, {"EXISTS needs a parameter in brackets"});
    const std::string name(line_->rest(at_ + 1).substr(0, end - at_ - 1));
    at_ = end + 2;
    if (predefined(name) != 0) return constant(1.0);
    return program_.add_variable(existence(name));
  }
  // A numbered one exists as far as there are numbers.
  const ExpressionId number = value();
  if (faults_.failed()) return ExpressionId::none;
  if (line_->at(at_) != ']') return fail(syntax_error, {"EXISTS needs a parameter in brackets"});
  ++at_;
  return combine(Operator::logic_and, combine(Operator::greater, number, constant(0.0)),
                 combine(Operator::less_equal, number, constant(kHighestParameter)));
}

std::optional<ir::Variable> ExpressionReader::parameter() {
  const std::size_t begin = at_++;
  if (line_->at(at_) == '<') {
    const std::size_t end = line_->text.find('>', at_);
    if (end == std::string::npos || end == at_ + 1) {
      fail(syntax_error, {"a parameter's name needs <…>"});
      return std::nullopt;
    }
    const std::string name(line_->rest(at_ + 1).substr(0, end - at_ - 1));
    at_ = end + 1;
    return named(name, line_->span(begin, at_));
  }
  ir::Variable result;
  const ExpressionId index = value();
  if (faults_.failed()) return std::nullopt;
  const ir::Expression& number = program_.at(index);
  result.span = line_->span(begin, at_);
  if (number.op != Operator::constant) {
    result.index = index;
    return result;
  }
  if (number.value < 1.0 || number.value > kHighestParameter || number.value != std::round(number.value)) {
    faults_.fail(variable_out_of_range, result.span, {"#" + text::format_shortest(number.value)});
    return std::nullopt;
  }
  result.number = static_cast<std::uint32_t>(number.value);
  return result;
}

ir::Variable ExpressionReader::named(std::string_view name, text::Span span) {
  ir::Variable result;
  result.span = span;
  result.number = predefined(name);
  if (result.number == kOnlyTheControlKnows) {
    result.bank = ir::Bank::system;
    result.name = program_.strings.add(fmt::format("#<{}>", name));
  }
  if (result.number != 0) return result;
  const auto [known, is_new] = symbols_.try_emplace(std::string(name), ir::SymbolId::none);
  if (is_new) {
    ir::Symbol symbol;
    symbol.name = program_.strings.add(fmt::format("#<{}>", name));
    symbol.is_global = name.starts_with("_") || name.starts_with("exists _");
    symbol.span = span;
    known->second = program_.add(symbol);
  }
  result.bank = ir::Bank::named;
  result.symbol = known->second;
  return result;
}

ir::Variable ExpressionReader::own(std::string_view purpose) { return named(purpose, {}); }

}  // namespace dripfeed::linuxcnc
