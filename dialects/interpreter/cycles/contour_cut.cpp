// Roughing, seen with the travel to the left and the level upward (outside, along Z):
//
//   S *------------------------------   S: the lift next to the contour's first travel and over its highest level
//     |  <-- rapid, lifted --  /
//     | pass n -------------->/ up the contour to the level of the pass before
//     |--------------------->/
//   contour begins *________/           the passes are equal, none deeper than MID
//
// After a height of the contour lie its relief cuts; each is roughed by itself when all that can be reached from in
// front is done: down its flank by FF2, along the level to the other one, up and off.
//
// Finishing goes along the contour once. A contour that is drawn from its other end is taken backwards. Outside the
// levels go deeper against their axis, inside along it, whether the travel is Z or X (PGZ, VARI; from memory). What the
// cycle does beyond this is reported: a relief cut within another one or at the end.
#include "dialects/interpreter/cycles/contour_cut.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dialects/interpreter/cycles/contour_offset.h"
#include "dialects/interpreter/cycles/contour_sections.h"
#include "dialects/interpreter/motion/events.h"
#include "dialects/interpreter/motion/move.h"

namespace dripfeed::interpreter {

namespace {

using ir::MotionKind;

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;
constexpr double kSmall = 1e-9;
constexpr double kPassesAtMost = 10'000.0;
constexpr double kDwellsAtMost = 10'000.0;
constexpr std::uint32_t kAlarmKind = 61'002;   // machining type defined incorrectly
constexpr std::uint32_t kAlarmFeed = 61'003;   // no feed programmed in the cycle
constexpr std::uint32_t kAlarmShape = 61'701;  // error in the contour description

using Piece = ContourPiece;

class ContourCutter {
 public:
  ContourCutter(const ContourCycle& cycle, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                BlockResult& result)
      : cycle_(cycle),
        factor_(rules.x_is_diameter ? 2.0 : 1.0),
        state_(state),
        out_(out),
        result_(result),
        along_z_(cycle.kind % 2 == 1),
        side_(is_outside(cycle.kind) ? -1.0 : 1.0) {}

  ContourOutcome run(const std::vector<ir::Motion>& contour) {
    if (cycle_.kind < 1 || cycle_.kind > 12) return {kAlarmKind, {}};
    const bool roughs = cycle_.kind <= 4 || cycle_.kind >= 9;
    const bool finishes = cycle_.kind >= 5;
    if ((roughs && cycle_.rough_feed <= 0.0) || (finishes && cycle_.finish_feed <= 0.0)) return {kAlarmFeed, {}};
    if (roughs && cycle_.depth_mm <= 0.0) return {kAlarmKind, {}};
    if (state_.modes.has_matrix) return {0, "under a frame that turns"};
    if (const ContourOutcome fault = build(contour); fault.alarm != 0 || !fault.not_interpreted.empty()) return fault;
    const double before = state_.feed;
    if (roughs) {
      const double total = std::abs(top() - bottom());
      if (total / cycle_.depth_mm > kPassesAtMost) return {kAlarmShape, {}};
      if (!reliefs_.empty() && cycle_.relief_feed <= 0.0) return {kAlarmFeed, {}};
      state_.feed = cycle_.rough_feed;
      rough(total);
    }
    if (finishes) {
      state_.feed = cycle_.finish_feed;
      finish();
    }
    state_.feed = before;
    return {};
  }

 private:
  static bool is_outside(int kind) { return (kind - 1) % 4 < 2; }

  // --- the contour

  ContourOutcome build(const std::vector<ir::Motion>& contour) {
    std::vector<ir::Motion> moves;
    for (const ir::Motion& m : contour)
      if (ir::is_move(m.kind)) moves.push_back(m);
    if (moves.size() < 2) return {kAlarmShape, {}};
    for (std::size_t i = 1; i < moves.size(); ++i) {
      const ir::Motion& m = moves[i];
      const bool arc = m.kind == MotionKind::arc_cw || m.kind == MotionKind::arc_ccw;
      if ((m.axes_unknown & m.axes_commanded & (1U << kX | 1U << kZ)) != 0)
        return {0, "along a contour whose points are not known"};
      if (!arc && m.kind != MotionKind::linear) return {kAlarmShape, {}};
      if (!arc && m.start[kX] == m.end[kX] && m.start[kZ] == m.end[kZ]) continue;
      add(m, arc);
    }
    if (pieces_.empty()) return {kAlarmShape, {}};
    // Levels rise away from the material; a contour that falls is drawn from its other end.
    const double rise = (pieces_.back().segment.to.level - pieces_.front().segment.from.level) * -side_;
    if (rise < -kSmall) reverse();
    if (!shift()) return {0, "with an allowance along the contour (FAL) that a piece of it is too short for"};
    ContourSections sections = sections_of(rough_, -side_);
    if (!sections.not_interpreted.empty()) return {0, std::move(sections.not_interpreted)};
    if (std::abs(rise) < kSmall && sections.reliefs.empty()) return {kAlarmShape, {}};
    rough_ = std::move(sections.front);
    reliefs_ = std::move(sections.reliefs);
    return {};
  }

  void add(const ir::Motion& m, bool arc) {
    Piece p;
    p.ccw = m.kind == MotionKind::arc_ccw;
    p.segment.from = point(m.start[kX] / factor_, m.start[kZ]);
    p.segment.to = point(m.end[kX] / factor_, m.end[kZ]);
    p.segment.line = m.place.line;
    p.segment.arc = arc;
    if (arc) p.segment.center = point(m.start[kX] / factor_ + m.center[0], m.start[kZ] + m.center[2]);
    if (arc) p.segment.turn = turn_of(p.segment, p.ccw == along_z_);
    pieces_.push_back(p);
  }

  void reverse() {
    std::ranges::reverse(pieces_);
    for (Piece& p : pieces_) {
      std::swap(p.segment.from, p.segment.to);
      p.segment.turn = -p.segment.turn;
      p.ccw = !p.ccw;
    }
  }

  // The allowances lie on the side of the tool: FAL next to the contour, those along the axes besides. False when a
  // piece is too short.
  bool shift() {
    forward_ = pieces_.back().segment.to.travel < pieces_.front().segment.from.travel ? -1.0 : 1.0;
    first_ = pieces_.front().segment.from;
    rough_ = pieces_;
    if (cycle_.allowance_mm > 0.0) {
      auto offset_shape = offset_contour(pieces_, cycle_.allowance_mm, {forward_, -side_, along_z_});
      if (!offset_shape.has_value()) return false;
      rough_ = std::move(*offset_shape);
    }
    const double travel_allowance = along_z_ ? cycle_.allowance_z_mm : cycle_.allowance_x_mm;
    const double in_level = along_z_ ? cycle_.allowance_x_mm : cycle_.allowance_z_mm;
    const double dw = -forward_ * std::abs(travel_allowance);
    const double dl = -side_ * std::abs(in_level);
    for (Piece& p : rough_) {
      for (ShapePoint* at : {&p.segment.from, &p.segment.to, &p.segment.center}) {
        at->travel += dw;
        at->level += dl;
      }
    }
    return true;
  }

  // --- roughing

  [[nodiscard]] double bottom() const { return rough_.front().segment.from.level; }
  [[nodiscard]] double top() const { return rough_.back().segment.to.level; }
  [[nodiscard]] double first_travel() const { return rough_.front().segment.from.travel - forward_ * cycle_.lift_mm; }
  [[nodiscard]] double clear_level() const { return top() - side_ * cycle_.lift_mm; }

  // At most kPassesAtMost: more are an alarm before the first.
  [[nodiscard]] int passes_for(double total) const {
    return static_cast<int>(std::max(1.0, std::ceil(total / cycle_.depth_mm - kSmall)));
  }

  void rough(double total) {
    to(MotionKind::rapid, first_travel(), clear_level());
    const int count = passes_for(total);
    for (int n = 1; n <= count; ++n) {
      const double level = n == count ? bottom() : top() + side_ * total * n / count;
      const double above = top() + side_ * total * (n - 1) / count;
      pass(level, above);
    }
    for (const Relief& relief : reliefs_) rough(relief);
    to(MotionKind::rapid, here().travel, clear_level());
    to(MotionKind::rapid, first_travel(), clear_level());
  }

  void rough(const Relief& relief) {
    const double height = relief.begin().level;
    const double total = std::abs(height - relief.bottom_level());
    const int count = passes_for(total);
    for (int n = 1; n <= count; ++n) {
      const double level = n == count ? relief.bottom_level() : height + side_ * total * n / count;
      pass(relief, level, height + side_ * total * (n - 1) / count);
    }
  }

  // What lies over the level above is cut already, and so is the travel over the height.
  void pass(const Relief& relief, double level, double above) {
    const double over = relief.begin().level - side_ * cycle_.lift_mm;
    const ShapePoint begin{travel_down(relief, above), above};
    to(MotionKind::rapid, here().travel, over);
    to(MotionKind::rapid, begin.travel, over);
    to(MotionKind::rapid, begin.travel, above - side_ * cycle_.lift_mm);
    const double rough_feed = std::exchange(state_.feed, cycle_.relief_feed);
    to(MotionKind::linear, begin.travel, begin.level);
    along(relief.down, begin, level, side_);
    state_.feed = rough_feed;
    ShapePoint met = relief.up.front().segment.from;
    for (const Piece& p : relief.up)
      if ((p.segment.from.level - level) * -side_ <= kSmall)
        met = {travel_at(p.segment, level).value_or(met.travel), level};
    cut_along(met.travel, level);
    along(relief.up, met, above, -side_);
    const double room = std::abs(here().travel - begin.travel);
    to(MotionKind::rapid, here().travel - forward_ * std::min(cycle_.lift_mm, room),
       here().level - side_ * cycle_.lift_mm);
  }

  // Where the flank that goes down has the level.
  [[nodiscard]] static double travel_down(const Relief& relief, double level) {
    for (const Piece& p : relief.down)
      if (const auto travel = travel_at(p.segment, level)) return *travel;
    return relief.begin().travel;
  }

  // From a point on one of the pieces to where they reach the level, in which `direction` says how levels go there.
  void along(const std::vector<Piece>& pieces, ShapePoint from, double level, double direction) {
    for (const Piece& p : pieces) {
      if ((p.segment.to.level - from.level) * direction <= kSmall) continue;
      const bool ends = (p.segment.to.level - level) * direction >= -kSmall;
      const ShapePoint end =
          ends ? ShapePoint{travel_at(p.segment, level).value_or(p.segment.to.travel), level} : p.segment.to;
      follow(p, from, end);
      from = end;
      if (ends) return;
    }
  }

  // Along the level to the contour, up the contour to the level above, off and back.
  void pass(double level, double above) {
    to(MotionKind::rapid, first_travel(), here().level);
    to(MotionKind::rapid, first_travel(), level);
    std::size_t at = 0;
    while (at + 1 < rough_.size() && (rough_[at].segment.to.level - level) * -side_ <= kSmall) ++at;
    const ShapeSegment& met = rough_[at].segment;
    ShapePoint from{travel_at(met, level).value_or(met.from.travel), level};
    cut_along(from.travel, level);
    for (; at < rough_.size(); ++at) {
      const ShapeSegment& s = rough_[at].segment;
      const bool ends = (s.to.level - above) * -side_ >= -kSmall;
      const ShapePoint end = ends ? ShapePoint{travel_at(s, above).value_or(s.to.travel), above} : s.to;
      follow(rough_[at], from, end);
      from = end;
      if (ends) break;
    }
    to(MotionKind::rapid, from.travel - forward_ * cycle_.lift_mm, from.level - side_ * cycle_.lift_mm);
    to(MotionKind::rapid, first_travel(), here().level);
  }

  // Interrupted every DAM by a dwell that breaks the chip.
  void cut_along(double travel, double level) {
    const double length = std::abs(travel - here().travel);
    const double piece = cycle_.dwell_distance_mm;
    if (piece > 0.0 && length / piece < kDwellsAtMost) {
      const double begin = here().travel;
      for (double n = 1.0; n * piece < length - kSmall; ++n) {
        to(MotionKind::linear, begin + (travel > begin ? piece : -piece) * n, level);
        if (cycle_.dwell_s > 0.0) emit_event(MotionKind::dwell, state_, out_).feed = cycle_.dwell_s;
      }
    }
    to(MotionKind::linear, travel, level);
  }

  void follow(const Piece& piece, ShapePoint from, ShapePoint end) {
    if (!piece.segment.arc) return to(MotionKind::linear, end.travel, end.level);
    if (std::abs(from.travel - end.travel) < kSmall && std::abs(from.level - end.level) < kSmall) return;
    const ShapePoint c = piece.segment.center;
    ir::Motion& arc = out_.add(piece.ccw ? MotionKind::arc_ccw : MotionKind::arc_cw);
    fill_common(arc, state_);
    arc.end[kX] = (along_z_ ? end.level : end.travel) * factor_;
    arc.end[kZ] = along_z_ ? end.travel : end.level;
    arc.center = {};
    arc.center[0] = along_z_ ? c.level - from.level : c.travel - from.travel;
    arc.center[2] = along_z_ ? c.travel - from.travel : c.level - from.level;
    arc.feed = state_.feed;
    arc.axes_commanded = 1U << kX | 1U << kZ;
    arc.axes_unknown = state_.unknown;
    state_.position = arc.end;
  }

  // --- finishing

  void finish() {
    const double travel = first_.travel - forward_ * cycle_.lift_mm;
    const double clear = pieces_.back().segment.to.level - side_ * cycle_.lift_mm;
    to(MotionKind::rapid, travel, std::max(clear * -side_, here().level * -side_) * -side_);
    to(MotionKind::rapid, travel, first_.level);
    to(MotionKind::linear, first_.travel, first_.level);
    for (const Piece& p : pieces_) follow(p, p.segment.from, p.segment.to);
    const ShapePoint last = pieces_.back().segment.to;
    to(MotionKind::rapid, last.travel - forward_ * cycle_.lift_mm, last.level - side_ * cycle_.lift_mm);
    to(MotionKind::rapid, travel, here().level);
  }

  // --- motions

  [[nodiscard]] ShapePoint point(double x, double z) const { return along_z_ ? ShapePoint{z, x} : ShapePoint{x, z}; }
  [[nodiscard]] ShapePoint here() const { return point(state_.position[kX] / factor_, state_.position[kZ]); }
  void to(MotionKind kind, double travel, double level) {
    Target target{.end = state_.position};
    target.end[kX] = (along_z_ ? level : travel) * factor_;
    target.end[kZ] = along_z_ ? travel : level;
    for (const std::size_t axis : {kX, kZ}) {
      const bool moves = std::abs(target.end[axis] - state_.position[axis]) > kSmall;
      const bool unknown = (state_.unknown >> axis & 1U) != 0;
      if (moves || unknown) target.commanded |= static_cast<std::uint16_t>(1U << axis);
    }
    if (target.commanded == 0) return;
    emit_move(kind, target, kind == MotionKind::rapid ? 0.0 : state_.feed, {}, state_, out_, result_);
  }

  const ContourCycle& cycle_;
  double factor_;
  ModalState& state_;
  MotionBuffer& out_;
  BlockResult& result_;
  bool along_z_;
  double side_;  // in which the levels go deeper
  double forward_ = -1.0;
  std::vector<Piece> pieces_;  // as drawn, from the deepest level on
  std::vector<Piece> rough_;   // with the allowances, and as it is met from in front
  std::vector<Relief> reliefs_;
  ShapePoint first_;
};

}  // namespace

ContourOutcome cut_contour(const std::vector<ir::Motion>& contour, const ContourCycle& cycle, const BlockRules& rules,
                           ModalState& state, MotionBuffer& out, BlockResult& result) {
  return ContourCutter(cycle, rules, state, out, result).run(contour);
}

}  // namespace dripfeed::interpreter
