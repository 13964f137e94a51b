// Assignments of what no path reads any more.
#include <fmt/format.h>

#include "dialects/facts/flow_graph.h"
#include "dialects/optimize/expressions.h"
#include "dialects/optimize/work.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::optimize {

bool drop_unread(Work& work) {
  ir::Program& program = work.program;
  const Places places(program, work.control, work.own);
  const std::vector<Access> accesses = accesses_of(program, places);
  const Liveness liveness(program, places, accesses);
  const std::vector<bool> is_target = facts::jump_targets(program);
  const std::vector<bool> is_parameter = parameters_of(program, places, accesses);
  const auto is_unread = [&](std::uint32_t i) {
    const ir::Statement& s = program.statements[i];
    if (is_target[i]) return false;
    if (s.kind != ir::StatementKind::assign || accesses[i].is_fixed || accesses[i].sets.size() != 1) return false;
    const Place place = accesses[i].sets.front();
    return places.at(place).is_plain && !is_parameter[place] && !liveness.after(i, place) &&
           !may_fault(program, program.assigns[s.payload].value) && !accesses[i].reads_outside;
  };
  passes::Rewrite out(program);
  bool changed = false;
  for (std::uint32_t i = 0; i < accesses.size(); ++i) {
    out.at(i);
    if (is_unread(i)) {
      changed = true;
      work.report(Rule::values, program.statements[i].line, "what no block reads is not computed");
    } else {
      out.keep();
    }
  }
  if (changed) out.finish();
  return changed;
}

}  // namespace dripfeed::optimize
