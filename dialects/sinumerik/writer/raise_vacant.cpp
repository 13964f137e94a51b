// On controls with '#' variables one that was never set is empty: a word with it is ignored, and it equals only itself.
// SINUMERIK has no such value: an R parameter holds what an earlier program left. A program keeps its meaning only when
// each local variable is set on every path to its use. Common variables may hold what the operator entered or another
// program set: a word with one is reported, because here it moves in any case.
#include <algorithm>

#include "dialects/passes/refusal.h"
#include "dialects/passes/set_on_all_paths.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

namespace {

// Words X#107 whose common variable the program has not set.
void warn_of_words(const Raising& raising) {
  const ir::Program& program = raising.program;
  const auto common = [&](const ir::Variable& v) -> std::optional<std::uint32_t> {
    if (v.bank != ir::Bank::hash || v.index != ir::ExpressionId::none) return std::nullopt;
    const ir::VariableRange* range = ir::find_variable(raising.from, v.bank, v.number);
    return range != nullptr && range->use == ir::VariableUse::common ? std::optional(v.number) : std::nullopt;
  };
  std::vector<std::uint32_t> reported;
  for (const passes::UnsetRead& read : passes::reads_before_set(program, common)) {
    const ir::Statement& s = program.statements[read.statement];
    if (s.kind != ir::StatementKind::block || std::ranges::find(reported, read.watched) != reported.end()) continue;
    const bool alone = std::ranges::any_of(program.words_of(program.blocks[s.payload]), [&](const ir::Word& w) {
      const ir::Expression& e = program.at(w.value);
      return e.op == ir::Operator::variable && e.variable == read.variable;
    });
    if (!alone) continue;
    reported.push_back(read.watched);
    raising.cannot(passes::not_known("a word that is left out while #" + std::to_string(read.watched) + " is empty"),
                   program.at(read.variable).span);
    raising.diagnostics.back().severity = text::Severity::warning;
  }
}

}  // namespace

void raise_vacant(const Raising& raising) {
  if (!raising.from.semantics.has_vacant) return;
  const auto local = [&](const ir::Variable& v) -> std::optional<std::uint32_t> {
    if (v.bank != ir::Bank::hash || v.index != ir::ExpressionId::none) return std::nullopt;
    const ir::VariableRange* range = ir::find_variable(raising.from, v.bank, v.number);
    const bool is_local = range != nullptr && range->use == ir::VariableUse::local;
    return is_local ? std::optional(v.number) : std::nullopt;
  };
  std::vector<std::uint32_t> reported;
  for (const passes::UnsetRead& read : passes::reads_before_set(raising.program, local)) {
    if (std::ranges::find(reported, read.watched) != reported.end()) continue;
    reported.push_back(read.watched);
    raising.cannot(passes::not_known("the variable #" + std::to_string(read.watched) + ", which may be empty here,"),
                   raising.program.at(read.variable).span);
  }
  warn_of_words(raising);
}

}  // namespace dripfeed::sinumerik
