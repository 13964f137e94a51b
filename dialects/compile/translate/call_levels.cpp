// Programs go by their number where they have one: O0100, O100 and L100 are the same.
#include "dialects/compile/translate/call_levels.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "dialects/compile/translate/several_programs.h"
#include "dialects/passes/macro_arguments.h"
#include "dialects/passes/set_on_all_paths.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

constexpr std::size_t kMostSteps = 1'000'000;

bool is_call(StatementKind kind) { return kind == StatementKind::call || kind == StatementKind::modal_call; }

std::string plain(std::string_view name) {
  const bool numbered = name.size() > 1 && (name.front() == 'O' || name.front() == 'L') &&
                        name.find_first_not_of("0123456789", 1) == std::string_view::npos;
  if (!numbered) return std::string(name);
  const std::size_t digits = std::min(name.find_first_not_of('0', 1), name.size());
  return "O" + std::string(name.substr(digits));
}

// Whether it reads a local variable that an argument may have set.
bool takes_arguments(const ir::Program& program, const ir::Control& control) {
  const auto local = [&](const ir::Variable& v) -> std::optional<std::uint32_t> {
    if (v.bank != ir::Bank::hash) return std::nullopt;
    const ir::VariableRange* range = ir::find_variable(control, v.bank, v.number);
    const bool is_local = range != nullptr && range->use == ir::VariableUse::local;
    return is_local && v.index == ir::ExpressionId::none ? std::optional(v.number) : std::nullopt;
  };
  const auto computed = [](const ir::Variable& v) {
    return v.bank == ir::Bank::hash && v.index != ir::ExpressionId::none;
  };
  if (std::ranges::any_of(program.variables, computed)) return true;
  return std::ranges::any_of(passes::reads_before_set(program, local), [](const passes::UnsetRead& read) {
    return passes::position_of_local(read.watched).has_value();
  });
}

}  // namespace

void drop_unread_arguments(ir::Program& text, const ir::Control& from, const ir::Control& to) {
  const auto by_letter = [](const ir::Control& control) {
    return std::ranges::any_of(control.variables,
                               [](const ir::VariableRange& range) { return range.bank == ir::Bank::hash; });
  };
  if (!by_letter(from) || by_letter(to)) return;
  for (const ir::Section& section : text.sections) {
    const auto calls = [&](const ir::Statement& s) {
      return is_call(s.kind) && text.calls[s.payload].kind == ir::CallKind::macro &&
             text.calls[s.payload].argument_count != 0 && text.calls[s.payload].name == section.name;
    };
    if (std::ranges::none_of(text.statements, calls)) continue;
    if (takes_arguments(program_of(text, section), from)) continue;
    for (const ir::Statement& s : text.statements)
      if (calls(s)) text.calls[s.payload].argument_count = 0;
  }
}

void CallLevels::add(const std::string& name, const ir::Program& raised) {
  names_.push_back(plain(name));
  for (const ir::Statement& s : raised.statements) {
    if (!is_call(s.kind)) continue;
    const ir::Call& call = raised.calls[s.payload];
    if (call.name == ir::StringId::none) continue;
    edges_.push_back({names_.back(), plain(raised.strings.at(call.name)), call.kind == ir::CallKind::macro, s.span});
  }
}

std::vector<text::Diagnostic> CallLevels::too_deep(const ir::Control& to) const {
  std::vector<text::Diagnostic> out;
  std::size_t steps = 0;
  for (const std::string& name : names_) {
    const bool called = std::ranges::find(edges_, name, &Edge::to) != edges_.end();
    if (!called) follow({.names = {name}}, to, steps, out);
  }
  return out;
}

// Macros and subprograms are counted apart, as the control does it. Loops of calls are the run's.
void CallLevels::follow(const CallPath& path, const ir::Control& to, std::size_t& steps,
                        std::vector<text::Diagnostic>& out) const {
  for (const Edge& edge : edges_) {
    if (!out.empty() || ++steps > kMostSteps) return;
    if (edge.from != path.names.back() || std::ranges::find(path.names, edge.to) != path.names.end()) continue;
    CallPath next = path;
    next.names.push_back(edge.to);
    const std::uint32_t depth = edge.macro ? ++next.macros : ++next.subprograms;
    const std::uint32_t most = edge.macro ? to.limits.macro_nesting : to.limits.call_nesting;
    if (most != 0 && depth > most) {
      out.push_back(ir::diagnose(to, text::DiagnosticId::call_nesting_too_deep, edge.span,
                                 {std::to_string(depth), std::to_string(most)},
                                 edge.macro ? ir::AlarmDetail::macro_call : ir::AlarmDetail::none));
      return;
    }
    follow(next, to, steps, out);
  }
}

}  // namespace dripfeed::compile
