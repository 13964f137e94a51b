// Statements keep their places, so nothing else has to follow.
#include "dialects/passes/main_return.h"

#include <algorithm>

#include "dialects/passes/flow_graph.h"

namespace dripfeed::passes {

namespace {

using ir::StatementKind;

bool has_end(const ir::Program& program, const StatementRange& range) {
  const auto begin = program.statements.begin();
  return std::any_of(begin + range.first, begin + range.last,
                     [](const ir::Statement& s) { return s.kind == StatementKind::program_end; });
}

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
  StatementRange range;  // of the program that `main` tells of
  bool main = false;
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    ir::Statement& s = program.statements[i];
    if (!returns(s.kind)) continue;
    if (i >= range.last) {
      range = section_of(program, i);
      main = has_end(program, range);
    }
    if (main) as_jump(program, s);
  }
}

bool is_subprogram(const ir::Program& program, const StatementRange& range) {
  const auto begin = program.statements.begin();
  return std::any_of(begin + range.first, begin + range.last, [](const ir::Statement& s) { return returns(s.kind); }) &&
         !has_end(program, range);
}

bool is_subprogram(const ir::Program& program) {
  return is_subprogram(program, {.first = 0, .last = static_cast<std::uint32_t>(program.statements.size())});
}

}  // namespace dripfeed::passes
