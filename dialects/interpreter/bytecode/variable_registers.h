// Which register a variable is, for those that read and those that assign.
#pragma once

#include "dialects/interpreter/bytecode/bytecode.h"
#include "dialects/interpreter/bytecode/variable_map.h"
#include "dialects/ir/program.h"

namespace dripfeed::interpreter {

inline std::uint8_t extra_of(ir::Bank bank) { return static_cast<std::uint8_t>(bank); }

// A name that the reader could not resolve.
inline bool is_unknown(const ir::Variable& variable) {
  return variable.bank == ir::Bank::named && variable.symbol == ir::SymbolId::none;
}

// None: it is not a fixed one.
inline Operand register_of(Slot slot) {
  if (slot.kind == SlotKind::global) return make_operand(Space::global, slot.index);
  if (slot.kind == SlotKind::local) return make_operand(Space::local, slot.index);
  return Operand::none;
}

}  // namespace dripfeed::interpreter
