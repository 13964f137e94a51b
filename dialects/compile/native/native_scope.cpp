// The main program's variable is meant where it has one.
#include "dialects/compile/native/native_scope.h"

#include <algorithm>

#include "dialects/compile/native/native_flow.h"
#include "dialects/facts/flow_graph.h"

namespace dripfeed::compile {

SeenBy seen_by(const ir::Program& program, const ir::Control& control, const NativeVariable& variable) {
  if (variable.bank() == ir::Bank::named) {
    const auto is_global = [&](ir::SymbolId id) { return program.at(id).is_global; };
    return std::ranges::any_of(variable.symbols(), is_global) ? SeenBy::all : SeenBy::own_program;
  }
  const ir::VariableRange* range = ir::find_variable(control, variable.bank(), variable.number());
  return range != nullptr && range->use == ir::VariableUse::local ? SeenBy::called_with_m98 : SeenBy::all;
}

std::vector<bool> scope_of(const ir::Program& program, const ir::Control& control, const NativeVariable& variable,
                           const std::vector<NativeVariable::Setting>& settings) {
  const std::uint32_t first = settings.front().statement;
  const SeenBy seen = seen_by(program, control, variable);
  if (seen == SeenBy::called_with_m98) {
    std::vector<bool> of_main = shares_locals(program, main_section(program).first);
    const bool in_main =
        std::ranges::any_of(settings, [&](const NativeVariable::Setting& one) { return of_main[one.statement]; });
    return in_main ? of_main : shares_locals(program, first);
  }
  std::vector<bool> out(program.statements.size(), true);
  const facts::StatementRange own = facts::section_of(program, first);
  const auto is_own = [&own](std::uint32_t i) { return i >= own.first && i < own.last; };
  const bool is_one =
      std::ranges::all_of(settings, [&](const NativeVariable::Setting& one) { return is_own(one.statement); });
  if (seen == SeenBy::own_program && is_one)
    for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = is_own(i);
  return out;
}

}  // namespace dripfeed::compile
