// Cycles of the control leave the motion code as it was; what other programs do is not known.
#include "dialects/passes/motion_flow.h"

#include <algorithm>

#include "dialects/passes/mode_flow.h"
#include "dialects/passes/state_flow.h"

namespace dripfeed::passes {

namespace {

using ir::StatementKind;
using Motion = std::optional<ir::Function>;

bool says_motion(const ir::Code& c) { return c.group == ir::ModalGroup::motion; }

Motion after(const ir::Program& program, std::uint32_t statement, Motion motion) {
  const ir::Statement& s = program.statements[statement];
  if (is_call(s.kind) && !is_standard_cycle(program, s)) motion.reset();
  if (s.kind == StatementKind::native) motion.reset();
  if (s.kind != StatementKind::block) return motion;
  const ir::Block& block = program.blocks[s.payload];
  for (const ir::Code& c : program.codes_of(block)) {
    const bool computed = c.number != ir::ExpressionId::none && c.letter == 'G';
    if (says_motion(c)) motion = c.function;
    if (computed || (says_motion(c) && ir::in_rest(block, c.span))) motion.reset();
  }
  return motion;
}

bool meet(Motion& motion, const Motion& with) {
  if (!motion || motion == with) return false;
  motion.reset();
  return true;
}

// Nothing that moves, and nothing that leads elsewhere.
bool goes_on(const ir::Program& program, const ir::Statement& s) {
  return s.kind == StatementKind::empty || s.kind == StatementKind::assign || s.kind == StatementKind::message ||
         s.kind == StatementKind::modal_call_end || (s.kind == StatementKind::call && is_standard_cycle(program, s));
}

}  // namespace

std::vector<Motion> motions_before(const ir::Program& program) {
  const auto states = states_before(
      program, Motion(), [&](std::uint32_t i, const Motion& motion) { return after(program, i, motion); }, meet);
  std::vector<Motion> out;
  out.reserve(states.size());
  for (const std::optional<Motion>& state : states) out.push_back(state.value_or(std::nullopt));
  return out;
}

bool needs_motion(const ir::Program& program, std::uint32_t statement) {
  for (std::uint32_t i = statement + 1; i < program.statements.size(); ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind == StatementKind::program_end) return false;
    if (goes_on(program, s)) continue;
    if (s.kind != StatementKind::block || s.skip_level != 0) return true;
    const ir::Block& block = program.blocks[s.payload];
    if (std::ranges::any_of(program.codes_of(block), says_motion)) return false;
    if (std::ranges::any_of(program.words_of(block), ir::is_axis, &ir::Word::address)) return true;
  }
  return false;
}

}  // namespace dripfeed::passes
