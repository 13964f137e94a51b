// A parameter that changes nothing would mislead whoever orders a part, so each has to reach the program.
#include "dialects/family/native_reader.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "dialects/passes/walk.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::family {

namespace {

// "#100", "R10", "DIA", "TURNING_CYCLE.EXTD": at most one point, and names on both sides of it.
bool is_target(std::string_view word) {
  if (word.starts_with('#')) return word.size() > 1;
  const auto is_name = [](std::string_view name) {
    return !name.empty() && !name.contains('.') && !(name.front() >= '0' && name.front() <= '9');
  };
  const std::size_t point = word.find('.');
  if (point == std::string_view::npos) return is_name(word);
  return is_name(word.substr(0, point)) && is_name(word.substr(point + 1));
}

}  // namespace

void NativeReader::target(ir::SymbolId symbol, Dimension dimension, const Unit* unit) {
  if (cursor_.line_failed() || !cursor_.accept_word("is")) return;
  if (cursor_.peek().kind != LexemeKind::word || !is_target(cursor_.word()))
    return cursor_.expected("what takes the value: #100, R10, a name, or PROGRAM.PARAMETER");
  const auto parameter = std::ranges::find(family_.parameters, symbol, &Parameter::symbol);
  if (parameter != family_.parameters.end() &&
      (parameter->kind == ParameterKind::list || parameter->kind == ParameterKind::choice ||
       parameter->kind == ParameterKind::text))
    return cursor_.syntax(cursor_.last_span(),
                          fmt::format("{} is not a number: bind a let that is computed from it", parameter->name));
  family_.bindings.push_back({.symbol = symbol,
                              .dimension = dimension,
                              .unit = unit,
                              .target = text::upper_case(cursor_.word()),
                              .span = cursor_.peek().span});
  cursor_.advance();
}

void NativeReader::dialect() {
  const text::Span at = cursor_.peek().span;
  std::string name = cursor_.expect_hyphenated("the program's language: fanuc, sinumerik-840d ...");
  const auto begin = native_begin(cursor_.text());
  family_.native = NativeText{.dialect = std::move(name),
                              .dialect_span = {at.begin, cursor_.last_span().end},
                              .text = {begin, static_cast<std::uint32_t>(cursor_.text().size())}};
  cursor_.finish_line();
}

void NativeReader::check() {
  if (!family_.native) {
    if (!family_.bindings.empty())
      fault(family_.bindings.front().span, "'is' names a place in a native program, and the family has none");
    return;
  }
  check_targets_differ();
  // A line that was left out may have had the target.
  if (!text::has_error(cursor_.diagnostics)) check_parameters_are_used();
}

void NativeReader::check_targets_differ() {
  std::set<std::string_view> taken;
  for (const Binding& binding : family_.bindings) {
    if (!taken.insert(binding.target).second)
      fault(binding.span, fmt::format("{} takes one value, and an earlier line gives it one", binding.target));
  }
}

void NativeReader::check_parameters_are_used() {
  std::set<ir::SymbolId> used;
  for (const Binding& binding : family_.bindings) used.insert(binding.symbol);
  const auto use = [&](ir::ExpressionId value) {
    passes::for_each_node(family_.arena, value, [&](ir::ExpressionId id) {
      const ir::Expression& e = family_.arena.at(id);
      if (e.op == ir::Operator::variable) used.insert(family_.arena.at(e.variable).symbol);
    });
  };
  for (std::size_t before = 0; before != used.size();) {
    before = used.size();
    for (const Definition& let : family_.definitions)
      if (used.contains(let.symbol)) use(let.value);
    for (const List& list : family_.lists)
      if (used.contains(list.symbol)) std::ranges::for_each(list.elements, use);
  }
  for (const Parameter& parameter : family_.parameters) {
    if (!used.contains(parameter.symbol))
      fault(parameter.span,
            fmt::format("{0} changes nothing: state what takes its value ({0} ... is #100)", parameter.name));
  }
}

void NativeReader::fault(text::Span span, std::string sentence) {
  cursor_.diagnostics.push_back(text::make_diagnostic(text::DiagnosticId::family_syntax, span, {std::move(sentence)}));
}

}  // namespace dripfeed::family
