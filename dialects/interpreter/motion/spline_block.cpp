// PGA, "Spline interpolation". A long spline is made in parts: what lies kFar points away has no effect any more on an
// Akima or B spline, and on a cubic one less than half of it is left at each point, 2^-64 in all. That the control
// itself looks at fewer points (MD20160 CUBIC_SPLINE_BLOCKS, 8) is not imitated.
#include "dialects/interpreter/motion/spline_block.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "dialects/interpreter/motion/curve_chords.h"
#include "dialects/interpreter/motion/mover.h"
#include "dialects/interpreter/motion/spline_curve.h"
#include "dialects/ir/spline_use.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;

constexpr std::size_t kKeptAtMost = 1024;  // points
constexpr std::size_t kFar = 64;
constexpr std::size_t kWaitsAtMost = 4 * ir::kMotionBatch;  // motions after a spline that no move follows
constexpr std::uint16_t kSplineAxes = 7;                    // X Y Z
constexpr double kSamePlace_mm = 1e-9;
constexpr double kMostWeight = 3.0;

void fail(BlockResult& result, std::string_view reason) {
  result.fault = text::DiagnosticId::curve_invalid;
  result.reason = reason;
}

// The path of the tool where a move ends or begins, in radius values; none when it is not known.
std::optional<Vector> direction_of(const ir::Motion& m, bool at_end, bool x_is_diameter) {
  if (m.machine_coordinates || (m.axes_unknown & m.axes_commanded & kSplineAxes) != 0 ||
      (m.gaps & ir::kEndUnknown) != 0)
    return std::nullopt;
  Vector direction{};
  for (std::size_t axis = 0; axis < direction.size(); ++axis)
    direction[axis] = (m.end[axis] - m.start[axis]) / (axis == 0 && x_is_diameter ? 2.0 : 1.0);
  if (m.kind == ir::MotionKind::arc_cw || m.kind == ir::MotionKind::arc_ccw) {
    const PlaneAxes axes = axes_of(m.plane);
    const double sign = m.kind == ir::MotionKind::arc_ccw ? 1.0 : -1.0;
    const double p = (at_end ? direction[axes.p] : 0.0) - m.center[axes.p];
    const double q = (at_end ? direction[axes.q] : 0.0) - m.center[axes.q];
    // Of a helix the rise goes with the angle.
    const double radius = std::hypot(m.center[axes.p], m.center[axes.q]);
    const double from = std::atan2(-m.center[axes.q], -m.center[axes.p]);
    const double to = std::atan2(direction[axes.q] - m.center[axes.q], direction[axes.p] - m.center[axes.p]);
    constexpr double kFull = 6.283185307179586;
    double turned = sign * (to - from);
    while (turned <= 1e-12) turned += kFull;
    direction[axes.normal] *= radius > 0.0 ? std::hypot(p, q) / (radius * turned) : 0.0;
    direction[axes.p] = -sign * q;
    direction[axes.q] = sign * p;
  }
  if (std::hypot(direction[0], direction[1], direction[2]) < kSamePlace_mm) return std::nullopt;
  return direction;
}

// Whether an axis that the spline moves is somewhere that is not known. What does not move may be anywhere.
bool is_lost(const ModalState& state) {
  const std::vector<SplinePoint>& points = state.spline.points;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((state.unknown >> axis & 1U) == 0) continue;
    const auto moved = [&](const SplinePoint& p) { return p.at[axis] != points.front().at[axis]; };
    if (std::ranges::any_of(points, moved)) return true;
  }
  return false;
}

bool moves_in_space(const AxisValues& a, const AxisValues& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::abs(a[axis] - b[axis]) > kSamePlace_mm) return true;
  return false;
}

double distance_of(const AxisValues& a, const AxisValues& b, bool x_is_diameter) {
  return std::hypot((b[0] - a[0]) / (x_is_diameter ? 2.0 : 1.0), b[1] - a[1], b[2] - a[2]);
}

// Puts chords in place of the moves that stand for pieces.
class SplineMaker {
 public:
  SplineMaker(const SplineRun& run, const SplineCurve& curve, bool x_is_diameter, MotionBuffer& out)
      : run_(run), curve_(curve), x_is_diameter_(x_is_diameter), out_(out) {}

  // The pieces before point `last`; gives how many motions were taken from the buffer.
  std::size_t make(std::size_t last) {
    std::size_t from = 0;
    for (std::size_t piece = run_.done; piece < last; ++piece) {
      const std::size_t at = run_.points[piece + 1].motion;
      for (; from < at; ++from) made_.push_back(out_.at(from));
      from = at + 1;
      chords(piece, out_.at(at));
    }
    out_.replace(from, made_);
    return from;
  }

 private:
  void chords(std::size_t piece, const ir::Motion& whole) {
    if (waits_.blocks == 0 && waits_.operators == 0) waits_ = whole.compute;
    if (!curve_.has_piece(piece) || curve_.is_empty(piece)) return;
    const std::size_t first = made_.size();
    AxisValues start = curve_.at(piece, 0.0);
    const auto at = [&](double share) { return curve_.at(piece, share); };
    const auto emit = [&](const AxisValues& end) {
      ir::Motion& m = made_.emplace_back(whole);
      m.start = std::exchange(start, end);
      m.end = end;
      for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
        if (m.start[axis] != m.end[axis]) m.axes_commanded |= static_cast<std::uint16_t>(1U << axis);
      m.compute = std::exchange(waits_, {});
    };
    CurveChords(at, emit).run(0.0, 1.0);
    if (whole.feed_mode == ir::FeedMode::inverse_time) share_time(first);
  }

  // The feed is 1 / time of the block.
  void share_time(std::size_t first) {
    double total = 0.0;
    for (std::size_t i = first; i < made_.size(); ++i) total += length(made_[i]);
    for (std::size_t i = first; i < made_.size(); ++i)
      if (const double own = length(made_[i]); own > 0.0) made_[i].feed *= total / own;
  }
  [[nodiscard]] double length(const ir::Motion& m) const { return distance_of(m.start, m.end, x_is_diameter_); }

  const SplineRun& run_;
  const SplineCurve& curve_;
  bool x_is_diameter_;
  MotionBuffer& out_;
  std::vector<ir::Motion> made_;
  ir::ComputeCounts waits_;
};

// Makes the pieces before point `last`, and keeps what later ones depend on.
void make_pieces(std::size_t last, const SplineEnd& end, const BlockRules& rules, ModalState& state,
                 MotionBuffer& out) {
  SplineRun& run = state.spline;
  SplineEnd begin{.kind = run.is_first ? run.begin : ir::kSplineFree, .direction = std::nullopt};
  if (run.tangent_known) begin.direction = run.tangent;
  const SplineCurve curve(run.kind, run.degree, run.points, begin, end, rules.x_is_diameter);
  const std::size_t taken = SplineMaker(run, curve, rules.x_is_diameter, out).make(last);
  for (std::size_t i = last + 1; i < run.points.size(); ++i) run.points[i].motion -= taken;
  if (state.corner.kind != 0) state.corner.motion -= std::min(taken, state.corner.motion);
  run.done = last;
  if (run.done <= kFar) return;
  run.points.erase(run.points.begin(), run.points.begin() + static_cast<std::ptrdiff_t>(run.done - kFar));
  run.done = kFar;
  run.is_first = false;
}

// Its moves are in the buffer, whatever is captured meanwhile.
void close(const SplineEnd& end, const BlockRules& rules, ModalState& state, MotionBuffer& out) {
  std::vector<ir::Motion>* const captured = out.captured();
  out.capture(nullptr);
  if (state.spline.points.size() > 1) make_pieces(state.spline.points.size() - 1, end, rules, state, out);
  state.spline = {};
  out.hold_spline(false);
  out.capture(captured);
}

// The first block of a spline leads to `target`.
void begin(const Target& target, const BlockRules& rules, ModalState& state, MotionBuffer& out) {
  SplineRun run;
  if (const ir::Motion* before = out.last_move(); before != nullptr) {
    const auto direction = direction_of(*before, true, rules.x_is_diameter);
    run.tangent_known = direction.has_value();
    run.tangent = direction.value_or(Vector{});
  }
  if (state.spline.active) {
    ir::Motion next;
    next.start = state.position;
    next.end = target.end;
    close({.kind = state.modes.spline_end, .direction = direction_of(next, false, rules.x_is_diameter)}, rules, state,
          out);
  }
  run.active = true;
  run.kind = state.modes.spline;
  run.begin = state.modes.spline_begin;
  run.points.push_back({.at = state.position});
  state.spline = std::move(run);
  out.hold_spline(true);
}

bool take_words(const PlainBlock& block, SplineRun& run, SplinePoint& point, BlockResult& result) {
  if (block.has(Address::spline_degree)) {
    const double degree = block.at(Address::spline_degree);
    if (degree != 2.0 && degree != 3.0) return fail(result, "its degree (SD) is neither 2 nor 3"), false;
    run.degree = static_cast<std::size_t>(degree);
  }
  if (block.has(Address::point_weight)) point.weight = block.at(Address::point_weight);
  if (!(point.weight >= 0.0 && point.weight <= kMostWeight))
    return fail(result, "a weight (PW) is not in 0 to 3"), false;
  const auto weighs = [](const SplinePoint& p) { return p.weight > 0.0; };
  const auto before = std::span(run.points).last(std::min(run.points.size(), run.degree));
  if (point.weight == 0.0 && std::ranges::none_of(before, weighs))
    return fail(result, "the weights (PW) of a piece are all 0"), false;
  if (block.has(Address::knot_distance)) {
    point.distance = block.at(Address::knot_distance);
    if (!(point.distance >= 0.0)) return fail(result, "a knot distance (PL) is below 0"), false;
  }
  return true;
}

}  // namespace

void move_along_spline(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options,
                       const Target& target, ModalState& state, MotionBuffer& out, BlockResult& result) {
  constexpr std::uint64_t kWords =
      bit_of(Address::spline_degree) | bit_of(Address::point_weight) | bit_of(Address::knot_distance);
  const auto unknown = static_cast<std::uint16_t>((state.unknown & target.commanded) | target.unknown);
  const bool known = (unknown & kSplineAxes) == 0 && (block.unknown & kWords) == 0;
  Mover mover(block, rules, options, state, out, result);
  if (!known || out.captured() != nullptr || options.machine_coordinates) {
    result.notes |= kNoteSplineStraight;
    if (state.spline.active) end_spline(rules, state, out);
    return mover.straight(ir::MotionKind::spline, target);
  }
  if (!state.spline.active || state.spline.kind != state.modes.spline) begin(target, rules, state, out);
  SplineRun& run = state.spline;
  SplinePoint point;
  if (!take_words(block, run, point, result)) return;
  if (!rules.semantics.spline_form_known) result.notes |= kNoteSpline;
  const AxisValues from = state.position;
  mover.straight(ir::MotionKind::spline, target);
  if (!moves_in_space(from, state.position)) return;  // other axes move by themselves
  point.at = state.position;
  point.motion = out.used() - 1;
  run.points.push_back(point);
  // A tangential arc after it goes by the line through the last two points (PG, "CT").
  const auto direction = direction_of(out.at(point.motion), true, rules.x_is_diameter);
  state.tangent_known = direction.has_value();
  state.tangent = direction.value_or(Vector{});
  if (run.points.size() == kKeptAtMost)
    make_pieces(kKeptAtMost - 1 - kFar, {.kind = ir::kSplineFree, .direction = std::nullopt}, rules, state, out);
}

void follow_spline(const BlockRules& rules, ModalState& state, MotionBuffer& out) {
  const bool goes_on = state.modes.motion == ir::Function::spline && state.modes.motion_modelled;
  if ((state.unknown & kSplineAxes) != 0 && is_lost(state)) return end_spline(rules, state, out);
  const std::size_t last = state.spline.points.size() > 1 ? state.spline.points.back().motion + 1 : 0;
  if (last == 0 && goes_on) return;
  SplineEnd end{.kind = state.modes.spline_end, .direction = std::nullopt};
  for (std::size_t i = last; i < out.used(); ++i) {
    const ir::Motion& m = out.at(i);
    if (!ir::is_move(m.kind) || (goes_on && m.kind == ir::MotionKind::spline)) continue;
    end.direction = direction_of(m, false, rules.x_is_diameter);
    return close(end, rules, state, out);
  }
  if (out.used() > last + kWaitsAtMost) end_spline(rules, state, out);
}

void end_spline(const BlockRules& rules, ModalState& state, MotionBuffer& out) {
  close({.kind = state.modes.spline_end, .direction = std::nullopt}, rules, state, out);
}

}  // namespace dripfeed::interpreter
