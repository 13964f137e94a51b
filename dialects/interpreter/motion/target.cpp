// Axis words to end points.
#include "dialects/interpreter/motion/target.h"

#include <bit>

#include "dialects/interpreter/motion/polar.h"
#include "dialects/interpreter/state/axis_words.h"
#include "dialects/interpreter/state/frame.h"

namespace dripfeed::interpreter {

Target find_target(const PlainBlock& block, const BlockRules& rules, const ModalState& state, bool machine) {
  Target target{.end = state.position};
  for_each_axis_word(block, rules, state.modes, !state.modes.absolute,
                     [&](std::size_t axis, double value, bool incremental) {
                       const auto bit = static_cast<std::uint16_t>(1U << axis);
                       target.commanded |= bit;
                       if (machine) {
                         target.end[axis] = value;
                         if (incremental) target.incremental |= bit;
                       } else if (incremental) {
                         target.end[axis] = state.position[axis] + value;
                         target.incremental |= bit;
                         target.shifted |= state.shifted & bit;
                       } else {
                         target.end[axis] = value + state.modes.shift[axis] + state.coordinate_shift[axis];
                       }
                     });
  for (std::uint64_t rest = block.unknown & rules.axis_addresses; rest != 0; rest &= rest - 1)
    target.unknown |= static_cast<std::uint16_t>(
        1U << index_of(rules.axis_words[static_cast<std::size_t>(std::countr_zero(rest))].axis));
  target.unknown |= target.shifted;
  return target;
}

// Under a frame that turns, the words name programmed coordinates; those that are not named stay as they are there. A
// coordinate that is not known makes every axis unknown that it is mixed into.
Target find_target_in_frame(const PlainBlock& block, const BlockRules& rules, const ModalState& state) {
  Target target{.end = state.position};
  Vector programmed = programmed_position(rules, state);
  const Matrix back = inverse_of(state.modes.matrix);
  const auto mixed = [](const Matrix& m, std::uint32_t unknown) {
    std::uint32_t out = 0;
    for (std::uint32_t row = 0; row < 3; ++row)
      for (std::uint32_t column = 0; column < 3; ++column)
        if ((unknown >> column & 1U) != 0 && std::abs(m[row * 3 + column]) > 1e-12) out |= 1U << row;
    return out;
  };
  std::uint32_t unknown = mixed(back, state.unknown & 7U);
  bool turned = false;
  for_each_axis_word(
      block, rules, state.modes, !state.modes.absolute, [&](std::size_t axis, double value, bool incremental) {
        const auto bit = static_cast<std::uint16_t>(1U << axis);
        if (axis < 3) {
          const double radius = axis == 0 && rules.x_is_diameter ? value / 2.0 : value;
          programmed[axis] = incremental ? programmed[axis] + radius : radius;
          if (!incremental) unknown &= ~std::uint32_t{bit};
          if (!incremental) target.stated |= bit;
          if (incremental) target.shifted |= state.shifted & bit;
          turned = true;
          return;
        }
        target.commanded |= bit;
        if (incremental) target.incremental |= bit;
        if (incremental) target.shifted |= state.shifted & bit;
        target.end[axis] =
            incremental ? state.position[axis] + value : value + state.modes.shift[axis] + state.coordinate_shift[axis];
      });
  for (std::uint64_t rest = block.unknown & rules.axis_addresses; rest != 0; rest &= rest - 1)
    unknown |= 1U << index_of(rules.axis_words[static_cast<std::size_t>(std::countr_zero(rest))].axis);
  unknown |= target.shifted;
  if (!turned && (unknown & 7U) == 0) return target;
  const Vector at = multiply(state.modes.matrix, programmed);
  target.unknown = static_cast<std::uint16_t>(mixed(state.modes.matrix, unknown & 7U) | (unknown & ~7U));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double kept = (axis == 0 && rules.x_is_diameter ? 2.0 : 1.0) * at[axis] + state.modes.shift[axis] +
                        state.coordinate_shift[axis];
    const auto bit = static_cast<std::uint16_t>(1U << axis);
    if ((target.unknown & bit) != 0 || (kept == target.end[axis] && (state.unknown & bit) == 0)) continue;
    target.end[axis] = kept;
    target.commanded |= bit;
  }
  return target;
}

Target find_any_target(const PlainBlock& block, const BlockRules& rules, const ModalState& state, bool machine) {
  const bool in_frame = state.modes.has_matrix && !machine;
  return in_frame ? find_target_in_frame(block, rules, state) : find_target(block, rules, state, machine);
}

}  // namespace dripfeed::interpreter
