// The operands of expressions: brackets, numbers with units, names and functions. Functions are a table: what their
// arguments must be and what they give.
#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/expression_reader.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

using ir::Operator;

enum class Rule : std::uint8_t { angle_to_ratio, ratio_to_angle, ratio_to_ratio, root, same, legs_to_angle };
struct FunctionRow {
  std::string_view name;
  Operator op;
  int arguments;
  Rule rule;
};
constexpr auto kFunctions = std::to_array<FunctionRow>({
    {"sin", Operator::sin, 1, Rule::angle_to_ratio},
    {"cos", Operator::cos, 1, Rule::angle_to_ratio},
    {"tan", Operator::tan, 1, Rule::angle_to_ratio},
    {"asin", Operator::asin, 1, Rule::ratio_to_angle},
    {"acos", Operator::acos, 1, Rule::ratio_to_angle},
    {"atan", Operator::atan, 1, Rule::ratio_to_angle},
    {"atan2", Operator::atan2, 2, Rule::legs_to_angle},
    {"sqrt", Operator::sqrt, 1, Rule::root},
    {"abs", Operator::abs, 1, Rule::same},
    {"min", Operator::minimum, 2, Rule::same},
    {"max", Operator::maximum, 2, Rule::same},
    {"round", Operator::round, 1, Rule::ratio_to_ratio},
    {"trunc", Operator::truncate, 1, Rule::ratio_to_ratio},
    {"ln", Operator::ln, 1, Rule::ratio_to_ratio},
    {"exp", Operator::exp, 1, Rule::ratio_to_ratio},
    {"radians", Operator::multiply, 1, Rule::angle_to_ratio},  // by pi/180
});

const FunctionRow* find_function(std::string_view name) {
  const auto row = std::ranges::find(kFunctions, name, &FunctionRow::name);
  return row == kFunctions.end() ? nullptr : &*row;
}

constexpr std::int8_t half(std::int8_t exponent) { return static_cast<std::int8_t>(exponent / 2); }

}  // namespace

Typed ExpressionReader::primary() {
  if (cursor_.peek().kind == LexemeKind::number) return number();
  if (cursor_.peek().kind == LexemeKind::word) return name();
  const Depth depth(*this);
  if (!cursor_.line_failed() && cursor_.accept_symbol("(")) {
    const text::Span open = cursor_.last_span();
    Typed inner = disjunction();
    cursor_.expect_symbol(")");
    inner.span = {open.begin, cursor_.last_span().end};
    return inner;
  }
  cursor_.expected("a value");
  return {.span = cursor_.peek().span};
}

Typed ExpressionReader::constant(double stored, Dimension dimension, text::Span span) {
  Typed out{.dimension = dimension, .span = span};
  out.id = arena_.add_constant(stored, span);
  return out;
}

Typed ExpressionReader::number() {
  const std::optional<Literal> read = literal(true);
  if (!read) return {.span = cursor_.peek().span};
  const Quantity quantity{read->written, read->unit};
  Typed out = constant(quantity.stored(), read->unit == nullptr ? kRatio : read->unit->dimension, read->span);
  out.is_bare = read->unit == nullptr;
  return out;
}

// The unit after a number: one word, or three lexemes that touch each other (mm/min). `in` before a number and '..'
// opens a range and is no unit: "3 in 1..10" has no inches.
const Unit* ExpressionReader::unit_here(std::size_t& lexemes) const {
  if (cursor_.peek().kind != LexemeKind::word) return nullptr;
  const text::Span first = cursor_.peek().span;
  const Lexeme& third = cursor_.peek(2);
  if (cursor_.at_symbol("/", 1) && third.kind == LexemeKind::word && third.span.begin == first.end + 1) {
    lexemes = 3;
    if (const Unit* unit = find_unit(text::join(first, third.span).in(cursor_.text()))) return unit;
  }
  lexemes = 1;
  std::size_t after = cursor_.at_symbol("-", 1) ? 2 : 1;
  if (cursor_.at_word("in") && cursor_.peek(after).kind == LexemeKind::number) {
    for (++after; cursor_.peek(after).kind == LexemeKind::symbol || cursor_.peek(after).kind == LexemeKind::word;) {
      if (cursor_.at_symbol("..", after++)) return nullptr;
    }
  }
  return find_unit(cursor_.word());
}

std::optional<Literal> ExpressionReader::literal(bool unit_allowed) {
  const bool negative = cursor_.accept_symbol("-");
  const text::Span start = negative ? cursor_.last_span() : cursor_.peek().span;
  if (cursor_.peek().kind != LexemeKind::number) {
    cursor_.expected("a number");
    return std::nullopt;
  }
  const std::optional<text::Decimal> decimal = text::read_decimal(cursor_.word());
  cursor_.advance();
  Literal out{decimal ? decimal->value : 0.0, nullptr, text::join(start, cursor_.last_span())};
  if (negative) out.written = -out.written;
  std::size_t lexemes = 0;
  if (unit_allowed) out.unit = unit_here(lexemes);
  if (out.unit != nullptr) {
    for (std::size_t i = 0; i < lexemes; ++i) cursor_.advance();
    out.span.end = cursor_.last_span().end;
  }
  return out;
}

Typed ExpressionReader::name() {
  const std::string_view word = cursor_.word();
  const text::Span span = cursor_.peek().span;
  if (cursor_.at_symbol("(", 1)) return function();
  if (cursor_.accept_word("pi")) return constant(std::numbers::pi, kRatio, span);
  ir::Variable variable;
  variable.bank = ir::Bank::named;
  variable.span = span;
  Typed out{.dimension = kLength, .span = span};
  if (const auto axis = std::ranges::find(axis_variables_, word, &AxisVariable::word); axis != axis_variables_.end()) {
    variable.symbol = axis->symbol;
  } else if (const Scope::Name* known = scope_.find(word)) {
    variable.symbol = known->symbol;
    out.dimension = known->dimension;
  } else {
    return unknown_name(word, span);
  }
  cursor_.advance();
  out.id = arena_.add_variable(variable);
  return out;
}

Typed ExpressionReader::unknown_name(std::string_view word, text::Span span) {
  if (is_keyword(word)) {
    cursor_.expected("a value");
    return {.span = span};
  }
  text::Diagnostic fault = text::make_diagnostic(text::DiagnosticId::family_unknown_name, span, {std::string(word)});
  if (const std::string_view near = scope_.nearest(word); !near.empty()) {
    fault.notes.push_back({span, fmt::format("did you mean {}?", near)});
    fault.fix = text::Edit{span, std::string(near)};
  }
  cursor_.report(std::move(fault));
  return {.span = span};
}

Typed ExpressionReader::function() {
  const text::Span at = cursor_.peek().span;
  const FunctionRow* row = find_function(cursor_.word());
  if (row == nullptr) {
    cursor_.report(text::DiagnosticId::family_unknown_name, at, {std::string(cursor_.word())});
    return {.span = at};
  }
  const Depth depth(*this);
  cursor_.advance();
  cursor_.expect_symbol("(");
  const Typed a = cursor_.line_failed() ? Typed{} : sum();
  if (row->arguments == 2) cursor_.expect_symbol(",");
  const Typed b = cursor_.line_failed() || row->arguments == 1 ? a : sum();
  cursor_.expect_symbol(")");
  Typed out{.span = {at.begin, cursor_.last_span().end}};
  if (!is_value(a) || !is_value(b) || !function_dimension(row->name, a, b, out.dimension)) return out;
  if (row->name == "radians") {
    out = scaled(a, std::numbers::pi / 180.0);
    out.dimension = kRatio;
  } else {
    out = row->arguments == 1 ? make(row->op, {a}, out.dimension) : make(row->op, {a, b}, out.dimension);
  }
  out.span = {at.begin, cursor_.last_span().end};
  return out;
}

bool ExpressionReader::function_dimension(std::string_view name, const Typed& a, const Typed& b, Dimension& out) {
  switch (find_function(name)->rule) {
    case Rule::angle_to_ratio: out = kRatio; return require_dimension(a, kAngle);
    case Rule::ratio_to_angle: out = kAngle; return require_dimension(a, kRatio);
    case Rule::ratio_to_ratio: out = kRatio; return require_dimension(a, kRatio);
    case Rule::same: out = a.dimension; return same_dimension(a, b);
    case Rule::legs_to_angle: out = kAngle; return same_dimension(a, b);
    case Rule::root: break;
  }
  const Dimension d = a.dimension;
  out = {half(d.length), half(d.angle), half(d.time), half(d.revolution), half(d.surface)};
  if (out + out == d && time_scale(d) == 1.0 && time_scale(out) == 1.0) return true;
  wrong_unit(a, "something that has a square root");
  return false;
}

}  // namespace dripfeed::family
