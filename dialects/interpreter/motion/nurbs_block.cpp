// Fanuc 30i B-64484EN, "NURBS interpolation": the control points P0 … Pn come with the knots K0 … Kn, then the
// remaining `order` knots alone. The curve starts where the tool is, so the first `order` knots are one value, and so
// are the last.
#include "dialects/interpreter/motion/nurbs_block.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dialects/interpreter/motion/curve_chords.h"
#include "dialects/interpreter/motion/move.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::AlarmDetail;

constexpr std::size_t kLeastOrder = 2;
constexpr std::size_t kMostOrder = 4;
constexpr double kSamePlace_mm = 0.0015;  // one and a half least increments

void fail(BlockResult& result, std::string_view reason, AlarmDetail detail = AlarmDetail::none) {
  result.fault = text::DiagnosticId::curve_invalid;
  result.reason = reason;
  result.detail = detail;
}

bool same_knot(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(a)); }

void emit_curve(const CurveInput& input, ModalState& state, MotionBuffer& out, BlockResult& result) {
  for (std::size_t span = input.order - 1; span < input.points.size(); ++span) {
    if (same_knot(input.knots[span], input.knots[span + 1])) continue;
    const auto at = [&](double u) { return point_of_curve(input, span, u); };
    const auto emit = [&](const AxisValues& end) {
      const Target target{.end = end, .commanded = input.commanded};
      ir::Motion& motion = emit_move(ir::MotionKind::spline, target, state.feed, {}, state, out, result);
      motion.place.line = input.lines[span];
    };
    CurveChords(at, emit).run(input.knots[span], input.knots[span + 1]);
  }
}

bool starts_where_the_tool_is(const ModalState& state, const AxisValues& point, std::uint16_t commanded) {
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
    if ((commanded >> axis & 1U) == 0 || (state.unknown >> axis & 1U) != 0) continue;
    if (std::abs(point[axis] - state.position[axis]) > kSamePlace_mm) return false;
  }
  return true;
}

bool begin_curve(const PlainBlock& block, CurveInput& curve, BlockResult& result) {
  const std::size_t kept = curve.order;
  curve = {};
  curve.open = true;
  curve.order = kept;
  if (!block.has(Address::p)) return true;
  const double order = block.at(Address::p);
  if (!(order >= kLeastOrder && order <= kMostOrder && order == std::floor(order))) {
    fail(result, "its order (P) is not 2, 3 or 4", AlarmDetail::order_of_curve);
    return false;
  }
  curve.order = static_cast<std::size_t>(order);
  return true;
}

bool add_point(const PlainBlock& block, const BlockRules& rules, ModalState& state, const MotionBuffer& out,
               BlockResult& result) {
  CurveInput& curve = state.curve;
  // What is not named stays as in the point before.
  const AxisValues tool = state.position;
  if (!curve.points.empty()) state.position = curve.points.back();
  const Target target = find_any_target(block, rules, state, false);
  state.position = tool;
  if (target.unknown != 0) {
    result.notes |= kNoteIncrementalFromUnknown;
    state.unknown |= target.unknown;
  }
  if (curve.points.empty() && !starts_where_the_tool_is(state, target.end, target.commanded)) {
    fail(result, "its first control point is not where the tool is", AlarmDetail::first_point);
    return false;
  }
  curve.commanded |= target.commanded;
  curve.points.push_back(target.end);
  curve.weights.push_back(block.has(Address::r) ? block.at(Address::r) : 1.0);
  curve.lines.push_back(out.place.line);
  if (curve.weights.back() > 0.0) return true;
  fail(result, "a weight (R) is not greater than 0");
  return false;
}

// The first and the last `order` knots are one value each: it begins and ends in a control point.
bool is_clamped(const CurveInput& curve) {
  const std::size_t n = curve.points.size();
  return same_knot(curve.knots.front(), curve.knots[curve.order - 1]) && same_knot(curve.knots[n], curve.knots.back());
}

}  // namespace

// De Boor's algorithm on weighted points (The NURBS Book, A3.1 with A4.1).
AxisValues point_of_curve(const CurveInput& input, std::size_t span, double u) {
  const std::size_t degree = input.order - 1;
  std::array<AxisValues, kMostOrder> points{};
  std::array<double, kMostOrder> weights{};
  for (std::size_t j = 0; j <= degree; ++j) {
    const std::size_t i = span - degree + j;
    weights[j] = input.weights[i];
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) points[j][axis] = input.points[i][axis] * weights[j];
  }
  for (std::size_t r = 1; r <= degree; ++r) {
    for (std::size_t j = degree; j >= r; --j) {
      const std::size_t i = span - degree + j;
      const double width = input.knots[i + degree + 1 - r] - input.knots[i];
      const double share = width > 0.0 ? (u - input.knots[i]) / width : 0.0;
      weights[j] = (1.0 - share) * weights[j - 1] + share * weights[j];
      for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
        points[j][axis] = (1.0 - share) * points[j - 1][axis] + share * points[j][axis];
    }
  }
  AxisValues at{};
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) at[axis] = points[degree][axis] / weights[degree];
  return at;
}

void add_to_curve(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                  BlockResult& result) {
  const bool names_point = ((block.present | block.unknown) & rules.axis_addresses) != 0;
  if (!names_point && !block.has(Address::k)) return;
  CurveInput& curve = state.curve;
  if (!curve.open && !begin_curve(block, curve, result)) return;
  if (names_point) {
    if (curve.points.size() != curve.knots.size()) return fail(result, "a control point after the knots that end it");
    if (!add_point(block, rules, state, out, result)) return;
  }
  if (!block.has(Address::k)) return fail(result, "a control point has no knot (K)");
  const double knot = block.at(Address::k);
  if (!curve.knots.empty() && knot < curve.knots.back()) return fail(result, "its knots (K) fall");
  curve.knots.push_back(knot);
  if (curve.knots.size() < curve.points.size() + curve.order) return;
  const std::size_t order = curve.order;
  const CurveInput complete = std::exchange(curve, {});
  curve.order = order;
  if (complete.points.size() < complete.order) return fail(result, "it has fewer control points than its order (P)");
  if (!is_clamped(complete)) return fail(result, "its first or last knots are not all alike");
  emit_curve(complete, state, out, result);
}

void break_curve(ModalState& state, BlockResult& result) {
  state.curve = {};
  if (result.fault == text::DiagnosticId::count_) fail(result, "it ends before its last knots (K)");
}

}  // namespace dripfeed::interpreter
