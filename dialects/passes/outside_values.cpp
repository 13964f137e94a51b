// One entry a variable, in the order of the text.
#include "dialects/passes/outside_values.h"

#include <algorithm>
#include <optional>

#include "dialects/facts/calls.h"
#include "dialects/ir/sections.h"
#include "dialects/passes/set_on_all_paths.h"

namespace dripfeed::passes {

std::vector<OutsideValue> outside_values(const ir::Program& program, const ir::Control& control, ir::Bank bank) {
  if (ir::is_subprogram(program)) return {};
  const auto watched = [&](const ir::Variable& v) -> std::optional<std::uint32_t> {
    if (v.bank != bank || v.index != ir::ExpressionId::none) return std::nullopt;
    const ir::VariableRange* range = ir::find_variable(control, bank, v.number);
    if (range == nullptr || range->use == ir::VariableUse::local || range->use == ir::VariableUse::system)
      return std::nullopt;
    return v.number;
  };
  const auto calls = [&](const ir::Statement& s) {
    return facts::is_call(s.kind) && !facts::is_standard_cycle(program, s);
  };
  const auto first_call = std::ranges::find_if(program.statements, calls) - program.statements.begin();
  std::vector<OutsideValue> found;
  for (const UnsetRead& read : reads_before_set(program, watched)) {
    if (read.statement >= first_call) continue;
    if (std::ranges::find(found, read.watched, &OutsideValue::number) == found.end())
      found.push_back({read.watched, program.at(read.variable).span});
  }
  return found;
}

}  // namespace dripfeed::passes
