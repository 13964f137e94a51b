// Statements keep their places, so nothing else has to follow.
#include "dialects/passes/main_return.h"

#include "dialects/facts/flow_graph.h"
#include "dialects/ir/sections.h"

namespace dripfeed::passes {

namespace {

using ir::StatementKind;

void as_jump(ir::Program& program, ir::Statement& s) {
  ir::Jump jump;
  if (s.kind == StatementKind::return_to)
    jump = program.jumps[s.payload];
  else
    jump.restart = true;
  program.jumps.push_back(jump);
  s.kind = StatementKind::go_to;
  s.payload = static_cast<std::uint32_t>(program.jumps.size() - 1);
}

}  // namespace

void returns_of_main_as_jumps(ir::Program& program) {
  facts::StatementRange range;  // of the program that `main` reports
  bool main = false;
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    ir::Statement& s = program.statements[i];
    if (!ir::returns(s.kind)) continue;
    if (i >= range.last) {
      range = facts::section_of(program, i);
      main = ir::has_end(program, range.first, range.last);
    }
    if (main) as_jump(program, s);
  }
}

}  // namespace dripfeed::passes
