// One function a kind. A name stays known when its line is wrong, so that its uses are not reported as well.
#include "dialects/family/parameter_reader.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/text_value.h"

namespace dripfeed::family {

namespace {

constexpr auto kQuantities = std::to_array<QuantityKind>({
    {"length", kLength, kLength},
    {"angle", kAngle, kAngle},
    {"feed", kFeedPerMin, kFeedPerRev},
    {"speed", kSpeed, kSurfaceSpeed},
    {"time", kTime, kTime},
    {"count", kRatio, kRatio, true},
    {"ratio", kRatio, kRatio},
});

NameKind name_kind_of(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::number:
    case ParameterKind::tool: return NameKind::value;
    case ParameterKind::choice: return NameKind::choice;
    case ParameterKind::yes_no: return NameKind::yes_no;
    case ParameterKind::list: return NameKind::list;
    case ParameterKind::text: return NameKind::text;
  }
  return NameKind::value;
}

}  // namespace

const QuantityKind* find_quantity(std::string_view name) {
  const auto row = std::ranges::find(kQuantities, name, &QuantityKind::name);
  return row == kQuantities.end() ? nullptr : &*row;
}

void add_list(Family& family, Scope& scope, const NewName& name, List list, std::int32_t most) {
  list.symbol = scope.define(family.arena, name.name, list.dimension, name.span, NameKind::list);
  family.arena.symbols[static_cast<std::size_t>(list.symbol)].dimension1 = static_cast<std::uint16_t>(most);
  ir::Symbol count;
  count.name = family.arena.strings.add("count_" + name.name);
  count.span = name.span;
  list.count = family.arena.add(count);
  family.lists.push_back(std::move(list));
}

void ParameterReader::read() {
  const std::uint32_t line = cursor_.peek().line;
  const std::optional<NewName> name = expect_new_name(cursor_, scope_);
  if (!name) return;
  Parameter out;
  out.name = name->name;
  out.span = name->span;
  if (const QuantityKind* kind = find_quantity(cursor_.word())) {
    cursor_.advance();
    number(out, *kind);
  } else if (cursor_.accept_word("list")) {
    cursor_.expect_word("of");
    if (!cursor_.line_failed() && cursor_.accept_word("points")) return points(*name, line);
    list(out);
  } else if (cursor_.accept_word("choice")) {
    choice(out);
  } else if (cursor_.accept_word("yes_no")) {
    yes_no(out);
  } else if (cursor_.accept_word("tool")) {
    tool(out);
  } else if (cursor_.accept_word("text")) {
    name_text(out);
  } else {
    return cursor_.expected(fmt::format("{}, list, choice, yes_no, tool or text", kQuantityNames));
  }
  if (!cursor_.line_failed()) trailer(out);
  if (out.kind == ParameterKind::list) {
    define_list(out, *name, line);
  } else {
    out.symbol = scope_.define(family_.arena, out.name, out.dimension, out.span, name_kind_of(out.kind));
  }
  family_.parameters.push_back(std::move(out));
}

void ParameterReader::define_list(Parameter& out, const NewName& name, std::uint32_t line) {
  add_list(family_, scope_, name, {.dimension = out.dimension, .elements = {}, .line = line}, std::max(out.most, 1));
  out.symbol = family_.lists.back().symbol;
}

// A default of that kind: stored, or nothing after a fault. Its unit is the parameter's.
std::optional<double> ParameterReader::standard(Parameter& out, const QuantityKind& kind) {
  const auto literal = expressions_.literal(true);
  if (!literal || !has_kind(*literal, kind)) return std::nullopt;
  if (out.standards.empty()) {
    out.unit = literal->unit;
    out.dimension = out.unit == nullptr ? kRatio : out.unit->dimension;
  } else {
    const Typed typed{.dimension = literal->unit == nullptr ? kRatio : literal->unit->dimension,
                      .is_bare = literal->unit == nullptr,
                      .span = literal->span};
    if (!expressions_.require_dimension(typed, out.dimension)) return std::nullopt;
  }
  return Quantity{literal->written, literal->unit}.stored();
}

void ParameterReader::number(Parameter& out, const QuantityKind& kind) {
  out.whole = kind.whole;
  out.quantity = kind.name;
  out.dimension = kind.first;
  const text::Span at = cursor_.peek().span;
  const auto value = standard(out, kind);
  if (!value) return;
  out.standard = *value;
  const text::Span written{at.begin, cursor_.last_span().end};
  range(out);
  if (!cursor_.line_failed()) check(out, out.standard, written);
}

// list of KIND value, value, ... in low .. high count fewest .. most
void ParameterReader::list(Parameter& out) {
  out.kind = ParameterKind::list;
  const QuantityKind* kind = cursor_.line_failed() ? nullptr : find_quantity(cursor_.word());
  if (kind == nullptr) return cursor_.expected(kQuantityNames);
  cursor_.advance();
  out.whole = kind->whole;
  out.quantity = kind->name;
  out.dimension = kind->first;
  std::vector<text::Span> written;
  do {
    const text::Span at = cursor_.peek().span;
    const auto value = standard(out, *kind);
    if (!value) return;
    out.standards.push_back(*value);
    written.push_back({at.begin, cursor_.last_span().end});
  } while (cursor_.accept_symbol(","));
  range(out);
  if (!cursor_.line_failed()) count_range(out, out.standards.size(), "numbers", kMostNumbers);
  for (std::size_t i = 0; i < written.size() && !cursor_.line_failed(); ++i) check(out, out.standards[i], written[i]);
}

void ParameterReader::count_range(Parameter& out, std::size_t given, std::string_view called, std::int32_t largest) {
  if (!cursor_.expect_word("count")) return;
  out.fewest = cursor_.expect_integer("the least number of values");
  cursor_.expect_symbol("..");
  if (cursor_.line_failed()) return;
  const text::Span at = cursor_.peek().span;
  out.most = cursor_.expect_integer("the largest number of values");
  if (cursor_.line_failed()) return;
  const std::int32_t least = out.kind == ParameterKind::text ? 0 : 1;
  if (out.fewest < least || out.fewest > out.most || out.most > largest) {
    cursor_.syntax(at, fmt::format("{} to {} {} are possible here, the least count first", least, largest, called));
  } else if (std::cmp_less(given, out.fewest) || std::cmp_greater(given, out.most)) {
    cursor_.syntax(out.span,
                   fmt::format("the default has {} {}, {} to {} are allowed", given, called, out.fewest, out.most));
  }
}

// choice WORD of WORD, WORD, ...
void ParameterReader::choice(Parameter& out) {
  out.kind = ParameterKind::choice;
  const text::Span at = cursor_.peek().span;
  const auto word = [&] {
    if (cursor_.peek().kind != LexemeKind::word) cursor_.expected("a word");
    std::string read(cursor_.word());
    if (!cursor_.line_failed()) cursor_.advance();
    return read;
  };
  const std::string standard = word();
  if (cursor_.line_failed() || !cursor_.expect_word("of")) return;
  do {
    const text::Span here = cursor_.peek().span;
    std::string one = word();
    if (std::ranges::find(out.choices, one) != out.choices.end())
      cursor_.syntax(here, fmt::format("{} is named twice", one));
    out.choices.push_back(std::move(one));
  } while (!cursor_.line_failed() && cursor_.accept_symbol(","));
  const auto place = std::ranges::find(out.choices, standard);
  if (!cursor_.line_failed() && place == out.choices.end())
    return cursor_.syntax(at, fmt::format("the default {} is not among the choices", standard));
  out.standard = static_cast<double>(place - out.choices.begin());
}

void ParameterReader::yes_no(Parameter& out) {
  out.kind = ParameterKind::yes_no;
  out.choices = {"no", "yes"};
  out.standard = cursor_.at_word("yes") ? 1.0 : 0.0;
  if (!cursor_.accept_word("yes") && !cursor_.accept_word("no")) cursor_.expected("yes or no");
}

void ParameterReader::tool(Parameter& out) {
  out.kind = ParameterKind::tool;
  out.whole = true;
  const text::Span at = cursor_.peek().span;
  out.standard = cursor_.expect_integer("the number of a tool");
  if (cursor_.line_failed()) return;
  range(out);
  if (!cursor_.line_failed()) check(out, out.standard, at);
}

// text "..." count FEWEST .. MOST
void ParameterReader::name_text(Parameter& out) {
  out.kind = ParameterKind::text;
  const text::Span at = cursor_.peek().span;
  auto written = cursor_.accept_string();
  if (!written) return cursor_.expected("the default in quotes");
  out.standard_text = std::move(*written);
  if (const std::string fault = fault_of_text(out.standard_text); !fault.empty()) return cursor_.syntax(at, fault);
  count_range(out, out.standard_text.size(), "characters", kLongestText);
}

void ParameterReader::range(Parameter& out) {
  cursor_.expect_word("in");
  const auto low = bound(out);
  cursor_.expect_symbol("..");
  const auto high = bound(out);
  if (cursor_.line_failed() || !low || !high) return;
  out.low = *low;
  out.high = *high;
  if (out.low > out.high) cursor_.syntax(out.span, fmt::format("the range of {} ends before it begins", out.name));
}

void ParameterReader::trailer(Parameter& out) {
  const bool has_range = out.kind == ParameterKind::number || out.kind == ParameterKind::list;
  if (has_range && cursor_.accept_word("step")) {
    const text::Span at = cursor_.peek().span;
    if (const auto step = bound(out)) out.step = *step;
    if (!cursor_.line_failed() && !(out.step > 0.0)) return cursor_.syntax(at, "a step is larger than 0");
    if (!cursor_.line_failed() && out.kind == ParameterKind::number) check(out, out.standard, out.span);
    for (const double one : out.standards) check(out, one, out.span);
  }
  if (auto text = cursor_.accept_string()) out.text = std::move(*text);
  if (!cursor_.line_failed() && cursor_.accept_word("group")) {
    if (auto group = cursor_.accept_string()) {
      out.group = std::move(*group);
    } else {
      cursor_.expected("the group's name in quotes");
    }
  }
}

// The default's unit must be one of the kind's.
bool ParameterReader::has_kind(const Literal& literal, const QuantityKind& kind) {
  const Dimension found = literal.unit == nullptr ? kRatio : literal.unit->dimension;
  if (found == kind.first || found == kind.second) return true;
  const Typed typed{.dimension = found, .is_bare = literal.unit == nullptr, .span = literal.span};
  return expressions_.require_dimension(typed, kind.first);
}

// One end of the range, stored unit.
std::optional<double> ParameterReader::bound(const Parameter& parameter) {
  const auto literal = expressions_.literal(parameter.unit != nullptr);
  if (!literal) return std::nullopt;
  const Unit* unit = literal->unit == nullptr ? parameter.unit : literal->unit;
  const Typed typed{.dimension = unit == nullptr ? kRatio : unit->dimension, .span = literal->span};
  if (!expressions_.require_dimension(typed, parameter.dimension)) return std::nullopt;
  return Quantity{literal->written, unit}.stored();
}

void ParameterReader::check(const Parameter& parameter, double value, text::Span span) {
  if (const auto fault = fault_of_value(parameter, value, std::string(span.in(cursor_.text()))))
    cursor_.report(fault->id, span, fault->arguments);
}

}  // namespace dripfeed::family
