// The names of a routine are its own for ever: what stands in for them, or is assigned to them, meets no other name.
#include "dialects/family/routine_reader.h"

#include <utility>

#include <fmt/format.h>

#include "dialects/family/body_reader.h"
#include "dialects/family/evaluate.h"
#include "dialects/family/naming.h"
#include "dialects/family/parameter_reader.h"

namespace dripfeed::family {

std::optional<std::string> RoutineReader::new_name() {
  const std::optional<NewName> name = expect_new_name(cursor_, scope_);
  if (!name) return std::nullopt;
  const bool is_taken = family_.find_function(name->name) != nullptr || family_.find_subprogram(name->name) != nullptr;
  if (!is_taken) return name->name;
  cursor_.report(text::DiagnosticId::family_duplicate_name, name->span, {name->name});
  return std::nullopt;
}

std::optional<Dimension> RoutineReader::dimension() {
  const QuantityKind* kind = cursor_.line_failed() ? nullptr : find_quantity(cursor_.word());
  if (kind == nullptr) {
    cursor_.expected(kQuantityNames);
    return std::nullopt;
  }
  cursor_.advance();
  if (kind->first == kind->second) return kind->first;
  const text::Span at = cursor_.peek().span;
  const Unit* unit = expressions_.unit();
  if (unit != nullptr && (unit->dimension == kind->first || unit->dimension == kind->second)) return unit->dimension;
  cursor_.syntax(at, fmt::format("a {} needs its unit here, such as {} {}", kind->name, kind->name,
                                 kind->first == kSpeed ? "rpm" : "mm/min"));
  return std::nullopt;
}

std::vector<FunctionParameter> RoutineReader::parameters() {
  std::vector<FunctionParameter> out;
  if (!cursor_.accept_symbol("(")) return out;
  do {
    const std::optional<NewName> name = expect_new_name(cursor_, scope_);
    if (!name) return out;
    const std::optional<Dimension> of = dimension();
    if (!of) return out;
    out.push_back({scope_.define(family_.arena, name->name, *of, name->span), *of});
  } while (cursor_.accept_symbol(","));
  cursor_.expect_symbol(")");
  return out;
}

void RoutineReader::function() {
  const std::optional<std::string> name = new_name();
  if (!name) return;
  scope_.open();
  UserFunction out;
  out.name = *name;
  out.parameters = parameters();
  if (!cursor_.line_failed() && out.parameters.empty()) cursor_.expected("'(' and a parameter");
  cursor_.expect_symbol("=");
  const Typed value = cursor_.line_failed() ? Typed{} : expressions_.value_or_condition();
  scope_.seal();
  if (cursor_.line_failed()) return;
  out.value = value.id;
  out.dimension = value.dimension;
  out.is_condition = value.is_condition;
  out.size = value.size;
  for (FunctionParameter& one : out.parameters) one.uses = uses_of(family_.arena, value.id, one.symbol);
  family_.add(std::move(out));
}

void RoutineReader::subprogram() {
  const text::Span at = cursor_.peek().span;
  const std::optional<std::string> name = new_name();
  scope_.open();
  Subprogram out{.name = name.value_or(std::string()), .parameters = {}, .steps = {}};
  if (name) out.parameters = parameters();
  const bool is_whole = !cursor_.line_failed();
  cursor_.finish_line();
  BodyReader body(cursor_, scope_, expressions_, family_, out.steps);
  body.read_subprogram(at);
  scope_.seal();
  out.needs_feed = body.needs_feed();
  out.sets_feed = body.has_feed();
  if (name && is_whole) family_.add(std::move(out));
}

}  // namespace dripfeed::family
