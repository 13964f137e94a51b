// Small things that the passes over structures share: heads of structures, jumps to a number, opposite comparisons.
#pragma once

#include <cstdint>

#include "dialects/ir/program.h"

namespace dripfeed::passes {

// The structure of an opener, middle or closer.
inline ir::Structure structure_at(const ir::Program& program, std::uint32_t statement) {
  return program.structures[program.statements[statement].payload];
}

inline ir::Jump jump_to(std::uint32_t number, ir::ExpressionId condition = ir::ExpressionId::none) {
  ir::Jump jump;
  jump.number = number;
  jump.condition = condition;
  return jump;
}

constexpr bool begins_loop(ir::StatementKind kind) {
  return kind == ir::StatementKind::while_begin || kind == ir::StatementKind::for_begin ||
         kind == ir::StatementKind::loop_begin || kind == ir::StatementKind::repeat_begin;
}
constexpr bool ends_loop(ir::StatementKind kind) {
  return kind == ir::StatementKind::while_end || kind == ir::StatementKind::for_end ||
         kind == ir::StatementKind::loop_end || kind == ir::StatementKind::repeat_end;
}

// The comparison that holds when `op` does not; Operator::constant when `op` is none.
ir::Operator opposite_comparison(ir::Operator op);
inline bool is_comparison(const ir::Program& program, ir::ExpressionId id) {
  return opposite_comparison(program.at(id).op) != ir::Operator::constant;
}

}  // namespace dripfeed::passes
