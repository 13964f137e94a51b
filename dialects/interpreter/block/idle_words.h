// Words of a block that none of its codes takes: M03 P11, which chooses a spindle on machines that have several, or an
// R that the builder's tool change reads. Without a machine that says so the control is silent about them, and so was
// the run.
#pragma once

#include <cstdint>

#include "dialects/interpreter/block/code_effects.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

// Letters that are words of codes only, where they name no axis.
inline constexpr std::uint64_t kIdleLetters = bit_of(ir::Address::e) | bit_of(ir::Address::i) | bit_of(ir::Address::j) |
                                              bit_of(ir::Address::k) | bit_of(ir::Address::l) | bit_of(ir::Address::p) |
                                              bit_of(ir::Address::q) | bit_of(ir::Address::r);

// Bits of BlockResult::notes, after the block's codes took effect.
std::uint64_t idle_notes(const PlainBlock& block, const BlockRules& rules, const Effects& effects,
                         const ModalState& state);

}  // namespace dripfeed::interpreter
