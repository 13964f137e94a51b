// What holds before each statement on all ways that lead there: a work list over the flow graph, for a state that the
// caller knows how to carry over a statement and to bring together.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "dialects/ir/program.h"
#include "dialects/passes/flow_graph.h"

namespace dripfeed::passes {

// `before` holds the state where runs begin, nothing elsewhere, and one more than the statements, for the end.
// `after(statement, state)` is the state behind it; `meet(state, with)` leaves what both have and returns whether that
// is less than before. What block skip may leave out is met with not having been run. Nothing where no way leads.
template <class State, class After, class Meet>
void spread_states(const ir::Program& program, FlowGraph& graph, std::vector<std::optional<State>>& before,
                   After&& after, Meet&& meet) {
  std::deque<std::uint32_t> work;
  for (std::uint32_t i = 0; i < before.size(); ++i)
    if (before[i].has_value()) work.push_back(i);
  while (!work.empty()) {
    const std::uint32_t i = work.front();
    work.pop_front();
    if (i >= program.statements.size()) continue;
    State out = after(i, *before[i]);
    if (program.statements[i].skip_level != 0) (void)meet(out, *before[i]);
    for (const std::uint32_t next : graph.after(i)) {
      const bool is_new = !before[next].has_value();
      if (is_new) before[next] = out;
      if (is_new || meet(*before[next], out)) work.push_back(next);
    }
  }
}

// From `start` where programs begin, not where parts do that are only run and come back.
template <class State, class After, class Meet>
std::vector<std::optional<State>> states_before(const ir::Program& program, const State& start, After&& after,
                                                Meet&& meet) {
  std::vector<std::optional<State>> before(program.statements.size() + 1);
  FlowGraph graph(program);
  for (const std::uint32_t entry : graph.entries_for_good()) before[entry] = start;
  spread_states(program, graph, before, after, meet);
  return before;
}

}  // namespace dripfeed::passes
