// Every expression and variable that a statement holds, for passes that look at or change all of them.
#pragma once

#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::passes {

// Calls `on_expression(ir::ExpressionId&)` for each root expression of the statement and `on_target(ir::VariableId)`
// for each variable that it sets. Of a program that is not const the fields are its own and may be changed; arenas must
// not grow meanwhile.
template <class AnyProgram, class OnExpression, class OnTarget>
void for_each_root(AnyProgram& program, const ir::Statement& statement, OnExpression&& on_expression,
                   OnTarget&& on_target) {
  const auto root = [&](auto& id) {
    if (id != ir::ExpressionId::none) on_expression(id);
  };
  using enum ir::StatementKind;
  if (statement.payload == ir::kNoIndex) return;
  switch (statement.kind) {
    case block:
    case program_end: {
      const ir::Block& b = program.blocks[statement.payload];
      for (std::uint32_t i = 0; i < b.code_count; ++i) root(program.codes[b.first_code + i].number);
      for (std::uint32_t i = 0; i < b.word_count; ++i) {
        root(program.words[b.first_word + i].value);
        root(program.words[b.first_word + i].axis);
      }
      return;
    }
    case assign:
      on_target(program.assigns[statement.payload].target);
      root(program.assigns[statement.payload].value);
      return;
    case go_to:
    case return_to:
      root(program.jumps[statement.payload].condition);
      root(program.jumps[statement.payload].computed);
      return;
    case if_begin:
    case else_begin:
    case if_end:
    case while_begin:
    case while_end:
    case repeat_begin:
    case repeat_end:
    case for_begin:
    case for_end:
    case loop_begin:
    case loop_end: {
      auto& s = program.structures[statement.payload];
      if (s.counter != ir::VariableId::none) on_target(s.counter);
      root(s.condition);
      root(s.first);
      root(s.last);
      return;
    }
    case define:
    case procedure: {
      const ir::Structure& s = program.structures[statement.payload];
      for (std::uint32_t i = 0; i < s.symbol_count; ++i) root(program.symbols[s.first_symbol + i].initial);
      return;
    }
    case call:
    case modal_call: {
      auto& c = program.calls[statement.payload];
      root(c.number);
      root(c.computed);
      root(c.repeats);
      root(c.start);
      root(c.first_label);
      root(c.last_label);
      for (std::uint32_t i = 0; i < c.argument_count; ++i) root(program.arguments[c.first_argument + i].value);
      return;
    }
    case message:
    case alarm:
      root(program.messages[statement.payload].text);
      root(program.messages[statement.payload].number);
      return;
    case output: {
      const ir::Output& o = program.outputs[statement.payload];
      for (std::uint32_t i = 0; i < o.part_count; ++i) root(program.output_parts[o.first_part + i].value);
      return;
    }
    case subprogram_return:
    case modal_call_end:
    case empty:
    case declaration:
    case execute_text: root(program.messages[statement.payload].text); return;
    case repeat_section: root(program.repeats[statement.payload].times); return;
    case native: return;
  }
}

// Calls `visit(ir::ExpressionId)` for the node and all below it, also those in the index of a variable; operands first.
template <class Visit>
void for_each_node(const ir::Program& program, ir::ExpressionId id, Visit&& visit) {
  if (id == ir::ExpressionId::none) return;
  const ir::Expression e = program.at(id);
  if (e.op == ir::Operator::variable) {
    const ir::Variable v = program.at(e.variable);
    for_each_node(program, v.index, visit);
    for_each_node(program, v.index2, visit);
    for_each_node(program, v.index3, visit);
  } else {
    for_each_node(program, e.a, visit);
    for_each_node(program, e.b, visit);
    for_each_node(program, e.c, visit);
  }
  visit(id);
}

// The variables that the statement reads or sets, those in indices before those that have them; `set` shows which.
struct VariableUseAt {
  ir::VariableId variable = ir::VariableId::none;
  bool set = false;
};
std::vector<VariableUseAt> variables_of(const ir::Program& program, const ir::Statement& statement);

}  // namespace dripfeed::passes
