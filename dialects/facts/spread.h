// What holds before each statement on all control-flow paths that lead there: a worklist over the flow graph, for a
// state of the caller's own. What is in effect for a whole control is in resolved.h.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "dialects/facts/flow_graph.h"
#include "dialects/ir/program.h"

namespace dripfeed::facts {

// `before` holds the state where runs begin, nothing elsewhere, and one more than the statements, for the end.
// `after(statement, state)` is the state after it; `join(state, with)` leaves what both have and returns whether that
// is less than before. A statement that block skip may leave out joins what held before it. Nothing where no path
// leads.
template <class State, class After, class Join>
void spread_states(const ir::Program& program, FlowGraph& graph, std::vector<std::optional<State>>& before,
                   After&& after, Join&& join) {
  std::deque<std::uint32_t> work;
  for (std::uint32_t i = 0; i < before.size(); ++i)
    if (before[i].has_value()) work.push_back(i);
  while (!work.empty()) {
    const std::uint32_t i = work.front();
    work.pop_front();
    if (i >= program.statements.size()) continue;
    State out = after(i, *before[i]);
    if (program.statements[i].skip_level != 0) (void)join(out, *before[i]);
    for (const std::uint32_t next : graph.after(i)) {
      const bool is_new = !before[next].has_value();
      if (is_new) before[next] = out;
      if (is_new || join(*before[next], out)) work.push_back(next);
    }
  }
}

// From `start` where programs begin, not where parts do that are only run and come back.
template <class State, class After, class Join>
std::vector<std::optional<State>> states_before(const ir::Program& program, const State& start, After&& after,
                                                Join&& join) {
  std::vector<std::optional<State>> before(program.statements.size() + 1);
  FlowGraph graph(program);
  for (const std::uint32_t entry : graph.entries_for_good()) before[entry] = start;
  spread_states(program, graph, before, after, join);
  return before;
}

}  // namespace dripfeed::facts
