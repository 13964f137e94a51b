// First all places that set the target, then whether the one that is left is plain and comes first.
#include "dialects/compile/native/native_targets.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dialects/compile/native/native_flow.h"
#include "dialects/compile/native/native_overwritten.h"
#include "dialects/compile/native/native_scope.h"
#include "dialects/compile/native/native_variable.h"
#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/ir/sections.h"
#include "dialects/text/number.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

NativeTarget refused(std::string why, std::vector<text::DiagnosticNote> notes = {}) {
  return {.constant = std::nullopt, .why = std::move(why), .notes = std::move(notes)};
}

class TargetSearch {
 public:
  TargetSearch(const ir::Program& program, const ir::Control& control, std::string_view target)
      : program_(program), control_(control), target_(target) {}

  NativeTarget run() {
    const std::size_t point = target_.find('.');
    return point == std::string_view::npos ? variable() : argument(target_.substr(0, point), target_.substr(point + 1));
  }

 private:
  // --- #100, R10, DIA

  NativeTarget variable() {
    const auto found = NativeVariable::named(program_, control_, target_);
    if (!found) return refused(fmt::format("{} has no variable of that kind", control_.title));
    std::vector<NativeVariable::Setting> settings = found->settings(program_);
    if (settings.empty()) return refused(why_never_set());
    const std::vector<bool> scope = scope_of(program_, control_, *found, settings);
    std::erase_if(settings, [&scope](const NativeVariable::Setting& one) { return !scope[one.statement]; });
    if (settings.size() > 1) {
      std::vector<std::uint32_t> places;
      places.reserve(settings.size());
      for (const NativeVariable::Setting& one : settings) places.push_back(one.statement);
      return refused(
          fmt::format("it is set in {}, and which of them counts differs from place to place", lines_of(places)),
          notes_at(places, "it is set here"));
    }
    const NativeVariable::Setting& only = settings.front();
    NativeTarget out = constant_at(only.statement, only.value, only.is_integer);
    if (!out.constant) return out;
    if (program_.statements[only.statement].skip_level != 0)
      return refused(fmt::format("{} may be skipped, and then it has another value", lines_of({only.statement})),
                     notes_at({only.statement}, "after a block skip"));
    if (const auto early = read_before(*found, only.statement, scope))
      return refused(fmt::format("{} may read it before {} sets it", lines_of({*early}), lines_of({only.statement})),
                     notes_at({*early}, "it is read here"));
    out.variables = found->uses();
    out.scope = scope;
    return unless_overwritten(std::move(out), overwritten(program_, control_, *found, target_, only.statement, scope));
  }

  [[nodiscard]] std::string why_never_set() const {
    for (std::uint32_t i = 0; i < program_.symbols.size(); ++i) {
      const ir::Symbol& symbol = program_.symbols[i];
      if (symbol.is_parameter && text::upper_case(program_.strings.at(symbol.name)) == target_)
        return fmt::format("it is a parameter of a program: name it with the program, as in PROGRAM.{}", target_);
    }
    return "no line of the native program sets it";
  }

  // A statement that reads the variable before it is set; where no statement reads it, an end that is reached without.
  [[nodiscard]] std::optional<std::uint32_t> read_before(const NativeVariable& variable, std::uint32_t setting,
                                                         const std::vector<bool>& scope) const {
    const std::vector<bool> reached = reached_without(program_, setting);
    bool is_read = false;
    for (std::uint32_t i = 0; i < scope.size(); ++i) {
      if (!scope[i] || !variable.is_read_by(program_, i)) continue;
      is_read = true;
      if (reached[i]) return i;
    }
    if (is_read) return std::nullopt;
    const facts::StatementRange own = facts::section_of(program_, setting);
    for (std::uint32_t i = own.first; i < own.last; ++i) {
      const StatementKind kind = program_.statements[i].kind;
      if (reached[i] && (kind == StatementKind::program_end || ir::returns(kind))) return i;
    }
    return std::nullopt;
  }

  // --- TURNING_CYCLE.EXTD

  NativeTarget argument(std::string_view name, std::string_view parameter) {
    const ir::StringId id = program_.strings.find(name);
    const ir::Structure* head = id == ir::StringId::none ? nullptr : procedure_named(program_, id);
    if (head == nullptr)
      return refused(
          fmt::format("the native text holds no program {} with a PROC line, which names its parameters", name));
    std::uint32_t position = 0;
    std::string known;
    for (; position < head->symbol_count; ++position) {
      const std::string_view here = program_.strings.at(program_.symbols[head->first_symbol + position].name);
      if (text::upper_case(here) == parameter) break;
      known += fmt::format("{}{}", known.empty() ? "" : ", ", here);
    }
    if (position == head->symbol_count)
      return refused(known.empty() ? fmt::format("{} has no parameters", name)
                                   : fmt::format("{} has no parameter {}; it has {}", name, parameter, known));
    const std::vector<std::uint32_t> calls = calls_of(id);
    if (calls.empty()) return refused(fmt::format("no line of the native program calls {}", name));
    if (calls.size() > 1)
      return refused(fmt::format("{} is called in {}, and the value belongs to one call", name, lines_of(calls)),
                     notes_at(calls, "it is called here"));
    const ir::Call& call = program_.calls[program_.statements[calls.front()].payload];
    const ir::ExpressionId value = position < call.argument_count
                                       ? program_.arguments[call.first_argument + position].value
                                       : ir::ExpressionId::none;
    if (value == ir::ExpressionId::none)
      return refused(fmt::format("the call in {} leaves it out", lines_of(calls)), notes_at(calls, "here"));
    const ir::Symbol& symbol = program_.symbols[head->first_symbol + position];
    NativeTarget out = constant_at(calls.front(), value, symbol.type == ir::ValueType::integer);
    if (!out.constant) return out;
    const auto symbol_id = static_cast<ir::SymbolId>(head->first_symbol + position);
    out.variables = NativeVariable::of_symbol(symbol_id).uses();
    out.scope.assign(program_.statements.size(), true);
    return unless_overwritten(std::move(out), overwritten_parameter(program_, *head, symbol_id));
  }

  [[nodiscard]] std::vector<std::uint32_t> calls_of(ir::StringId name) const {
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (facts::is_call(s.kind) && program_.calls[s.payload].name == name) out.push_back(i);
    }
    return out;
  }

  // --- both

  NativeTarget unless_overwritten(NativeTarget out, Overwritten found) const {
    if (found.why.empty()) return out;
    std::vector<text::DiagnosticNote> notes = notes_at(found.statements, "it may be set here");
    if (found.is_fault) return refused(std::move(found.why), std::move(notes));
    out.warning = std::move(found.why);
    out.notes = std::move(notes);
    return out;
  }

  NativeTarget constant_at(std::uint32_t statement, ir::ExpressionId value, bool takes_integer) {
    if (value == ir::ExpressionId::none)
      return refused(fmt::format("{} counts it or gets it back from a call", lines_of({statement})),
                     notes_at({statement}, "here"));
    NativeTarget out{.constant = plain_constant(program_, value), .why = {}, .notes = {}};
    if (!out.constant)
      return refused(fmt::format("{} does not set it to a plain decimal number", lines_of({statement})),
                     notes_at({statement}, "here"));
    out.constant->statement = statement;
    out.constant->takes_integer = takes_integer;
    return out;
  }

  [[nodiscard]] std::string lines_of(const std::vector<std::uint32_t>& statements) const {
    return compile::lines_of(program_, statements);
  }

  [[nodiscard]] std::vector<text::DiagnosticNote> notes_at(const std::vector<std::uint32_t>& statements,
                                                           std::string_view text) const {
    constexpr std::size_t kMost = 5;
    std::vector<text::DiagnosticNote> out;
    for (std::size_t i = 0; i < statements.size() && i < kMost; ++i)
      out.push_back({.span = program_.statements[statements[i]].span, .text = std::string(text)});
    return out;
  }

  const ir::Program& program_;
  const ir::Control& control_;
  std::string_view target_;
};

bool is_sign(char c) { return c == '+' || c == '-'; }

// A '+' that the reader took for no part of the number.
text::Span with_sign(std::string_view text, text::Span span) {
  std::uint32_t before = span.begin;
  while (before > 0 && (text[before - 1] == ' ' || text[before - 1] == '\t')) --before;
  if (before > 0 && text[before - 1] == '+') span.begin = before - 1;
  return span;
}

}  // namespace

NativeTarget find_target(const ir::Program& program, const ir::Control& control, std::string_view target) {
  return TargetSearch(program, control, target).run();
}

std::optional<NativeConstant> plain_constant(const ir::Program& program, ir::ExpressionId value) {
  const ir::Expression& e = program.at(value);
  const bool negated = e.op == ir::Operator::negate && program.at(e.a).op == ir::Operator::constant;
  if (e.op != ir::Operator::constant && !negated) return std::nullopt;
  const std::string_view whole = program.source.text();
  const text::Span span = with_sign(whole, e.span);
  std::string_view written = span.in(whole);
  const bool negative = written.starts_with('-');
  if (!written.empty() && is_sign(written.front())) written.remove_prefix(1);
  written.remove_prefix(std::min(written.find_first_not_of(" \t"), written.size()));
  const auto decimal = text::read_decimal(written);
  if (!decimal || decimal->length != written.size() || !std::isfinite(decimal->value)) return std::nullopt;
  NativeConstant out;
  out.span = span;
  out.value = negative ? -decimal->value : decimal->value;
  out.has_point = decimal->has_point;
  out.digits = decimal->digits;
  return out;
}

}  // namespace dripfeed::compile
