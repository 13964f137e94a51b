// The operands of expressions: brackets, numbers with units, and names: of numbers, of lists with an index, of choices.
#include <algorithm>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/family/expression_reader.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

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
  if (unit_allowed) out.unit = unit();
  if (out.unit != nullptr) out.span.end = cursor_.last_span().end;
  return out;
}

const Unit* ExpressionReader::unit() {
  std::size_t lexemes = 0;
  const Unit* found = unit_here(lexemes);
  for (std::size_t i = 0; found != nullptr && i < lexemes; ++i) cursor_.advance();
  return found;
}

Typed ExpressionReader::name() {
  const std::string_view word = cursor_.word();
  const text::Span span = cursor_.peek().span;
  if (cursor_.at_symbol("(", 1)) return function();
  if (cursor_.accept_word("pi")) return constant(std::numbers::pi, kRatio, span);
  ir::Variable variable;
  variable.bank = ir::Bank::named;
  variable.span = span;
  if (const auto axis = std::ranges::find(axis_variables_, word, &AxisVariable::word); axis != axis_variables_.end()) {
    variable.symbol = axis->symbol;
    cursor_.advance();
    return {.id = arena_.add_variable(variable), .dimension = kLength, .span = span};
  }
  const Scope::Name* known = scope_.find(word);
  if (known == nullptr) return unknown_name(word, span);
  variable.symbol = known->symbol;
  return known_name(Scope::Name(*known), variable);
}

Typed ExpressionReader::known_name(const Scope::Name& known, ir::Variable variable) {
  Typed out{.dimension = known.dimension, .span = variable.span};
  cursor_.advance();
  if (known.kind == NameKind::choice) return choice(known, variable);
  if (known.kind == NameKind::text || known.kind == NameKind::points) {
    cursor_.syntax(out.span, known.kind == NameKind::text
                                 ? fmt::format("{} is a text: it stands in messages, and has no value", known.name)
                                 : fmt::format("{0} is a list of points: name a number of one axis, {0}.{1}[0]",
                                               known.name, family_.find_points(known.name)->axes.front()));
    return out;
  }
  if (known.kind == NameKind::list) {
    variable.index = index_of(known);
    variable.span.end = out.span.end = cursor_.last_span().end;
  }
  if (cursor_.line_failed()) return out;
  out.id = arena_.add_variable(variable);
  if (known.kind == NameKind::yes_no) {
    out = make(ir::Operator::not_equal, {out, constant(0.0, kRatio, out.span)}, kRatio);
    out.is_condition = true;
  }
  return out;
}

// "name is word".
Typed ExpressionReader::choice(const Scope::Name& known, ir::Variable variable) {
  Typed out{.span = variable.span};
  if (!cursor_.expect_word("is")) return out;
  const Parameter& parameter = *family_.find_parameter(known.name);
  const auto word = std::ranges::find(parameter.choices, cursor_.word());
  if (word == parameter.choices.end()) {
    cursor_.expected(fmt::format("{}", fmt::join(parameter.choices, " or ")));
    return out;
  }
  cursor_.advance();
  out.id = arena_.add_variable(variable);
  out.span.end = cursor_.last_span().end;
  const auto place = static_cast<double>(word - parameter.choices.begin());
  out = make(ir::Operator::equal, {out, constant(place, kRatio, out.span)}, kRatio);
  out.is_condition = true;
  return out;
}

// "[" index "]" of a list; a constant one must be one of the list's.
ir::ExpressionId ExpressionReader::index_of(const Scope::Name& list) {
  if (!cursor_.at_symbol("[")) {
    cursor_.syntax(cursor_.last_span(),
                   fmt::format("{} is a list: name one of its numbers, {}[0]", list.name, list.name));
    return ir::ExpressionId::none;
  }
  const Depth depth(*this);
  if (cursor_.line_failed()) return ir::ExpressionId::none;
  cursor_.advance();
  const Typed index = value_of(kRatio);
  cursor_.expect_symbol("]");
  if (cursor_.line_failed()) return ir::ExpressionId::none;
  const ir::Expression& e = arena_.at(index.id);
  const std::uint16_t most = arena_.at(list.symbol).dimension1;
  if (e.op == ir::Operator::constant && (e.value >= most || !is_whole(e.value)))
    cursor_.syntax(index.span, fmt::format("{} has the numbers [0] to [{}]", list.name, most - 1));
  return index.id;
}

std::optional<ExpressionReader::Place> ExpressionReader::place() {
  const text::Span at = cursor_.peek().span;
  const Scope::Name* known = cursor_.peek().kind == LexemeKind::word ? scope_.find(cursor_.word()) : nullptr;
  if (known == nullptr) {
    if (cursor_.peek().kind == LexemeKind::word) {
      unknown_name(cursor_.word(), at);
    } else {
      cursor_.expected("a name");
    }
    return std::nullopt;
  }
  Place out{*known};
  if (out.name.kind != NameKind::variable && out.name.kind != NameKind::list) {
    cursor_.syntax(at, fmt::format("{} cannot be set: only a let of the program or a list can", out.name.name));
    return std::nullopt;
  }
  cursor_.advance();
  if (out.name.kind == NameKind::list) out.index = index_of(out.name);
  if (cursor_.line_failed()) return std::nullopt;
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

}  // namespace dripfeed::family
