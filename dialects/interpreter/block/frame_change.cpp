// Frames are a shift and a matrix in Modes; the matrix works in radius values of X Y Z.
#include "dialects/interpreter/block/frame_change.h"

#include <algorithm>

#include "dialects/interpreter/motion/point_frame.h"
#include "dialects/interpreter/state/axis_words.h"
#include "dialects/interpreter/state/frame.h"

namespace dripfeed::interpreter {

using ir::Address;
using ir::Function;

namespace {

// ATRANS under a frame that turns: along the programmed axes.
void shift_in_frame(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  Vector by{};
  for_each_axis_word(block, rules, state.modes, false, [&](std::size_t axis, double value, bool) {
    if (axis < by.size())
      by[axis] = axis == 0 && rules.x_is_diameter ? value / 2.0 : value;
    else
      state.modes.shift[axis] += value;
  });
  const Vector turned = multiply(state.modes.matrix, by);
  for (std::size_t axis = 0; axis < turned.size(); ++axis)
    state.modes.shift[axis] += axis == 0 && rules.x_is_diameter ? 2.0 * turned[axis] : turned[axis];
}

// G92.1: neither G52 nor G92 shifts the named axes any more.
void take_back_shifts(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  for_each_axis_word(block, rules, state.modes, false, [&](std::size_t axis, double, bool) {
    state.coordinate_shift[axis] = state.modes.local_shift[axis] = 0.0;
  });
  if (state.modes.frame_languages == 1 && rules.other_language) return;  // the frame in effect is none of this language
  compose_frames(rules, state.modes);
}

}  // namespace

void change_frame(const PlainBlock& block, const BlockRules& rules, Function function, bool replace,
                  ModalState& state) {
  constexpr std::array kLetters = {Address::x, Address::y, Address::z};
  Vector values{};
  std::array<bool, 3> named{};
  for (std::size_t axis = 0; axis < values.size(); ++axis) {
    named[axis] = block.has(kLetters[axis]);
    values[axis] = named[axis] ? block.at(kLetters[axis]) : 0.0;
  }
  Matrix change = kIdentity;
  if (function == Function::rotate) {
    change = block.has(Address::frame_angle) ? rotation_in(state.modes.plane, block.at(Address::frame_angle))
                                             : rotation_of(values);
  } else {
    Vector factors = {1.0, 1.0, 1.0};
    for (std::size_t axis = 0; axis < factors.size(); ++axis)
      if (named[axis]) factors[axis] = function == Function::mirror ? -1.0 : values[axis];
    change = diagonal_of(factors);
  }
  if (replace) state.modes.shift = state.modes.fine_shift = {};
  state.modes.matrix = replace ? change : multiply(state.modes.matrix, change);
  state.modes.has_matrix = state.modes.matrix != kIdentity;
  const std::uint64_t used = rules.axis_addresses | bit_of(Address::frame_angle);
  if ((block.unknown & used) != 0) state.unknown |= kAllAxes;
}

void shift_locally(const PlainBlock& block, const BlockRules& rules, bool whole, bool add, ModalState& state) {
  if (std::ranges::any_of(state.modes.point_frames, &PointFrame::active)) {
    for_each_axis_word(block, rules, state.modes, false,
                       [&](std::size_t axis, double value, bool) { state.modes.local_shift[axis] = value; });
    return compose_frames(rules, state.modes);
  }
  if (!add && (whole || (block.present & rules.axis_addresses) == 0)) {
    state.modes.shift = state.modes.fine_shift = {};
    state.modes.matrix = kIdentity;
    state.modes.has_matrix = false;
  }
  if (add && state.modes.has_matrix) return shift_in_frame(block, rules, state);
  for_each_axis_word(block, rules, state.modes, false, [&](std::size_t axis, double value, bool incremental) {
    state.modes.shift[axis] = add || incremental ? state.modes.shift[axis] + value : value;
    if (add) state.modes.fine_shift[axis] += value;
  });
  state.modes.local_shift = state.modes.shift;
}

void mark_shifted(const Modes& before, const BlockRules& rules, ModalState& state) {
  if (rules.semantics.machine_move != ir::MachineMove::without_frames) return;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      if (before.matrix[row * 3 + column] != state.modes.matrix[row * 3 + column])
        state.shifted |= static_cast<std::uint16_t>(1U << row | 1U << column);
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
    if (before.shift[axis] != state.modes.shift[axis]) state.shifted |= static_cast<std::uint16_t>(1U << axis);
}

// PGA, "Axial zero offset (G58, G59)": G58 writes the coarse part, G59 the fine one that ATRANS adds to.
void shift_axes(const PlainBlock& block, const BlockRules& rules, bool fine, ModalState& state) {
  for_each_axis_word(block, rules, state.modes, false, [&](std::size_t axis, double value, bool) {
    double& small = state.modes.fine_shift[axis];
    if (fine) {
      state.modes.shift[axis] += value - small;
      small = value;
    } else {
      state.modes.shift[axis] = value + small;
    }
  });
  if ((block.unknown & rules.axis_addresses) != 0) state.unknown |= kAllAxes;
}

void set_coordinates(const PlainBlock& block, const BlockRules& rules, bool takes_back, ModalState& state) {
  if (takes_back) return take_back_shifts(block, rules, state);
  for_each_axis_word(block, rules, state.modes, false, [&](std::size_t axis, double value, bool incremental) {
    const auto bit = static_cast<std::uint16_t>(1U << axis);
    if (incremental) {
      state.coordinate_shift[axis] -= value;
    } else if ((state.unknown & bit) != 0) {
      state.position[axis] = value + state.modes.shift[axis];
      state.coordinate_shift[axis] = 0.0;
      state.unknown &= static_cast<std::uint16_t>(~bit);
      state.gaps |= ir::kZerosChanged;
    } else {
      state.coordinate_shift[axis] = state.position[axis] - value - state.modes.shift[axis];
    }
  });
}

}  // namespace dripfeed::interpreter
