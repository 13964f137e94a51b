// Look-ups in a control's tables.
#include "dialects/ir/control.h"

#include <algorithm>
#include <utility>

namespace dripfeed::ir {

const CodeRow* find_code(std::span<const CodeRow> table, std::int32_t number10) {
  const auto row =
      std::ranges::lower_bound(table, number10, {}, [](const CodeRow& r) { return std::int32_t{r.number10}; });
  return row != table.end() && row->number10 == number10 ? &*row : nullptr;
}

std::string_view alarm_of(const Control& control, text::DiagnosticId id, AlarmDetail detail) {
  const auto row =
      std::ranges::find_if(control.alarms, [&](const AlarmRow& r) { return r.id == id && r.detail == detail; });
  if (row != control.alarms.end()) return row->alarm;
  return detail == AlarmDetail::none ? std::string_view() : alarm_of(control, id);
}

std::string_view name_of_system(const Control& control, SystemValue value) {
  const auto row = std::ranges::find(control.system_variables, value, &SystemVariableRow::kind);
  return row == control.system_variables.end() ? std::string_view() : row->name;
}

SystemUse use_of_system(const Control& control, std::uint32_t row) {
  return row < control.system_variables.size() ? control.system_variables[row].use : SystemUse::other;
}

const VariableRange* find_variable(const Control& control, Bank bank, std::uint32_t number) {
  const auto range = std::ranges::find_if(control.variables, [&](const VariableRange& r) {
    return r.bank == bank && r.first <= number && number <= r.last;
  });
  return range == control.variables.end() ? nullptr : &*range;
}

std::string name_of_machine_function(int number) { return "M" + std::to_string(number); }

bool is_known_machine_function(const Control& control, int number) {
  constexpr int kRigidTap = 29;
  // Where taps are rigid by themselves nothing is announced, and the number is a relay's (Haas, M21 to M29).
  if (number == kRigidTap && has_numbered_variables(control) && !control.semantics.taps_are_rigid) return true;
  const auto same = [number](std::uint16_t listed) { return static_cast<int>(listed) == number; };
  return std::ranges::any_of(control.machine_functions, same);
}

std::int32_t tool_of_name(const Control& control, std::string_view name) {
  const auto found = std::ranges::lower_bound(control.tool_names, name, {}, &ToolName::name);
  return found == control.tool_names.end() || found->name != name ? 0 : found->tool;
}

bool may_have_variable(const Control& control, Bank bank, std::uint32_t number) {
  constexpr std::uint32_t kFirstFree = 34;
  constexpr std::uint32_t kLastFree = 99;
  if (bank != Bank::hash || control.variables_stated || !has_numbered_variables(control)) return false;
  return number < kFirstFree || number > kLastFree;
}

bool has_numbered_variables(const Control& control) {
  return std::ranges::any_of(control.variables, [](const VariableRange& range) { return range.bank == Bank::hash; });
}

text::Diagnostic diagnose(const Control& control, text::DiagnosticId id, text::Span span,
                          std::vector<std::string> arguments, AlarmDetail detail) {
  text::Diagnostic diagnostic = text::make_diagnostic(id, span, std::move(arguments));
  diagnostic.alarm = alarm_of(control, id, detail);
  const auto open = std::ranges::find(control.outside, id, &OutsideRow::id);
  if (open == control.outside.end() || (open->profile_settles && control.from_profile)) return diagnostic;
  diagnostic.severity = std::min(diagnostic.severity, text::Severity::warning);
  diagnostic.is_open = true;
  diagnostic.notes.push_back({span, std::string(open->settled_by)});
  return diagnostic;
}

}  // namespace dripfeed::ir
