// Depths are equal and none is above the greatest infeed. What the manuals leave open of a contour is reported: feeds
// of its own, rapids within it, moves out of its plane.
#include "dialects/interpreter/cycles/mill_path.h"

#include <cmath>

#include "dialects/interpreter/cycles/mill_tool.h"

namespace dripfeed::interpreter {

namespace {

using ir::MotionKind;

constexpr double kNone_mm = 1e-9;
constexpr double kMostDepths = 10'000.0;

struct PathPiece {
  PlanePoint from;
  PlanePoint to;
  PlanePoint center;
  bool is_arc = false;
  Turn turn = Turn::counterclockwise;

  // Along the piece, where it begins or ends; of length 1.
  [[nodiscard]] PlanePoint tangent(bool at_end) const {
    if (!is_arc) return of_length_1({to.p - from.p, to.q - from.q});
    const PlanePoint at = at_end ? to : from;
    const PlanePoint out = {at.p - center.p, at.q - center.q};
    return of_length_1(turn == Turn::counterclockwise ? PlanePoint{-out.q, out.p} : PlanePoint{out.q, -out.p});
  }
  static PlanePoint of_length_1(PlanePoint v) {
    const double length = length_of(v);
    return {v.p / length, v.q / length};
  }
};

bool is_near(PlanePoint a, PlanePoint b) { return length_of({a.p - b.p, a.q - b.q}) < kNone_mm; }
PlanePoint moved(PlanePoint from, PlanePoint along, double by) {
  return {from.p + along.p * by, from.q + along.q * by};
}

class PathMiller {
 public:
  PathMiller(const ir::MillCycle& cycle, const BlockRules& rules, ModalState& state, MotionBuffer& out,
             BlockResult& result)
      : cycle_(cycle),
        state_(state),
        rules_(rules),
        result_(result),
        axes_(axes_of(state.modes.plane)),
        side_(cycle.depth <= cycle.surface ? 1.0 : -1.0),
        feed_(cycle.feed > 0.0 ? cycle.feed : state.feed),
        feed_in_(cycle.feed_in > 0.0 ? cycle.feed_in : feed_),
        tool_(rules, state, out, result) {}

  MillOutcome run(const std::vector<ir::Motion>& contour) {
    MillOutcome outcome;
    outcome.not_interpreted = fault_of_state();
    if (outcome.not_interpreted.empty()) outcome.not_interpreted = take(contour);
    if (outcome.not_interpreted.empty() && stays_down() && !is_near(in_, out_)) {
      outcome.not_interpreted = "without a retract, along a contour that is open";
    }
    if (outcome.not_interpreted.empty()) mill();
    tool_.finish(false);
    if (result_.fault != text::DiagnosticId::count_) outcome = {0, "with an arc that the control cannot make"};
    return outcome;
  }

 private:
  [[nodiscard]] std::string_view fault_of_state() const {
    if (state_.modes.comp != ir::CompSide::off) return "under cutter compensation";
    if (state_.transformation.shape != Transformation::Shape::none) return "on a face or cylinder";
    if (rules_.x_is_diameter) return "on a machine whose X is a diameter";
    if (state_.modes.has_matrix) return "under a frame that turns or stretches it";
    if (!(feed_ > 0.0)) return "without a feed";
    return depth_count() > kMostDepths ? std::string_view("with more than 10000 infeeds") : std::string_view();
  }

  [[nodiscard]] double whole_depth() const { return std::abs(cycle_.surface - cycle_.depth) - cycle_.allowance_base; }
  [[nodiscard]] double depth_count() const {
    if (whole_depth() <= kNone_mm) return 0.0;
    return cycle_.infeed > 0.0 ? std::ceil(whole_depth() / cycle_.infeed - kNone_mm) : 1.0;
  }
  [[nodiscard]] bool stays_down() const { return cycle_.lift == ir::MillLift::none && depth_count() > 1.0; }

  // Of a point of the workpiece, as programmed.
  [[nodiscard]] double programmed(std::size_t axis, double value) const {
    return value - state_.modes.shift[axis] - state_.coordinate_shift[axis];
  }
  [[nodiscard]] PlanePoint point(const std::array<double, ir::kAxisCount>& at) const {
    return {programmed(axes_.p, at[axes_.p]), programmed(axes_.q, at[axes_.q])};
  }

  // Why the contour is not one that is followed; empty: `pieces_`, `in_` and `out_` are made.
  std::string_view take(const std::vector<ir::Motion>& contour) {
    const auto bit = [](std::size_t axis) { return static_cast<std::uint16_t>(1U << axis); };
    const auto plane = static_cast<std::uint16_t>(bit(axes_.p) | bit(axes_.q));
    bool is_first = true;
    for (const ir::Motion& m : contour) {
      const bool is_arc = m.kind == MotionKind::arc_cw || m.kind == MotionKind::arc_ccw;
      if (!is_arc && m.kind != MotionKind::linear && !(is_first && m.kind == MotionKind::rapid))
        return "along a contour of more than lines and arcs";
      if (m.comp != ir::CompSide::off || m.machine_coordinates || (m.gaps & ir::kEndUnknown) != 0)
        return "along a contour of more than lines and arcs";
      const bool leaves = std::abs(m.end[axes_.normal] - m.start[axes_.normal]) > kNone_mm;
      if (leaves || (m.axes_commanded & ~plane) != 0 || (is_arc && m.plane != state_.modes.plane))
        return "along a contour that leaves its plane";
      if (!is_first && m.feed != state_.feed) return "along a contour with feeds of its own";
      if (is_first && (is_arc || (m.axes_unknown & plane & ~m.axes_commanded) != 0))
        return "along a contour whose start is not known";
      if (!is_first) add(m, is_arc);
      is_first = false;
    }
    if (pieces_.empty()) return "along a contour without a move";
    const auto end = [](ir::MillApproach how, double length) {
      return how == ir::MillApproach::straight ? length : 0.0;
    };
    const PathPiece& last = pieces_.back();
    in_ = moved(pieces_.front().from, pieces_.front().tangent(false), -end(cycle_.approach, cycle_.approach_length));
    out_ = moved(last.to, last.tangent(true), end(cycle_.retract, cycle_.retract_length));
    return {};
  }

  void add(const ir::Motion& m, bool is_arc) {
    PathPiece piece = {.from = point(m.start), .to = point(m.end), .center = {}};
    if (!is_arc && is_near(piece.from, piece.to)) return;
    piece.is_arc = is_arc;
    piece.turn = m.kind == MotionKind::arc_ccw ? Turn::counterclockwise : Turn::clockwise;
    piece.center = {piece.from.p + m.center[axes_.p], piece.from.q + m.center[axes_.q]};
    pieces_.push_back(piece);
  }

  void mill() {
    const int count = static_cast<int>(depth_count());
    const double front = cycle_.surface + side_ * cycle_.clearance;
    tool_.rapid_level(cycle_.return_level);
    tool_.rapid(in_);
    if (count > 0) tool_.rapid_level(front);
    for (int n = 1; n <= count; ++n) {
      const double level = cycle_.surface - side_ * whole_depth() * n / count;
      tool_.cut_level(level, feed_in_);
      follow();
      if (n == count) break;
      if (cycle_.lift == ir::MillLift::return_level) tool_.rapid_level(cycle_.return_level);
      if (cycle_.lift == ir::MillLift::in_front) tool_.rapid_level(front);
      if (cycle_.lift == ir::MillLift::clearance) tool_.rapid_level(level + side_ * cycle_.clearance);
      if (cycle_.lift != ir::MillLift::none) tool_.rapid(in_);
    }
    tool_.rapid_level(cycle_.return_level);
  }

  void follow() {
    tool_.cut(pieces_.front().from, feed_);
    for (const PathPiece& piece : pieces_) {
      if (!piece.is_arc) {
        tool_.cut(piece.to, feed_);
        continue;
      }
      // A whole circle has no end of its own.
      if (is_near(piece.from, piece.to))
        tool_.arc({2.0 * piece.center.p - piece.from.p, 2.0 * piece.center.q - piece.from.q}, piece.center, piece.turn,
                  feed_);
      tool_.arc(piece.to, piece.center, piece.turn, feed_);
    }
    tool_.cut(out_, feed_);
  }

  const ir::MillCycle& cycle_;
  ModalState& state_;
  const BlockRules& rules_;
  const BlockResult& result_;
  PlaneAxes axes_;
  double side_;  // in which levels rise from the base
  double feed_;
  double feed_in_;
  MillTool tool_;
  std::vector<PathPiece> pieces_;
  PlanePoint in_;
  PlanePoint out_;
};

}  // namespace

MillOutcome mill_path(const ir::MillCycle& cycle, const std::vector<ir::Motion>& contour, const BlockRules& rules,
                      ModalState& state, MotionBuffer& out, BlockResult& result) {
  return PathMiller(cycle, rules, state, out, result).run(contour);
}

}  // namespace dripfeed::interpreter
