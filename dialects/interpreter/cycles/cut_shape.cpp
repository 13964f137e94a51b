// Roughing to a shape (G71, G72) and in the shape's own form (G73).
//
//   A *----------------------------    start point; the shape begins with the move from A to A'
//     | pass 1   <-- rapid --          each pass: in by the depth, along to the shape, away at 45 degrees by the
//     |--------------->/               retract, back by rapid
//     | pass 2   <-- rapid --
//     |--------->/   ____ B
//   A'*_________----               at last along the shape itself, the allowances left on it, and back to A
//
// With X and Z in the first block of the shape (type II) hollows are cut pass by pass as well; the order in which a
// control empties several hollows is its own.
#include <algorithm>
#include <cmath>

#include "dialects/interpreter/cycles/repetitive.h"
#include "dialects/interpreter/cycles/shape.h"
#include "dialects/interpreter/motion/move.h"

namespace dripfeed::interpreter {

namespace {

using ir::MotionKind;
using text::DiagnosticId;

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;
constexpr double kPassesAtMost = 100'000.0;
// By as much a shape of type I may go back on a machine that is set so (5145, 5146).
constexpr double kReversalAtMost_mm = 0.5;

class ShapeCutter {
 public:
  ShapeCutter(const std::vector<ir::Motion>& shape, const BlockRules& rules, ModalState& state, MotionBuffer& out,
              BlockResult& result)
      : shape_(shape),
        factor_(rules.x_is_diameter ? 2.0 : 1.0),
        // Places are rounded to the least increment before the cycle sees them.
        tolerance_mm_(1.0 / rules.increments_per_mm),
        is_check_(rules.semantics.unset_is_unknown && rules.semantics.has_vacant),
        state_(state),
        out_(out),
        result_(result),
        data_(state.repetitive),
        along_z_(static_cast<RepetitiveCycle>(data_.cycle) != RepetitiveCycle::rough_along_x) {}

  ShapeFault run() {
    for (const ir::Motion& m : shape_)
      if (ir::is_move(m.kind)) moves_.push_back(m);
    if (moves_.empty()) return fault("no move stands in it", 0);
    const MotionKind first = moves_.front().kind;
    if (first != MotionKind::rapid && first != MotionKind::linear)
      return fault("its first move is neither G00 nor G01", moves_.front().place.line);
    if ((state_.unknown & (1U << kX | 1U << kZ)) != 0) return fault("where it starts is not known", 0);
    x0_ = state_.position[kX];
    z0_ = state_.position[kZ];
    if (static_cast<RepetitiveCycle>(data_.cycle) == RepetitiveCycle::pattern) return pattern();
    return rough();
  }

 private:
  static ShapeFault fault(std::string what, std::uint32_t line) {
    return {DiagnosticId::cycle_shape_invalid, std::move(what), line};
  }

  // --- G73: the whole shape, moved nearer from time to time

  ShapeFault pattern() {
    const std::int32_t passes = std::max(1, data_.passes);
    for (std::int32_t n = 0; n < passes; ++n) {
      const double share = passes == 1 ? 0.0 : static_cast<double>(passes - 1 - n) / (passes - 1);
      const double dx = (data_.relief_x_mm * share + data_.allowance_x_mm) * factor_;
      const double dz = data_.relief_z_mm * share + data_.allowance_z_mm;
      straight(MotionKind::rapid, x0_ + dx, z0_ + dz);
      for (const ir::Motion& m : moves_) repeat(m, dx, dz);
    }
    straight(MotionKind::rapid, x0_, z0_);
    return {};
  }

  void repeat(const ir::Motion& m, double dx, double dz) {
    if (m.kind == MotionKind::rapid || m.kind == MotionKind::linear)
      return straight(m.kind, m.end[kX] + dx, m.end[kZ] + dz);
    ir::Motion& arc = out_.add(m.kind);
    fill_common(arc, state_);
    arc.end[kX] = m.end[kX] + dx;
    arc.end[kZ] = m.end[kZ] + dz;
    arc.center = m.center;
    arc.feed = state_.feed;
    arc.axes_commanded = 1U << kX | 1U << kZ;
    arc.axes_unknown = state_.unknown;
    state_.position = arc.end;
  }

  // --- G71, G72

  ShapeFault rough() {
    build();
    const bool pockets =
        (moves_.front().axes_commanded & (1U << kX)) != 0 && (moves_.front().axes_commanded & (1U << kZ)) != 0;
    std::uint32_t line = 0;
    bool in_level = false;
    ShapeFault reversal;
    if (!pockets && !is_monotonic(segments_, tolerance_mm_, line, in_level)) {
      const bool in_x = in_level == along_z_;
      reversal = {DiagnosticId::cycle_shape_not_monotonic, in_x ? "X" : "Z", line};
      reversal.is_doubtful = is_check_ && is_monotonic(segments_, kReversalAtMost_mm, line, in_level);
      if (!reversal.is_doubtful) return reversal;
    }
    const double start = along_z_ ? x0_ / factor_ : z0_;
    double deepest = begin_.level;
    for (const ShapeSegment& s : segments_)
      deepest = side() < 0.0 ? std::min(deepest, s.to.level) : std::max(deepest, s.to.level);
    const double depth = data_.depth_mm;
    if (depth <= 0.0 || std::abs(deepest - start) / depth > kPassesAtMost) return fault("the depth of a pass", 0);
    // The last level that lies clear of the shape's lowest place; the pass along the shape takes the rest.
    const auto count = static_cast<int>(std::ceil(std::abs(deepest - start) / depth - 1e-9)) - 1;
    for (int n = 1; n <= count; ++n) pass(start + side() * depth * n, pockets);
    along_shape();
    return reversal;
  }

  // Travels and levels with the allowances; the first move leads to the shape and is not a part of it.
  void build() {
    const double dx = data_.allowance_x_mm;
    const double dz = data_.allowance_z_mm;
    const auto point = [&](const AxisValues& p) {
      const double x = p[kX] / factor_ + dx;
      const double z = p[kZ] + dz;
      return along_z_ ? ShapePoint{z, x} : ShapePoint{x, z};
    };
    begin_ = point(moves_.front().end);
    for (std::size_t i = 1; i < moves_.size(); ++i) {
      const ir::Motion& m = moves_[i];
      ShapeSegment s;
      s.from = point(m.start);
      s.to = point(m.end);
      s.line = m.place.line;
      s.arc = m.kind == MotionKind::arc_cw || m.kind == MotionKind::arc_ccw;
      if (s.arc) {
        const double cx = m.start[kX] / factor_ + dx + m.center[0];
        const double cz = m.start[kZ] + dz + m.center[2];
        s.center = along_z_ ? ShapePoint{cz, cx} : ShapePoint{cx, cz};
        s.turn = turn_of(s, (m.kind == MotionKind::arc_ccw) == along_z_);
      }
      segments_.push_back(s);
    }
  }
  // In the direction of the cut.
  [[nodiscard]] double side() const {
    const double start = along_z_ ? x0_ / factor_ : z0_;
    if (std::abs(begin_.level - start) > 1e-9) return begin_.level < start ? -1.0 : 1.0;
    return segments_.empty() || segments_.back().to.level >= start ? -1.0 : 1.0;
  }
  [[nodiscard]] double begin_along() const { return along_z_ ? z0_ : x0_ / factor_; }
  [[nodiscard]] double forward() const {
    const double end = segments_.empty() ? begin_.travel : segments_.back().to.travel;
    return end < begin_along() ? -1.0 : 1.0;
  }

  // Travels at which the level goes into the shape and out of it, in the order of the cut. The first stretch begins at
  // the start point.
  struct Stretch {
    double from;
    double to;
  };
  [[nodiscard]] std::vector<Stretch> stretches(double level, bool pockets) const {
    std::vector<Stretch> found;
    const double last = segments_.empty() ? begin_.travel : segments_.back().to.travel;
    const auto is_free = [&](double at) { return side() < 0.0 ? at < level - 1e-9 : at > level + 1e-9; };
    bool open = is_free(begin_.level) || std::abs(begin_.level - level) <= 1e-9;
    double from = begin_along();
    for (const ShapeSegment& s : segments_) {
      const bool free_after = is_free(s.to.level);
      if (open && !free_after) {
        if (const auto at = travel_at(s, level)) {
          found.push_back({from, *at});
          open = false;
        }
      } else if (!open && free_after && pockets) {
        if (const auto at = travel_at(s, level)) {
          from = *at;
          open = true;
        }
      }
      if (!pockets && !open) break;
    }
    if (open) found.push_back({from, last});
    return found;
  }

  void pass(double level, bool pockets) {
    const double e = data_.retract_mm;
    bool first = true;
    for (const Stretch& s : stretches(level, pockets)) {
      if ((s.to - s.from) * forward() <= 1e-9) continue;
      to(MotionKind::rapid, s.from, here().level);
      to(first && moves_.front().kind == MotionKind::rapid ? MotionKind::rapid : MotionKind::linear, s.from, level);
      to(MotionKind::linear, s.to, level);
      to(MotionKind::linear, s.to - forward() * e, level - side() * e);
      first = false;
    }
    to(MotionKind::rapid, begin_along(), here().level);
  }

  void along_shape() {
    to(MotionKind::rapid, begin_along(), here().level);
    const bool by_rapid = moves_.front().kind == MotionKind::rapid;
    to(by_rapid ? MotionKind::rapid : MotionKind::linear, begin_.travel, begin_.level);
    const double dx = data_.allowance_x_mm * factor_;
    for (std::size_t i = 1; i < moves_.size(); ++i) {
      ir::Motion m = moves_[i];
      if (m.kind == MotionKind::rapid) m.kind = MotionKind::linear;
      repeat(m, dx, data_.allowance_z_mm);
    }
    straight(MotionKind::rapid, x0_, z0_);
  }

  // --- motions

  [[nodiscard]] ShapePoint here() const {
    const double x = state_.position[kX] / factor_;
    const double z = state_.position[kZ];
    return along_z_ ? ShapePoint{z, x} : ShapePoint{x, z};
  }
  void to(MotionKind kind, double travel, double level) {
    straight(kind, (along_z_ ? level : travel) * factor_, along_z_ ? travel : level);
  }
  void straight(MotionKind kind, double x, double z) {
    Target target{.end = state_.position};
    target.end[kX] = x;
    target.end[kZ] = z;
    if (x != state_.position[kX]) target.commanded |= 1U << kX;
    if (z != state_.position[kZ]) target.commanded |= 1U << kZ;
    if (target.commanded == 0) return;
    emit_move(kind, target, kind == MotionKind::rapid ? 0.0 : state_.feed, {}, state_, out_, result_);
  }

  const std::vector<ir::Motion>& shape_;
  double factor_;
  double tolerance_mm_;
  bool is_check_;
  ModalState& state_;
  MotionBuffer& out_;
  BlockResult& result_;
  Repetitive data_;
  bool along_z_;
  std::vector<ir::Motion> moves_;
  std::vector<ShapeSegment> segments_;
  ShapePoint begin_;
  double x0_ = 0.0;
  double z0_ = 0.0;
};

}  // namespace

ShapeFault cut_shape(const std::vector<ir::Motion>& shape, const BlockRules& rules, ModalState& state,
                     MotionBuffer& out, BlockResult& result) {
  return ShapeCutter(shape, rules, state, out, result).run();
}

}  // namespace dripfeed::interpreter
