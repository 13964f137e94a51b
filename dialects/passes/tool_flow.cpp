// Where two ways meet, what differs is not known any more.
#include "dialects/passes/tool_flow.h"

#include <algorithm>

#include "dialects/facts/calls.h"
#include "dialects/facts/spread.h"
#include "dialects/passes/walk.h"

namespace dripfeed::passes {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::StatementKind;
using Known = ToolState::Known;

bool changes_tool(const ir::Code& c) { return c.function == Function::tool_change; }

}  // namespace

ToolFlow::ToolFlow(const ir::Program& program)
    : program_(program),
      at_once_(!has_change()),
      before_(facts::states_before(
          program, ToolState(), [this](std::uint32_t i, const ToolState& state) { return after(i, state); },
          [this](ToolState& state, const ToolState& with) { return meet(state, with); })) {}

bool ToolFlow::has_change() const {
  return std::ranges::any_of(program_.statements, [this](const ir::Statement& s) {
    return s.kind == StatementKind::block &&
           std::ranges::any_of(program_.codes_of(program_.blocks[s.payload]), changes_tool);
  });
}

const ToolState* ToolFlow::before(std::uint32_t statement) const {
  return before_[statement].has_value() ? &*before_[statement] : nullptr;
}

ToolState ToolFlow::after(std::uint32_t statement, ToolState state) const {
  const ir::Statement& s = program_.statements[statement];
  if (s.kind == StatementKind::block) {
    const ir::Block& block = program_.blocks[s.payload];
    const ToolState before = state;
    take_block(block, state);
    if (block.rest_level != 0) (void)meet(state, before);
  } else if (facts::is_call(s.kind) && !facts::is_standard_cycle(program_, s)) {
    state.caller = statement;
  }
  if (s.kind == StatementKind::block) return state;
  // T=R1 is no longer R1 when that gets another value.
  for_each_root(
      program_, s, [](ir::ExpressionId) {}, [&](ir::VariableId target) { forget(program_.at(target), state); });
  return state;
}

void ToolFlow::forget(const ir::Variable& variable, ToolState& state) const {
  for (ToolState::Tool* tool : {&state.in, &state.next})
    if (tool->known == Known::tool && uses(tool->value, variable)) *tool = {.known = Known::differs};
}

bool ToolFlow::uses(ExpressionId value, const ir::Variable& variable) const {
  bool found = false;
  for_each_node(program_, value, [&](ExpressionId id) {
    if (program_.at(id).op != ir::Operator::variable) return;
    const ir::Variable& read = program_.at(program_.at(id).variable);
    const bool any = read.index != ExpressionId::none || variable.index != ExpressionId::none;
    const bool same = read.bank == ir::Bank::named ? read.symbol == variable.symbol : read.number == variable.number;
    found |= read.bank == variable.bank && (any || same);
  });
  return found;
}

void ToolFlow::take_block(const ir::Block& block, ToolState& state) const {
  const auto words = program_.words_of(block);
  const auto tool = std::ranges::find(words, Address::t, &ir::Word::address);
  const auto edge = std::ranges::find(words, Address::d, &ir::Word::address);
  const auto codes = program_.codes_of(block);
  if (tool != words.end()) {
    state.next = {.known = Known::tool, .value = tool->value};
    state.next_edge = edge == words.end() ? ExpressionId::none : edge->value;
  }
  const bool changes = std::ranges::any_of(codes, changes_tool);
  if (changes || (at_once_ && tool != words.end())) {
    state.in = state.next;
    state.has_edge = state.next_edge != ExpressionId::none || edge != words.end();
    state.caller = ir::kNoIndex;
  }
  const bool length = std::ranges::any_of(codes, [](const ir::Code& c) {
    return c.function == Function::length_offset_plus || c.function == Function::length_offset_minus;
  });
  // D beside a T that only prepares acts on the tool that is in, too.
  state.has_edge |= length || (edge != words.end() && (tool == words.end() || state.in.known == Known::tool));
}

bool ToolFlow::same_value(ExpressionId a, ExpressionId b) const {
  if (a == b) return true;
  if (a == ExpressionId::none || b == ExpressionId::none) return false;
  const ir::Expression& one = program_.at(a);
  const ir::Expression& other = program_.at(b);
  return one.op == ir::Operator::constant && other.op == ir::Operator::constant && one.value == other.value;
}

bool ToolFlow::meet(ToolState::Tool& tool, const ToolState::Tool& with) const {
  if (tool.known == Known::differs || (tool.known == with.known && same_value(tool.value, with.value))) return false;
  tool = {.known = Known::differs};
  return true;
}

// Whether that is less than before.
bool ToolFlow::meet(ToolState& state, const ToolState& with) const {
  bool less = meet(state.in, with.in);
  less |= meet(state.next, with.next);
  if (state.has_edge && !with.has_edge) {
    state.has_edge = false;
    less = true;
  }
  if (state.next_edge != ExpressionId::none && !same_value(state.next_edge, with.next_edge)) {
    state.next_edge = ExpressionId::none;
    less = true;
  }
  if (state.caller == ir::kNoIndex && with.caller != ir::kNoIndex) {
    state.caller = with.caller;
    less = true;
  }
  return less;
}

}  // namespace dripfeed::passes
