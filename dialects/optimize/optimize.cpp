// The order: names become numbers and jumps structures first, because everything else gains by it; values, invariants
// and merging help each other, so they go round until nothing changes; then a table, and blocks are joined last.
#include "dialects/optimize/optimize.h"

#include <algorithm>
#include <set>

namespace dripfeed::optimize {

namespace {

constexpr int kMostRounds = 40;  // each makes something simpler; a program needs as many as it has loops in loops

// Local variables that the text does not mention, of a program that takes no others' arguments in them.
std::vector<NumberRange> unused_locals(const ir::Program& program, const ir::Control& control) {
  std::vector<NumberRange> out;
  const bool takes_arguments = std::ranges::any_of(program.statements, [](const ir::Statement& s) {
    return s.kind == ir::StatementKind::subprogram_return || s.kind == ir::StatementKind::call;
  });
  if (takes_arguments) return out;
  for (const ir::VariableRange& range : control.variables)
    if (range.use == ir::VariableUse::local && range.writable) out.push_back({range.bank, range.first, range.last});
  return out;
}

}  // namespace

std::optional<Rule> find_rule(std::string_view name) {
  for (std::size_t i = 0; i < kRules; ++i)
    if (kRuleRows[i].name == name) return static_cast<Rule>(i);
  return {};
}

std::optional<PlaceFacts> free_place(Work& work) {
  auto& [looked_at, used, computed] = work.numbers;
  for (; looked_at < work.program.variables.size(); ++looked_at) {
    const ir::Variable& v = work.program.variables[looked_at];
    if (v.index != ir::ExpressionId::none)
      computed.insert(v.bank);
    else
      used.emplace(v.bank, v.number);
  }
  for (const NumberRange& range : work.free) {
    if (computed.contains(range.bank)) continue;
    for (std::uint32_t n = range.first; n <= range.last; ++n) {
      const ir::VariableRange* found = ir::find_variable(work.control, range.bank, n);
      if (found == nullptr || !found->writable || used.contains({range.bank, n})) continue;
      return PlaceFacts{.bank = range.bank, .number = n, .is_own = true, .is_plain = true};
    }
  }
  return {};
}

std::optional<NumberRange> free_range(Work& work, std::size_t count) {
  free_place(work);  // so that the numbers of the program are known
  const auto& [looked_at, used, computed] = work.numbers;
  for (const NumberRange& range : work.free) {
    if (computed.contains(range.bank)) continue;
    std::size_t found = 0;
    for (std::uint32_t n = range.first; n <= range.last; ++n) {
      const ir::VariableRange* variable = ir::find_variable(work.control, range.bank, n);
      const bool is_free = variable != nullptr && variable->writable && !used.contains({range.bank, n});
      found = is_free ? found + 1 : 0;
      if (found == count) return NumberRange{range.bank, n + 1 - static_cast<std::uint32_t>(count), n};
    }
  }
  return {};
}

Result optimize(ir::Program& program, const ir::Control& control, const ir::CostModel& cost, const Settings& settings) {
  Result result;
  result.obstacle = obstacle(program);
  if (!result.obstacle.empty()) return result;
  Work work{.program = program, .control = control, .cost = cost, .own = settings.own, .free = settings.free};
  work.keeps_comments = !settings.rules.has(Rule::comments);
  for (const ir::Statement& s : program.statements) work.text_lines = std::max(work.text_lines, s.line);
  work.own.insert(work.own.end(), settings.free.begin(), settings.free.end());
  const std::vector<NumberRange> locals = unused_locals(program, control);
  work.free.insert(work.free.end(), locals.begin(), locals.end());

  const Rules& rules = settings.rules;
  if (rules.has(Rule::numbered)) number_names(work);
  structure_jumps(work, rules.has(Rule::loops), rules.has(Rule::branches));
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    if (rules.has(Rule::values)) changed = propagate_values(work) || changed;
    if (rules.has(Rule::values)) changed = drop_unread(work) || changed;
    if (rules.has(Rule::invariants)) changed = hoist_invariants(work) || changed;
    if (!changed && rules.has(Rule::merge)) changed = merge_values(work);
    if (!changed) break;
  }
  if (rules.has(Rule::table) && settings.table.spans > 0) tabulate(work, settings.table);
  if (rules.has(Rule::join)) join_blocks(work);
  result.changes = std::move(work.changes);
  result.made = std::move(work.made_lines);
  return result;
}

}  // namespace dripfeed::optimize
