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

std::string_view alarm_of(const Control& control, text::DiagnosticId id) {
  const auto row = std::ranges::find(control.alarms, id, &AlarmRow::id);
  return row == control.alarms.end() ? std::string_view() : row->alarm;
}

const VariableRange* find_variable(const Control& control, Bank bank, std::uint32_t number) {
  const auto range = std::ranges::find_if(control.variables, [&](const VariableRange& r) {
    return r.bank == bank && r.first <= number && number <= r.last;
  });
  return range == control.variables.end() ? nullptr : &*range;
}

text::Diagnostic diagnose(const Control& control, text::DiagnosticId id, text::Span span,
                          std::vector<std::string> arguments) {
  text::Diagnostic diagnostic = text::make_diagnostic(id, span, std::move(arguments));
  diagnostic.alarm = alarm_of(control, id);
  return diagnostic;
}

}  // namespace dripfeed::ir
