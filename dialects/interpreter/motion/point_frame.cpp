// Each of the three is kept for itself; shift and matrix, which all moves go by, are made of them at every change.
#include "dialects/interpreter/motion/point_frame.h"

#include <algorithm>

#include "dialects/interpreter/motion/polar.h"
#include "dialects/interpreter/state/axis_words.h"
#include "dialects/interpreter/state/frame.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Function;

constexpr std::array kFactorWords = {Address::i, Address::j, Address::k};

PointFrame& frame_of(Function function, Modes& modes) {
  if (function == Function::mirror) return modes.point_frames[0];
  return modes.point_frames[function == Function::scale ? 1 : 2];
}

// Radius values of X Y Z.
double radius_value(const BlockRules& rules, std::size_t axis, double kept) {
  return axis == 0 && rules.x_is_diameter ? kept / 2.0 : kept;
}

Vector through(const PointFrame& frame, Vector point) {
  if (!frame.active) return point;
  for (std::size_t axis = 0; axis < point.size(); ++axis) point[axis] -= frame.center[axis];
  point = multiply(frame.matrix, point);
  for (std::size_t axis = 0; axis < point.size(); ++axis) point[axis] += frame.center[axis];
  return point;
}

// The named coordinates; the others are where the tool stands, and are not known when that is not.
struct Center {
  Vector at{};
  std::uint32_t named = 0;
};
Center center_of(const PlainBlock& block, const BlockRules& rules, const ModalState& state) {
  Center center{.at = programmed_position(rules, state)};
  for_each_axis_word(block, rules, state.modes, false, [&](std::size_t axis, double value, bool incremental) {
    if (axis >= center.at.size()) return;
    center.at[axis] = radius_value(rules, axis, value) + (incremental ? center.at[axis] : 0.0);
    center.named |= 1U << axis;
  });
  return center;
}

// About the axis that I J K point along (three-dimensional coordinate conversion), or in the plane.
Matrix rotation_by(const PlainBlock& block, const ModalState& state, double angle_deg) {
  Vector axis{};
  bool given = false;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    if (!block.has(kFactorWords[i])) continue;
    axis[i] = block.at(kFactorWords[i]);
    given |= axis[i] != 0.0;
  }
  return given ? rotation_about(axis, angle_deg) : rotation_in(state.modes.plane, angle_deg);
}

// One factor for all axes (P), or one for each (I J K). A factor without a point counts the control's unit.
PointFrameGap take_factors(const PlainBlock& block, const BlockRules& rules, Vector& factors) {
  PointFrameGap gap = PointFrameGap::factor;
  const auto take = [&](Address address, double& factor) {
    if (!block.has(address)) return;
    const bool counted = (block.in_increments & bit_of(address)) != 0;
    factor = counted ? block.at(address) * rules.semantics.scale_unit : block.at(address);
    gap = counted && !rules.semantics.scale_unit_known ? PointFrameGap::factor_unit : PointFrameGap::none;
  };
  double all = 1.0;
  take(Address::p, all);
  factors = {all, all, all};
  for (std::size_t axis = 0; axis < factors.size(); ++axis) take(kFactorWords[axis], factors[axis]);
  return gap;
}

}  // namespace

void compose_frames(const BlockRules& rules, Modes& modes) {
  Vector origin{};
  Matrix matrix = kIdentity;
  for (std::size_t i = modes.point_frames.size(); i-- > 0;) {
    const PointFrame& frame = modes.point_frames[i];
    origin = through(frame, origin);
    if (frame.active) matrix = multiply(frame.matrix, matrix);
  }
  modes.shift = modes.local_shift;
  for (std::size_t axis = 0; axis < origin.size(); ++axis)
    modes.shift[axis] += axis == 0 && rules.x_is_diameter ? 2.0 * origin[axis] : origin[axis];
  modes.matrix = matrix;
  modes.has_matrix = matrix != kIdentity;
}

PointFrameGap set_point_frame(const PlainBlock& block, const BlockRules& rules, Function function, ModalState& state) {
  PointFrame& frame = frame_of(function, state.modes);
  PointFrameGap gap = PointFrameGap::none;
  if (function != Function::mirror) frame = {};
  compose_frames(rules, state.modes);  // a center is named in the coordinates that this one does not change
  const Center center = center_of(block, rules, state);
  std::uint32_t needed = 7U;
  if (function == Function::mirror) {
    for (std::size_t axis = 0; axis < center.at.size(); ++axis) {
      if ((center.named >> axis & 1U) == 0) continue;
      frame.matrix[axis * 4] = -1.0;
      frame.center[axis] = center.at[axis];
    }
    needed = 0;
  } else {
    frame.center = center.at;
    if (function == Function::rotate) {
      if (!block.has(Address::r)) gap = PointFrameGap::angle;
      const double angle_deg = block.has(Address::r) ? rules.angle_deg(block, Address::r) : 0.0;
      frame.matrix = rotation_by(block, state, angle_deg);
      if ((block.present & (bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k))) == 0)
        needed &= ~(1U << axes_of(state.modes.plane).normal);
    } else {
      Vector factors{};
      gap = take_factors(block, rules, factors);
      frame.matrix = diagonal_of(factors);
    }
  }
  frame.active = true;
  // A center that is not known makes everything unknown, and so do factors and angles.
  const std::uint64_t used = rules.axis_addresses | bit_of(Address::r) | bit_of(Address::p) | bit_of(Address::i) |
                             bit_of(Address::j) | bit_of(Address::k);
  if ((block.unknown & used) != 0 || (needed & ~center.named & state.unknown & 7U) != 0) state.unknown |= kAllAxes;
  compose_frames(rules, state.modes);
  return gap;
}

bool end_point_frame(const PlainBlock& block, const BlockRules& rules, Function function, ModalState& state) {
  PointFrame& frame = frame_of(function, state.modes);
  if (!frame.active) return false;
  const std::uint32_t named = center_of(block, rules, state).named;
  if (function == Function::mirror && named != 0) {
    for (std::size_t axis = 0; axis < frame.center.size(); ++axis) {
      if ((named >> axis & 1U) == 0) continue;
      frame.matrix[axis * 4] = 1.0;
      frame.center[axis] = 0.0;
    }
    frame.active = frame.matrix != kIdentity;
  } else {
    frame = {};
  }
  compose_frames(rules, state.modes);
  return true;
}

}  // namespace dripfeed::interpreter
