// One function a priority level. Brackets are counted with those of functions, as the control does; far beyond any
// control's limit reading gives up, so that no text can exhaust the stack.
#include "dialects/macro_b/reader/parse_expression.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dialects/macro_b/tables/variables.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::TokenKind;
using enum text::DiagnosticId;

constexpr std::uint32_t kDeepestBracket = 64;
// Of one block. A chain of operators is a tree as deep as it is long, and whoever walks it must not run out of stack.
constexpr std::uint32_t kMostOperators = 1000;

bool is_comparison(Operator op) { return op >= Operator::equal && op <= Operator::greater_equal; }
bool is_logic(Operator op) { return op >= Operator::logic_and && op <= Operator::logic_xor; }

}  // namespace

const Keyword* ExpressionReader::keyword() const {
  if (cursor_.kind() != TokenKind::name) return nullptr;
  return keywords_.match(cursor_.whole_text().substr(cursor_.span().begin)).keyword;
}

ExpressionId ExpressionReader::expression(std::string_view after) { return comparison(after); }

ExpressionId ExpressionReader::comparison(std::string_view after) {
  ExpressionId left = sum(after);
  while (!faults_.failed()) {
    const Keyword* word = keyword();
    if (word == nullptr || word->role != KeywordRole::infix || !is_comparison(word->op)) break;
    const text::Span at = cursor_.span();
    cursor_.advance();
    const ExpressionId right = sum(word->spelling);
    if (faults_.failed()) break;
    const auto mixes = [&](ExpressionId id) {
      const Operator op = program_.at(id).op;
      return op == Operator::bit_and || op == Operator::bit_or || op == Operator::bit_xor;
    };
    const bool bare_right = mixes(right) && cursor_.whole_text()[cursor_.previous_end() - 1] != ']';
    if ((is_condition(left) || bare_right) && !std::exchange(reported_mixed_logic_, true)) {
      faults_.report(comparison_with_logic, at, {"AND, OR or another comparison"});
    }
    left = combine(word->op, left, right);
  }
  return left;
}

ExpressionId ExpressionReader::sum(std::string_view after) {
  ExpressionId left = product(after);
  while (!faults_.failed()) {
    Operator op = Operator::constant;
    const Keyword* word = keyword();
    if (cursor_.is_symbol('+')) op = Operator::add;
    if (cursor_.is_symbol('-')) op = Operator::subtract;
    if (word != nullptr && word->role == KeywordRole::infix &&
        (word->op == Operator::bit_or || word->op == Operator::bit_xor)) {
      op = word->op;
    }
    if (op == Operator::constant) break;
    const std::string spelling(cursor_.text());
    cursor_.advance();
    const ExpressionId right = product(spelling);
    if (!faults_.failed()) left = combine(op, left, right);
  }
  return left;
}

ExpressionId ExpressionReader::product(std::string_view after) {
  ExpressionId left = factor(after);
  while (!faults_.failed()) {
    Operator op = Operator::constant;
    const Keyword* word = keyword();
    if (cursor_.is_symbol('*')) op = Operator::multiply;
    if (cursor_.is_symbol('/')) op = Operator::divide;
    if (word != nullptr && word->role == KeywordRole::infix &&
        (word->op == Operator::bit_and || word->op == Operator::modulo)) {
      op = word->op;
    }
    if (op == Operator::constant) break;
    const std::string spelling(cursor_.text());
    cursor_.advance();
    const ExpressionId right = factor(spelling);
    if (!faults_.failed()) left = combine(op, left, right);
  }
  return left;
}

ExpressionId ExpressionReader::factor(std::string_view after) {
  const std::uint32_t begin = cursor_.span().begin;
  const bool minus = cursor_.is_symbol('-');
  if (minus || cursor_.is_symbol('+')) {
    // After an operator a minus is the value's sign (#1*-1); a plus is one operator too many.
    const bool after_operator = after == "+" || after == "-" || after == "*" || after == "/";
    if (after_operator && !minus) {
      faults_.fail(syntax_error, cursor_.span(), {"two signs one after the other"}, ir::AlarmDetail::two_signs);
      return ExpressionId::none;
    }
    cursor_.advance();
    if (cursor_.is_symbol('-') || cursor_.is_symbol('+')) {
      faults_.fail(syntax_error, cursor_.span(), {"two signs one after the other"}, ir::AlarmDetail::two_signs);
      return ExpressionId::none;
    }
    if (cursor_.kind() == TokenKind::number) return number(grammar_.macro_digits, minus, begin);
    const ExpressionId value = factor(minus ? "-" : "+");
    if (!minus || faults_.failed()) return value;
    return program_.add_operator(Operator::negate, value, ExpressionId::none, {begin, cursor_.previous_end()});
  }
  if (cursor_.kind() == TokenKind::number) return number(grammar_.macro_digits, false, begin);
  if (cursor_.kind() == TokenKind::variable) return variable_value();
  if (cursor_.is_symbol('[')) return bracketed(after);
  if (const Keyword* word = keyword();
      word != nullptr && (word->role == KeywordRole::function || word->role == KeywordRole::unmodelled_function)) {
    return function(*word);
  }
  // #1=FOO[2]: letters that are no function.
  const TokenKind next = cursor_.peek().kind;
  const bool unknown = cursor_.kind() == TokenKind::name || (cursor_.kind() == TokenKind::address &&
                                                             (next == TokenKind::address || next == TokenKind::name));
  faults_.fail(missing_operand, cursor_.span(), {std::string(after)},
               unknown ? ir::AlarmDetail::unknown_word : ir::AlarmDetail::none);
  return ExpressionId::none;
}

// Nine digits are those of the increment system IS-C, which a machine may have: once a program.
void ExpressionReader::digits_fault(const text::Decimal& decimal, std::uint32_t most_digits) {
  constexpr std::uint32_t kMostOfFineIncrements = 9;
  const bool may_fit =
      !control_.from_profile && most_digits == control_.limits.digits && decimal.digits <= kMostOfFineIncrements;
  if (may_fit && std::exchange(reported_digits_, true)) return;
  text::Diagnostic* fault =
      faults_.report(too_many_digits, cursor_.span(),
                     {std::string(cursor_.text()), std::to_string(decimal.digits), std::to_string(most_digits)});
  if (fault == nullptr || !may_fit) return;
  fault->severity = text::Severity::warning;
  fault->notes.push_back({fault->span, "with the increment system IS-C the control takes 9: the machine decides this"});
}

// The token at the cursor; `begin` is where its sign stands.
ExpressionId ExpressionReader::number(std::uint32_t most_digits, bool negative, std::uint32_t begin) {
  const std::string_view written = cursor_.text();
  const text::Span span = {begin, cursor_.span().end};
  const auto decimal = text::read_decimal(written);
  if (!decimal || decimal->length != written.size()) {
    faults_.fail(malformed_number, cursor_.span(), {std::string(written)});
    return ExpressionId::none;
  }
  if (decimal->digits > most_digits) digits_fault(*decimal, most_digits);
  cursor_.advance();
  return program_.add_constant(negative ? -decimal->value : decimal->value, span, decimal->has_point);
}

ExpressionId ExpressionReader::variable_value() {
  const auto read = variable();
  if (!read) return ExpressionId::none;
  if (read->number == 0 && read->index == ExpressionId::none) {
    return program_.add_operator(Operator::vacant, ExpressionId::none, ExpressionId::none, read->span);
  }
  return program_.add_variable(*read);
}

bool ExpressionReader::open_bracket(std::string_view after) {
  if (!cursor_.is_symbol('[')) {
    const auto where = after == "IF"      ? ir::AlarmDetail::if_statement
                       : after == "WHILE" ? ir::AlarmDetail::while_statement
                                          : ir::AlarmDetail::opening_bracket;
    faults_.fail(missing_bracket, cursor_.span(), {fmt::format("[ after {}", after)}, where);
    return false;
  }
  ++depth_;
  const std::uint32_t most = control_.limits.expression_nesting;
  if (depth_ == most + 1 || depth_ > kDeepestBracket) {
    const bool give_up = depth_ > kDeepestBracket;
    std::vector<std::string> arguments = {std::to_string(depth_), std::to_string(most)};
    if (give_up) {
      faults_.fail(bracket_nesting_too_deep, cursor_.span(), std::move(arguments));
      return false;
    }
    faults_.report(bracket_nesting_too_deep, cursor_.span(), std::move(arguments));
  }
  open_at_ = cursor_.span().begin;
  cursor_.advance();
  return true;
}

bool ExpressionReader::close_bracket() {
  if (faults_.failed()) return false;
  if (!cursor_.is_symbol(']')) {
    faults_.fail(missing_bracket, {open_at_, open_at_ + 1}, {"the ] for this bracket"},
                 ir::AlarmDetail::closing_bracket);
    return false;
  }
  --depth_;
  cursor_.advance();
  return true;
}

ExpressionId ExpressionReader::bracketed(std::string_view after) {
  if (!open_bracket(after)) return ExpressionId::none;
  const std::uint32_t open_at = open_at_;
  const ExpressionId inner = comparison("[");
  open_at_ = open_at;
  return close_bracket() ? inner : ExpressionId::none;
}

// [a GT b], or several of them with AND, OR, XOR between.
ExpressionId ExpressionReader::condition(std::string_view after) {
  ExpressionId left = bracketed(after);
  while (!faults_.failed()) {
    const Keyword* word = keyword();
    const bool joins = word != nullptr && word->role == KeywordRole::infix &&
                       (word->op == Operator::bit_and || word->op == Operator::bit_or || word->op == Operator::bit_xor);
    if (!joins) break;
    cursor_.advance();
    const ExpressionId right = bracketed(word->spelling);
    if (!faults_.failed()) left = combine(word->op, left, right);
  }
  return left;
}

ExpressionId ExpressionReader::function(const Keyword& keyword) {
  const std::uint32_t begin = cursor_.span().begin;
  cursor_.advance();
  if (!open_bracket(keyword.spelling)) return ExpressionId::none;
  const std::uint32_t open_at = open_at_;
  const ExpressionId first = comparison(keyword.spelling);
  ExpressionId second = ExpressionId::none;
  if (!faults_.failed() && cursor_.is_symbol(',')) {
    cursor_.advance();
    second = comparison(keyword.spelling);
  }
  open_at_ = open_at;
  if (!close_bracket()) return ExpressionId::none;
  if (keyword.role == KeywordRole::unmodelled_function && keyword.spelling == kParameter)
    return parameter_value(first, second, begin);
  if (keyword.role == KeywordRole::unmodelled_function) {
    faults_.make_native(keyword.spelling);
    return program_.add_constant(0.0, {begin, cursor_.previous_end()});
  }
  const bool takes_two = keyword.op == Operator::power || keyword.op == Operator::atan;
  if (second != ExpressionId::none && !takes_two) {
    faults_.fail(wrong_argument_count, {begin, cursor_.previous_end()}, {std::string(keyword.spelling), "1", "2"});
    return ExpressionId::none;
  }
  if (second == ExpressionId::none && takes_two) return second_argument(keyword, first, begin);
  const Operator op = keyword.op == Operator::atan && second != ExpressionId::none ? Operator::atan2 : keyword.op;
  return program_.add_operator(op, first, second, {begin, cursor_.previous_end()});
}

// ATAN[a]/[b] is one function of two operands; POW needs both in its bracket.
ExpressionId ExpressionReader::second_argument(const Keyword& keyword, ExpressionId first, std::uint32_t begin) {
  if (keyword.op == Operator::power) {
    faults_.fail(wrong_argument_count, {begin, cursor_.previous_end()}, {std::string(keyword.spelling), "2", "1"},
                 ir::AlarmDetail::missing_comma);
    return ExpressionId::none;
  }
  const ir::Token& next = cursor_.peek();
  const bool has_second =
      cursor_.is_symbol('/') && next.kind == TokenKind::symbol && cursor_.whole_text()[next.span.begin] == '[';
  if (!has_second)
    return program_.add_operator(Operator::atan, first, ExpressionId::none, {begin, cursor_.previous_end()});
  cursor_.advance();
  const ExpressionId second = bracketed("/");
  if (faults_.failed()) return ExpressionId::none;
  return program_.add_operator(Operator::atan2, first, second, {begin, cursor_.previous_end()});
}

ExpressionId ExpressionReader::word_value() {
  const std::uint32_t begin = cursor_.span().begin;
  if (cursor_.kind() == TokenKind::number) return number(control_.limits.digits, false, begin);
  const bool minus = cursor_.is_symbol('-');
  if (minus || cursor_.is_symbol('+')) {
    const ir::Token& next = cursor_.peek();
    if (next.kind == TokenKind::number) {
      cursor_.advance();
      return number(control_.limits.digits, minus, begin);
    }
    const char c = next.span.empty() ? '\0' : cursor_.whole_text()[next.span.begin];
    const bool value_follows = next.kind == TokenKind::variable || next.kind == TokenKind::name || c == '[';
    if (!value_follows && c != '-' && c != '+') return ExpressionId::none;
    if (c != '[') return factor(minus ? "-" : "+");
    cursor_.advance();
    const ExpressionId value = calculated(bracketed(minus ? "-" : "+"), next.span.begin);
    if (!minus || faults_.failed()) return value;
    return program_.add_operator(Operator::negate, value, ExpressionId::none, {begin, cursor_.previous_end()});
  }
  const Keyword* word = keyword();
  const bool is_function = word != nullptr && word->role == KeywordRole::function;
  if (cursor_.is_symbol('[')) return calculated(bracketed(""), begin);
  if (cursor_.kind() == TokenKind::variable || is_function) return factor("");
  return ExpressionId::none;
}

// X[100] is calculated: its value counts in whole units, like that of a variable, whether it has a point or not. Its
// span holds the brackets, so that no one looks for a point in it.
ExpressionId ExpressionReader::calculated(ExpressionId id, std::uint32_t begin) {
  if (faults_.failed() || program_.at(id).op != Operator::constant) return id;
  return program_.add_constant(program_.at(id).value, {begin, cursor_.previous_end()});
}

ExpressionId ExpressionReader::combine(Operator op, ExpressionId a, ExpressionId b) {
  if (++operators_ > kMostOperators) {
    faults_.fail(syntax_error, program_.at(b).span, {fmt::format("a block of more than {} operators", kMostOperators)});
    return ExpressionId::none;
  }
  // AND between conditions joins truths; between values it joins bits.
  if (is_condition(a) && is_condition(b)) {
    if (op == Operator::bit_and) op = Operator::logic_and;
    if (op == Operator::bit_or) op = Operator::logic_or;
    if (op == Operator::bit_xor) op = Operator::logic_xor;
  }
  return program_.add_operator(op, a, b, text::join(program_.at(a).span, program_.at(b).span));
}

bool ExpressionReader::is_condition(ExpressionId id) const {
  const Operator op = program_.at(id).op;
  return is_comparison(op) || is_logic(op);
}

}  // namespace dripfeed::macro_b
