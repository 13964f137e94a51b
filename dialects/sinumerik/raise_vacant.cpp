// On controls with '#' variables one that was never set is empty: a word with it is ignored, and it equals only itself.
// SINUMERIK has no such value: an R parameter holds what an earlier program left. A program keeps its meaning only when
// each local variable is set on every way to its use. Common variables may hold what the operator entered; those that
// are never set are told by the validator.
#include <algorithm>

#include "dialects/passes/set_on_all_ways.h"
#include "dialects/sinumerik/raise.h"

namespace dripfeed::sinumerik {

void raise_vacant(const Raising& raising) {
  if (!raising.from.semantics.has_vacant) return;
  const auto local = [&](const ir::Variable& v) -> std::optional<std::uint32_t> {
    if (v.bank != ir::Bank::hash || v.index != ir::ExpressionId::none) return std::nullopt;
    const ir::VariableRange* range = ir::find_variable(raising.from, v.bank, v.number);
    const bool is_local = range != nullptr && range->use == ir::VariableUse::local;
    return is_local ? std::optional(v.number) : std::nullopt;
  };
  std::vector<std::uint32_t> told;
  for (const passes::UnsetRead& read : passes::reads_before_set(raising.program, local)) {
    if (std::ranges::find(told, read.watched) != told.end()) continue;
    told.push_back(read.watched);
    raising.cannot("the variable #" + std::to_string(read.watched) + ", which may be empty here,",
                   raising.program.at(read.variable).span);
  }
}

}  // namespace dripfeed::sinumerik
