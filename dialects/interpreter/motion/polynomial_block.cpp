// PGA, "Polynomial interpolation (POLY, POLYPATH, PO, PL)": f(p) = a0 + a1 p + a2 p^2 … a5 p^5 for p from 0 to PL. a0
// is where the axis stands and a1 follows from the end, so that with t = p / PL and b_k = a_k PL^k
//
//   f(t) = start + (end - start) t + sum of b_k (t^k - t)
//
// The sum is how far the axis bends aside. It is a vector in the frame that is programmed: a frame turns, stretches and
// mirrors it and does not shift it. Whether the coefficients of a diameter are diameters the manual does not say.
#include "dialects/interpreter/motion/polynomial_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "dialects/interpreter/motion/chord_moves.h"
#include "dialects/interpreter/motion/mover.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;

constexpr std::array kLetters = {Address::x, Address::y, Address::z};
constexpr std::size_t kX = 0;
constexpr double kNoDistance_mm = 1e-9;
constexpr double kShortestInterval = 0.0001;  // PGA: the range of PL
constexpr double kLongestInterval = 99'999.9999;

// b_2 to b_5 of X Y Z, mm as a target's end.
using Bends = std::array<Vector, ir::kLastPower + 1>;

Bends bends_of(const PlainBlock& block, const BlockRules& rules, const ModalState& state, double interval) {
  Bends bends{};
  double scale = interval;
  for (std::size_t power = ir::kFirstPower; power <= ir::kLastPower; ++power) {
    scale *= interval;
    Vector& bend = bends[power];
    for (std::size_t axis = 0; axis < ir::kPolynomialAxes; ++axis) {
      const Address address = ir::coefficient_of(axis, power);
      const bool has_axis = (rules.axis_addresses & bit_of(kLetters[axis])) != 0;
      if (has_axis && block.has(address)) bend[axis] = rules.length_mm(block, address, state.modes.inch) * scale;
    }
    if (state.modes.has_matrix) bend = multiply(state.modes.matrix, bend);
    if (rules.x_is_diameter) bend[kX] *= 2.0;
  }
  return bends;
}

class Polynomial {
 public:
  Polynomial(const AxisValues& start, const AxisValues& end, const Bends& bends)
      : start_(start), end_(end), bends_(bends) {}

  [[nodiscard]] AxisValues at(double t) const {
    if (t == 1.0) return end_;
    AxisValues at{};
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) at[axis] = start_[axis] + t * (end_[axis] - start_[axis]);
    double to_power = t;
    for (std::size_t power = ir::kFirstPower; power <= ir::kLastPower; ++power) {
      to_power *= t;
      for (std::size_t axis = 0; axis < ir::kPolynomialAxes; ++axis) at[axis] += bends_[power][axis] * (to_power - t);
    }
    return at;
  }

  // The direction at its end; none where it stands there.
  [[nodiscard]] std::optional<Vector> end_tangent(bool x_is_diameter) const {
    Vector tangent{};
    for (std::size_t axis = 0; axis < tangent.size(); ++axis) {
      tangent[axis] = end_[axis] - start_[axis];
      for (std::size_t power = ir::kFirstPower; power <= ir::kLastPower; ++power)
        tangent[axis] += bends_[power][axis] * static_cast<double>(power - 1);
    }
    if (x_is_diameter) tangent[kX] /= 2.0;
    if (std::hypot(tangent[0], tangent[1], tangent[2]) < kNoDistance_mm) return std::nullopt;
    return tangent;
  }

  // The axes that are somewhere else in between than on the straight line.
  [[nodiscard]] std::uint16_t bent() const {
    std::uint16_t bits = 0;
    for (const Vector& bend : bends_)
      for (std::size_t axis = 0; axis < bend.size(); ++axis)
        if (bend[axis] != 0.0) bits |= static_cast<std::uint16_t>(1U << axis);
    return bits;
  }

  [[nodiscard]] bool is_finite() const {
    return std::ranges::all_of(bends_, [](const Vector& bend) {
      return std::ranges::all_of(bend, [](double b) { return std::isfinite(b); });
    });
  }

 private:
  AxisValues start_;
  AxisValues end_;
  const Bends& bends_;
};

void fail(BlockResult& result, std::string_view reason) {
  result.fault = text::DiagnosticId::curve_invalid;
  result.reason = reason;
}

bool counts_diameter(const PlainBlock& block, const ModalState& state) {
  if (state.modes.diameter == ir::DiameterMode::radius) return false;
  for (std::size_t power = ir::kFirstPower; power <= ir::kLastPower; ++power) {
    const Address address = ir::coefficient_of(kX, power);
    if (block.has(address) && block.at(address) != 0.0) return true;
  }
  return false;
}

}  // namespace

void move_along_polynomial(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options,
                           const Target& target, ModalState& state, MotionBuffer& out, BlockResult& result) {
  Mover mover(block, rules, options, state, out, result);
  // As under G1 (PGA).
  if (!has_polynomial_words(block)) return mover.straight(ir::MotionKind::linear, target);
  const double interval = block.has(Address::knot_distance) ? block.at(Address::knot_distance) : 1.0;
  if (!(interval >= kShortestInterval && interval <= kLongestInterval))
    return fail(result, "the length of its parameter (PL) is not in 0.0001 to 99999.9999");
  const Bends bends = bends_of(block, rules, state, interval);
  const Polynomial curve(state.position, target.end, bends);
  if (!curve.is_finite()) return fail(result, "its coefficients (PO) give no position");
  const auto moved = static_cast<std::uint16_t>(target.commanded | curve.bent());
  const bool known = ((state.unknown & moved) | target.unknown) == 0 &&
                     (block.unknown & (kPolynomialWords | bit_of(Address::knot_distance))) == 0;
  const bool diameter = counts_diameter(block, state);
  if (!known || diameter || options.machine_coordinates) {
    result.notes |= diameter ? kNotePolynomialDiameter : kNotePolynomialStraight;
    return mover.straight(ir::MotionKind::spline, target);
  }
  if (curve.bent() == 0) return mover.straight(ir::MotionKind::linear, target);
  mover.leave_corners();
  const auto at = [&](double t) { return curve.at(t); };
  emit_chords(chords_of(state.position, at), moved, rules, state, out, result);
  const auto tangent = curve.end_tangent(rules.x_is_diameter);
  state.tangent_known = tangent.has_value();
  state.tangent = tangent.value_or(Vector{});
}

}  // namespace dripfeed::interpreter
