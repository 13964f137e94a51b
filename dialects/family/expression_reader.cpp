// Recursive descent, one function a level of priority. A dimension is known as soon as an expression is read, so a
// fault is reported at the operator's operands and not somewhere above.
#include "dialects/family/expression_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

using ir::Operator;

// How a function's dimensions go: what its arguments must be and what it gives.
enum class Rule : std::uint8_t { angle_to_ratio, ratio_to_angle, ratio_to_ratio, root, same, legs_to_angle, radians };
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
    {"radians", Operator::multiply, 1, Rule::radians},
});

struct ComparisonRow {
  std::string_view symbol;
  Operator op;
};
constexpr auto kComparisons = std::to_array<ComparisonRow>({{"<", Operator::less},
                                                            {"<=", Operator::less_equal},
                                                            {">", Operator::greater},
                                                            {">=", Operator::greater_equal},
                                                            {"=", Operator::equal},
                                                            {"!=", Operator::not_equal}});

constexpr int kLargestExponent = 6;

}  // namespace

Typed ExpressionReader::value() {
  Typed typed = sum();
  is_value(typed);
  return typed;
}

Typed ExpressionReader::value_of(Dimension dimension) {
  Typed typed = value();
  require_dimension(typed, dimension);
  return typed;
}

Typed ExpressionReader::condition() {
  Typed typed = disjunction();
  if (!typed.is_condition) cursor_.syntax(typed.span, "expected a condition, found a value");
  return typed;
}

Typed ExpressionReader::logic(Operator op, const Typed& a, const Typed& b) {
  if (!a.is_condition || !b.is_condition) {
    cursor_.syntax(a.is_condition ? b.span : a.span, "expected a condition, found a value");
  }
  Typed out{.span = join(a.span, b.span)};
  out.is_condition = true;
  if (!cursor_.line_failed()) out.id = arena_.add_operator(op, a.id, b.id, out.span);
  return out;
}

Typed ExpressionReader::disjunction() {
  Typed left = conjunction();
  while (!cursor_.line_failed() && cursor_.accept_word("or")) left = logic(Operator::logic_or, left, conjunction());
  return left;
}

Typed ExpressionReader::conjunction() {
  Typed left = negation();
  while (!cursor_.line_failed() && cursor_.accept_word("and")) left = logic(Operator::logic_and, left, negation());
  return left;
}

Typed ExpressionReader::negation() {
  if (!cursor_.accept_word("not")) return comparison();
  const text::Span at = cursor_.last_span();
  Typed inner = negation();
  if (!inner.is_condition) cursor_.syntax(inner.span, "expected a condition, found a value");
  inner.span = join(at, inner.span);
  if (!cursor_.line_failed())
    inner.id = arena_.add_operator(Operator::logic_not, inner.id, ir::ExpressionId::none, inner.span);
  return inner;
}

Typed ExpressionReader::comparison() {
  Typed left = sum();
  const auto row =
      std::ranges::find_if(kComparisons, [&](const ComparisonRow& r) { return cursor_.at_symbol(r.symbol); });
  if (row == kComparisons.end() || cursor_.line_failed()) return left;
  cursor_.advance();
  const Typed right = sum();
  if (!is_value(left) || !is_value(right) || !same_dimension(left, right)) return left;
  Typed out{.span = join(left.span, right.span)};
  out.is_condition = true;
  out.id = arena_.add_operator(row->op, left.id, right.id, out.span);
  return out;
}

Typed ExpressionReader::sum() {
  Typed left = product();
  while (!cursor_.line_failed() && (cursor_.at_symbol("+") || cursor_.at_symbol("-"))) {
    const bool adds = cursor_.at_symbol("+");
    cursor_.advance();
    const Typed right = product();
    if (!is_value(left) || !is_value(right) || !same_dimension(left, right)) return left;
    const bool bare = left.is_bare && right.is_bare;
    left.span = join(left.span, right.span);
    left.id = arena_.add_operator(adds ? Operator::add : Operator::subtract, left.id, right.id, left.span);
    left.is_bare = bare;
  }
  return left;
}

Typed ExpressionReader::product() {
  Typed left = sign();
  while (!cursor_.line_failed() && (cursor_.at_symbol("*") || cursor_.at_symbol("/"))) {
    const Operator op = cursor_.at_symbol("*") ? Operator::multiply : Operator::divide;
    cursor_.advance();
    const Typed right = sign();
    if (!is_value(left) || !is_value(right)) return left;
    left = combine(op, left, right);
  }
  return left;
}

// A product or quotient. Stored units make one except where times meet: seconds alone, minutes in company.
Typed ExpressionReader::combine(Operator op, const Typed& a, const Typed& b) {
  if (cursor_.line_failed()) return a;
  const bool divides = op == Operator::divide;
  Typed out{.dimension = divides ? a.dimension - b.dimension : a.dimension + b.dimension,
            .is_bare = a.is_bare && b.is_bare,
            .span = join(a.span, b.span)};
  out.id = arena_.add_operator(op, a.id, b.id, out.span);
  const double right = time_scale(b.dimension);
  const double factor = time_scale(a.dimension) * (divides ? 1.0 / right : right) / time_scale(out.dimension);
  return scaled(out, factor);
}

Typed ExpressionReader::scaled(Typed typed, double factor) {
  if (factor != 1.0) {
    typed.id = arena_.add_operator(Operator::multiply, typed.id, arena_.add_constant(factor, typed.span), typed.span);
  }
  return typed;
}

Typed ExpressionReader::sign() {
  if (cursor_.accept_symbol("+")) return sign();
  if (!cursor_.accept_symbol("-")) return power();
  const text::Span at = cursor_.last_span();
  Typed inner = sign();
  if (!is_value(inner)) return inner;
  inner.span = join(at, inner.span);
  if (!cursor_.line_failed())
    inner.id = arena_.add_operator(Operator::negate, inner.id, ir::ExpressionId::none, inner.span);
  return inner;
}

// a^n as a product of n factors: no control calculates powers in the same way.
Typed ExpressionReader::power() {
  Typed base = primary();
  if (cursor_.line_failed() || !cursor_.accept_symbol("^")) return base;
  if (!is_value(base)) return base;
  const bool inverse = cursor_.accept_symbol("-");
  const text::Span at = cursor_.peek().span;
  const std::int32_t exponent = cursor_.expect_integer("a whole exponent");
  if (cursor_.line_failed()) return base;
  if (exponent < 1 || exponent > kLargestExponent) {
    cursor_.syntax(at, fmt::format("exponents go from 1 to {}", kLargestExponent));
    return base;
  }
  Typed out = base;
  for (std::int32_t i = 1; i < exponent; ++i) out = combine(Operator::multiply, out, base);
  return inverse ? combine(Operator::divide, constant(1.0, kRatio, at), out) : out;
}

Typed ExpressionReader::primary() {
  if (cursor_.accept_symbol("(")) {
    const text::Span open = cursor_.last_span();
    Typed inner = disjunction();
    cursor_.expect_symbol(")");
    inner.span = {open.begin, cursor_.last_span().end};
    return inner;
  }
  if (cursor_.peek().kind == LexemeKind::number) return number();
  if (cursor_.peek().kind == LexemeKind::word) return name();
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

// The unit after a number, in up to three lexemes (mm / min) that touch each other. `in` before a number and '..' opens
// a range: "3 in 1..10" has no inches.
const Unit* ExpressionReader::unit_here(std::size_t& lexemes) const {
  if (cursor_.peek().kind != LexemeKind::word) return nullptr;
  const text::Span first = cursor_.peek().span;
  if (cursor_.at_symbol("/", 1) && cursor_.peek(2).kind == LexemeKind::word &&
      cursor_.peek(2).span.begin == first.end + 1) {
    lexemes = 3;
    if (const Unit* unit = find_unit(text::join(first, cursor_.peek(2).span).in(cursor_.text()))) return unit;
  }
  lexemes = 1;
  const std::size_t after = cursor_.at_symbol("-", 1) ? 2 : 1;
  if (cursor_.at_word("in") && cursor_.peek(after).kind == LexemeKind::number) {
    for (std::size_t i = after + 1;
         cursor_.peek(i).kind == LexemeKind::symbol || cursor_.peek(i).kind == LexemeKind::word; ++i) {
      if (cursor_.at_symbol("..", i)) return nullptr;
    }
  }
  return find_unit(cursor_.word());
}

std::optional<ExpressionReader::Literal> ExpressionReader::literal(bool unit_allowed) {
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
  Dimension dimension = kLength;
  if (word == "z" && free_variable_ != ir::SymbolId::none) {
    variable.symbol = free_variable_;
  } else if (const Scope::Name* known = scope_.find(word)) {
    variable.symbol = known->symbol;
    dimension = known->dimension;
  } else if (is_keyword(word)) {
    cursor_.expected("a value");
    return {.span = span};
  } else {
    text::Diagnostic fault = text::make_diagnostic(text::DiagnosticId::family_unknown_name, span, {std::string(word)});
    if (const std::string_view near = scope_.nearest(word); !near.empty()) {
      fault.notes.push_back({span, fmt::format("did you mean {}?", near)});
      fault.fix = text::Edit{span, std::string(near)};
    }
    cursor_.report(std::move(fault));
    return {.span = span};
  }
  cursor_.advance();
  Typed out{.dimension = dimension, .span = span};
  out.id = arena_.add_variable(variable);
  return out;
}

Typed ExpressionReader::function() {
  const text::Span at = cursor_.peek().span;
  const auto row = std::ranges::find(kFunctions, cursor_.word(), &FunctionRow::name);
  if (row == kFunctions.end()) {
    cursor_.report(text::DiagnosticId::family_unknown_name, at, {std::string(cursor_.word())});
    return {.span = at};
  }
  cursor_.advance();
  cursor_.expect_symbol("(");
  Typed a = sum();
  Typed b;
  if (row->arguments == 2) {
    cursor_.expect_symbol(",");
    b = sum();
  }
  cursor_.expect_symbol(")");
  Typed out{.span = {at.begin, cursor_.last_span().end}};
  if (cursor_.line_failed() || !is_value(a) || (row->arguments == 2 && !is_value(b))) return out;
  switch (row->rule) {
    case Rule::angle_to_ratio:
    case Rule::radians: require_dimension(a, kAngle); break;
    case Rule::ratio_to_angle:
      require_dimension(a, kRatio);
      out.dimension = kAngle;
      break;
    case Rule::ratio_to_ratio: require_dimension(a, kRatio); break;
    case Rule::root: {
      const auto half = [](std::int8_t n) { return static_cast<std::int8_t>(n / 2); };
      const Dimension d = a.dimension;
      out.dimension = {half(d.length), half(d.angle), half(d.time), half(d.revolution), half(d.surface)};
      if (out.dimension + out.dimension != d || time_scale(d) != 1.0 || time_scale(out.dimension) != 1.0) {
        wrong_unit(a, "something that has a square root");
      }
      break;
    }
    case Rule::same:
      if (row->arguments == 2 && !same_dimension(a, b)) return out;
      out.dimension = a.dimension;
      out.is_bare = a.is_bare && (row->arguments == 1 || b.is_bare);
      break;
    case Rule::legs_to_angle:
      if (!same_dimension(a, b)) return out;
      out.dimension = kAngle;
      break;
  }
  if (cursor_.line_failed()) return out;
  if (row->rule == Rule::radians) {
    out.id = a.id;
    return scaled(out, std::numbers::pi / 180.0);
  }
  out.id = arena_.add_operator(row->op, a.id, b.id, out.span);
  return out;
}

bool ExpressionReader::is_value(const Typed& typed) {
  if (typed.is_condition) cursor_.syntax(typed.span, "expected a value, found a condition");
  return !cursor_.line_failed();
}

bool ExpressionReader::require_dimension(const Typed& typed, Dimension wanted) {
  if (cursor_.line_failed()) return false;
  if (typed.dimension == wanted) return true;
  if (!typed.is_bare) {
    wrong_unit(typed, describe(wanted));
    return false;
  }
  const std::string written(typed.span.in(cursor_.text()));
  text::Diagnostic fault =
      text::make_diagnostic(text::DiagnosticId::family_missing_unit, typed.span, {written, describe(wanted)});
  if (const std::string_view unit = stored_unit(wanted); !unit.empty()) {
    fault.arguments.back() += fmt::format(", such as {} {}", written, unit);
    fault.fix = text::Edit{{typed.span.end, typed.span.end}, fmt::format(" {}", unit)};
    fault.notes.push_back({typed.span, fmt::format("write {} {}", written, unit)});
  }
  cursor_.report(std::move(fault));
  return false;
}

bool ExpressionReader::same_dimension(const Typed& a, const Typed& b) {
  if (cursor_.line_failed()) return false;
  if (a.dimension == b.dimension) return true;
  if (a.is_bare) return require_dimension(a, b.dimension);
  if (b.is_bare) return require_dimension(b, a.dimension);
  wrong_unit(b, describe(a.dimension));
  return false;
}

void ExpressionReader::wrong_unit(const Typed& typed, std::string wanted) {
  const std::string written(typed.span.in(cursor_.text()));
  cursor_.report(text::DiagnosticId::family_wrong_unit, typed.span,
                 {written, describe(typed.dimension), std::move(wanted)});
}

}  // namespace dripfeed::family
