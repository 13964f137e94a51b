// The axis words of a plain block, one after the other: which axis, how far, and whether by an increment.
#pragma once

#include <bit>
#include <cstdint>

#include "dialects/interpreter/state/block_rules.h"

namespace dripfeed::interpreter {

// Bits of the axis letters in it, also of those whose value is not known.
inline std::uint64_t axis_letters(const PlainBlock& block, const BlockRules& rules) {
  return (block.present | block.unknown) & rules.axis_addresses;
}
// Bits of the axes that these letters name.
inline std::uint16_t axes_of(std::uint64_t letters, const BlockRules& rules) {
  std::uint16_t axes = 0;
  for (; letters != 0; letters &= letters - 1) {
    const AxisWord& word = rules.axis_words[static_cast<std::size_t>(std::countr_zero(letters))];
    axes |= static_cast<std::uint16_t>(1U << index_of(word.axis));
  }
  return axes;
}

// Calls visit(axis, value, incremental) for each axis word that is there: mm or degrees, as programmed but for the
// diameter, which becomes what is kept.
template <class Visit>
void for_each_axis_word(const PlainBlock& block, const BlockRules& rules, const Modes& modes, bool modal_incremental,
                        Visit visit) {
  for (std::uint64_t rest = block.present & rules.axis_addresses; rest != 0; rest &= rest - 1) {
    const auto address = static_cast<ir::Address>(std::countr_zero(rest));
    const AxisWord& word = rules.axis_words[index_of(address)];
    const bool by_mode = (block.absolute & bit_of(address)) == 0 && modal_incremental;
    const bool incremental = word.incremental || by_mode || (block.incremental & bit_of(address)) != 0;
    double value = word.rotary ? rules.angle_deg(block, address) : rules.length_mm(block, address, modes.inch);
    if (word.axis == ir::Axis::x) value *= rules.x_factor(modes, incremental);
    visit(index_of(word.axis), value, incremental);
  }
}

}  // namespace dripfeed::interpreter
