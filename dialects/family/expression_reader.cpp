// Recursive descent, one function a level of priority. A dimension is known as soon as an expression is read, so a
// fault is reported at the operator's operands and not somewhere above.
#include "dialects/family/expression_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace dripfeed::family {

namespace {

using ir::Operator;

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
constexpr int kDeepestNesting = 50;

}  // namespace

ExpressionReader::Depth::Depth(ExpressionReader& reader) : depth_(reader.depth_) {
  if (++depth_ > kDeepestNesting) {
    reader.cursor_.syntax(reader.cursor_.peek().span, "the expression is nested too deep");
  }
}

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
  is_condition(typed);
  return typed;
}

Typed ExpressionReader::disjunction() {
  Typed left = conjunction();
  while (!cursor_.line_failed() && cursor_.accept_word("or")) {
    const Typed right = conjunction();
    if (is_condition(left) && is_condition(right)) left = make(Operator::logic_or, {left, right}, kRatio);
  }
  return left;
}

Typed ExpressionReader::conjunction() {
  Typed left = negation();
  while (!cursor_.line_failed() && cursor_.accept_word("and")) {
    const Typed right = negation();
    if (is_condition(left) && is_condition(right)) left = make(Operator::logic_and, {left, right}, kRatio);
  }
  return left;
}

Typed ExpressionReader::negation() {
  if (!cursor_.accept_word("not")) return comparison();
  const Depth depth(*this);
  if (cursor_.line_failed()) return {};
  const Typed inner = negation();
  return is_condition(inner) ? make(Operator::logic_not, {inner}, kRatio) : inner;
}

Typed ExpressionReader::comparison() {
  Typed left = sum();
  const auto row =
      std::ranges::find_if(kComparisons, [&](const ComparisonRow& r) { return cursor_.at_symbol(r.symbol); });
  if (row == kComparisons.end() || cursor_.line_failed()) return left;
  cursor_.advance();
  const Typed right = sum();
  if (!is_value(left) || !is_value(right) || !same_dimension(left, right)) return left;
  Typed out = make(row->op, {left, right}, kRatio);
  out.is_condition = true;
  out.is_bare = false;
  return out;
}

Typed ExpressionReader::sum() {
  Typed left = product();
  while (!cursor_.line_failed() && (cursor_.at_symbol("+") || cursor_.at_symbol("-"))) {
    const Operator op = cursor_.at_symbol("+") ? Operator::add : Operator::subtract;
    cursor_.advance();
    const Typed right = product();
    if (is_value(left) && is_value(right) && same_dimension(left, right))
      left = make(op, {left, right}, left.dimension);
  }
  return left;
}

Typed ExpressionReader::product() {
  Typed left = sign();
  while (!cursor_.line_failed() && (cursor_.at_symbol("*") || cursor_.at_symbol("/"))) {
    const Operator op = cursor_.at_symbol("*") ? Operator::multiply : Operator::divide;
    cursor_.advance();
    const Typed right = sign();
    if (is_value(left) && is_value(right)) left = product_of(op, left, right);
  }
  return left;
}

// A product or quotient. Stored units make one except where times meet: seconds alone, minutes in company.
Typed ExpressionReader::product_of(Operator op, const Typed& a, const Typed& b) {
  const bool divides = op == Operator::divide;
  const Dimension dimension = divides ? a.dimension - b.dimension : a.dimension + b.dimension;
  const double right = time_scale(b.dimension);
  const double factor = time_scale(a.dimension) * (divides ? 1.0 / right : right) / time_scale(dimension);
  return scaled(make(op, {a, b}, dimension), factor);
}

Typed ExpressionReader::scaled(const Typed& typed, double factor) {
  if (factor == 1.0) return typed;
  Typed out = make(Operator::multiply, {typed, constant(factor, kRatio, typed.span)}, typed.dimension);
  out.is_bare = typed.is_bare;
  return out;
}

Typed ExpressionReader::sign() {
  const bool negative = cursor_.at_symbol("-");
  if (!negative && !cursor_.at_symbol("+")) return power();
  cursor_.advance();
  const text::Span at = cursor_.last_span();
  const Depth depth(*this);
  if (cursor_.line_failed()) return {};
  Typed out = sign();
  if (is_value(out) && negative) out = make(Operator::negate, {out}, out.dimension);
  out.span = text::join(at, out.span);
  return out;
}

// a^n as a product of n factors: no two controls calculate powers alike.
Typed ExpressionReader::power() {
  const Typed base = primary();
  if (cursor_.line_failed() || !cursor_.at_symbol("^") || !is_value(base)) return base;
  cursor_.advance();
  const text::Span at = cursor_.peek().span;
  const bool inverse = cursor_.accept_symbol("-");
  const std::int32_t exponent = cursor_.expect_integer("a whole exponent");
  if (!cursor_.line_failed() && (exponent < 1 || exponent > kLargestExponent)) {
    cursor_.syntax(at, fmt::format("exponents go from 1 to {}", kLargestExponent));
  }
  if (cursor_.line_failed()) return base;
  Typed out = base;
  for (std::int32_t i = 1; i < exponent; ++i) out = product_of(Operator::multiply, out, base);
  if (inverse) out = product_of(Operator::divide, constant(1.0, kRatio, at), out);
  out.span = {base.span.begin, cursor_.last_span().end};
  return out;
}

Typed ExpressionReader::make(Operator op, std::initializer_list<Typed> operands, Dimension dimension) {
  Typed out = *operands.begin();
  const Typed& last = *(operands.end() - 1);
  out.dimension = dimension;
  out.span = text::join(out.span, last.span);
  if (operands.size() == 2) {
    out.is_bare = out.is_bare && last.is_bare;
    out.size += last.size;
  }
  if (++out.size > kLargestTree) cursor_.syntax(out.span, "the expression is too long");
  if (cursor_.line_failed()) return out;
  out.id = arena_.add_operator(op, out.id, operands.size() == 2 ? last.id : ir::ExpressionId::none, out.span);
  return out;
}

bool ExpressionReader::is_value(const Typed& typed) {
  if (typed.is_condition) cursor_.syntax(typed.span, "expected a value, found a condition");
  return !cursor_.line_failed();
}

bool ExpressionReader::is_condition(const Typed& typed) {
  if (!typed.is_condition) cursor_.syntax(typed.span, "expected a condition, found a value");
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
    fault.fix = text::Edit{{typed.span.end, typed.span.end}, fmt::format(" {}", unit)};
    fault.notes.push_back({typed.span, fmt::format("for example {} {}", written, unit)});
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
