// At each place the tool comes by rapid to the return level, over its start, and to the clearance in front of the
// surface; it goes back to the return level by rapid.
//
//   pocket    in at the centre by rapid, straight, on a helix or to and fro; at each depth rings from the inside to the
//             outline, no wider apart than the step; back to the centre. The side is finished depth by depth, on and
//             off it by quarter circles of 2 mm; then the base by rings at its depth.
//   spigot    the start lies beyond the blank at +x; at each depth on to the outline by a half circle, once around, off
//             by a half circle back to the start.
//   bent slot down by feed at its first end; at each depth along its middle and back, and rings from the inside to the
//             outline. The side is finished depth by depth, on and off it by quarter circles of 2 mm.
//   long hole from end to end, in by the next depth at each end, and once along at the last.
//   face      straight cuts at each depth; the first begins beyond the face by the clearance.
//
// Depths are equal and none is above the greatest infeed (PGZ, "POCKET3", _MID). What the manual leaves to the cycle,
// the order of the rings and cuts, is ours, with a step of at most 80 % of the tool's diameter in a pocket: sharp
// corners of two rings then leave nothing between them.
#include "dialects/interpreter/cycles/milling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dialects/interpreter/cycles/bent_slot.h"
#include "dialects/interpreter/cycles/mill_outline.h"
#include "dialects/interpreter/cycles/mill_tool.h"

namespace dripfeed::interpreter {

namespace {

using ir::MillDirection;
using ir::MillEntry;
using ir::MillShape;

constexpr double kNone_mm = 1e-9;
constexpr double kMostSteps = 10'000.0;          // of depth, of rings, of cuts
constexpr double kUsualStep = 0.8;               // of the tool's diameter
constexpr double kApproach_mm = 2.0;             // radius of the quarter circles to a side
constexpr double kInnermost = 0.9;               // half width of the innermost ring, in tool radii
constexpr std::uint32_t kAlarmSpindle = 61'102;  // no direction of the spindle
constexpr std::uint32_t kAlarmTool = 61'105;     // the cutter's radius is too large
constexpr std::uint32_t kAlarmStep = 61'111;     // the infeed's width is above the tool's diameter
constexpr std::string_view kTooMany = "with more than 10000 infeeds";

class Miller {
 public:
  Miller(const ir::MillCycle& cycle, double radius_mm, const BlockRules& rules, ModalState& state, MotionBuffer& out,
         BlockResult& result)
      : cycle_(cycle),
        rules_(rules),
        state_(state),
        result_(result),
        radius_(radius_mm),
        feed_(cycle.feed > 0.0 ? cycle.feed : state.feed),
        feed_in_(cycle.feed_in > 0.0 ? cycle.feed_in : feed_),
        finish_feed_(cycle.finish_feed > 0.0 ? cycle.finish_feed : feed_),
        side_(cycle.depth <= cycle.surface ? 1.0 : -1.0),
        tool_(rules, state, out, result) {}

  MillOutcome run() {
    MillOutcome outcome = check();
    if (outcome.alarm == 0 && outcome.not_interpreted.empty()) {
      tool_.rapid_level(cycle_.return_level);
      for (const ir::MillPlace& place : cycle_.places) {
        tool_.go_to_place(place);
        mill_place();
        tool_.rapid_level(cycle_.return_level);
      }
    }
    tool_.finish(cycle_.shape == MillShape::pocket && cycle_.places.size() == 1);
    if (result_.fault != text::DiagnosticId::count_) outcome = {0, "with an arc that the control cannot make"};
    return outcome;
  }

 private:
  // --- what the cycle refuses

  MillOutcome check() {
    const PlaneAxes axes = axes_of(state_.modes.plane);
    if (state_.modes.comp != ir::CompSide::off) return {0, "under cutter compensation"};
    if (state_.transformation.shape != Transformation::Shape::none) return {0, "on a face or cylinder"};
    if (rules_.x_is_diameter) return {0, "on a machine whose X is a diameter"};
    if (state_.modes.has_matrix && (image_of(state_.modes.matrix, axes).tilted || !keeps_shapes(state_.modes.matrix)))
      return {0, "under a frame that tilts or stretches it"};
    if (state_.modes.has_matrix && (state_.unknown & 7U) != 0) return {0, "under a frame, from an unknown place"};
    if (!(feed_ > 0.0)) return {0, "without a feed"};
    if (const MillOutcome fault = turn(); fault.alarm != 0) return fault;
    if (cycle_.shape != MillShape::face && too_large()) return {kAlarmTool, {}};
    if (leaves_a_rest()) return {0, "by a tool that is narrower than half of the slot"};
    if (cycle_.step > 2.0 * radius_ + kNone_mm || cycle_.step_of_tool > 1.0 + kNone_mm) return {kAlarmStep, {}};
    if (steps(depth_of(cycle_.allowance_base), cycle_.infeed) > kMostSteps) return {0, kTooMany};
    if (steps(depth_of(0.0), cycle_.finish_infeed) > kMostSteps) return {0, kTooMany};
    if ((std::max(cycle_.length, cycle_.width) + cycle_.beyond_side) / step() > kMostSteps) return {0, kTooMany};
    return cycle_.roughs && cycle_.shape == MillShape::pocket ? check_entry() : MillOutcome{};
  }

  [[nodiscard]] MillOutcome check_entry() const {
    const bool turns = depth_of(0.0) + cycle_.clearance <= kMostSteps * cycle_.entry_depth;
    const bool swings = cycle_.entry_angle_deg > 0.01 && cycle_.entry_angle_deg < 90.0;
    if (cycle_.entry == MillEntry::helix && !turns) return {0, "with a helix of no depth"};
    if (cycle_.entry == MillEntry::oscillation && !swings) return {0, "with an angle of insertion that is none"};
    return {};
  }

  // Inside of a pocket the tool cuts on its right side, clockwise, where it goes around counterclockwise.
  MillOutcome turn() {
    const bool by_side = cycle_.direction == MillDirection::climb || cycle_.direction == MillDirection::conventional;
    const bool is_inside = cycle_.shape == MillShape::pocket || cycle_.shape == MillShape::bent_slot;
    const bool is_rounded = is_inside || cycle_.shape == MillShape::spigot;
    if (!by_side) turn_ = cycle_.direction == MillDirection::clockwise ? Turn::clockwise : Turn::counterclockwise;
    if (!by_side || !is_rounded) return {};
    if (state_.spindle == ir::SpindleState::stopped && !may_be_older(rules_.semantics, state_, ir::ModalGroup::spindle))
      return {kAlarmSpindle, {}};
    const bool climbs = cycle_.direction == MillDirection::climb;
    const bool is_reversed = state_.spindle == ir::SpindleState::counterclockwise;
    turn_ = (climbs != is_reversed) == is_inside ? Turn::counterclockwise : Turn::clockwise;
    return {};
  }

  [[nodiscard]] bool too_large() const {
    if (cycle_.shape == MillShape::spigot) return false;
    if (cycle_.shape == MillShape::long_hole) return 2.0 * radius_ > cycle_.length + kNone_mm;
    if (cycle_.shape == MillShape::bent_slot) return 2.0 * radius_ > cycle_.width + kNone_mm;
    return 2.0 * radius_ > std::min(cycle_.length, cycle_.width) + kNone_mm;
  }

  // ShopMill (BAS) 10.04, "Circumferential slot": below it the control leaves material between its two rounds.
  [[nodiscard]] bool leaves_a_rest() const {
    const double half = cycle_.width / 2.0 - (cycle_.roughs ? cycle_.allowance_side : 0.0);
    return cycle_.shape == MillShape::bent_slot && 2.0 * radius_ < half - kNone_mm;
  }

  // --- depths and widths

  [[nodiscard]] double depth_of(double allowance) const { return std::abs(cycle_.surface - cycle_.depth) - allowance; }
  [[nodiscard]] double in_front() const { return cycle_.surface + side_ * cycle_.clearance; }
  static double steps(double distance, double most) {
    return distance > kNone_mm && most > 0.0 ? std::ceil(distance / most - kNone_mm) : 1.0;
  }
  // What `check` has not let pass is not counted.
  static int counted(double steps) { return static_cast<int>(std::clamp(steps, 0.0, kMostSteps)); }
  // Levels from the surface down to what the allowance leaves; none where it leaves all.
  template <typename Cut>
  void at_each_depth(double allowance, double most, Cut cut) {
    const double depth = depth_of(allowance);
    if (depth <= kNone_mm) return;
    const int count = counted(steps(depth, most));
    for (int n = 1; n <= count; ++n) cut(cycle_.surface - side_ * depth * n / count);
  }
  [[nodiscard]] double step() const {
    if (cycle_.step > 0.0) return cycle_.step;
    return 2.0 * radius_ * (cycle_.step_of_tool > 0.0 ? cycle_.step_of_tool : kUsualStep);
  }

  void mill_place() {
    switch (cycle_.shape) {
      case MillShape::pocket: return mill_pocket();
      case MillShape::spigot: return mill_spigot();
      case MillShape::long_hole: return mill_long_hole();
      case MillShape::bent_slot: return mill_bent_slot();
      case MillShape::face: return mill_face();
      case MillShape::path: return;  // mill_path.h
    }
  }

  // --- pockets

  [[nodiscard]] MillOutline pocket(double allowance) const {
    const MillOutline wall = {cycle_.length / 2.0, cycle_.width / 2.0, cycle_.corner_radius};
    return wall.inside(radius_ + allowance);
  }

  void mill_pocket() {
    tool_.rapid({0.0, 0.0});
    tool_.rapid_level(in_front());
    if (cycle_.roughs) {
      double above = in_front();
      at_each_depth(cycle_.allowance_base, cycle_.infeed, [&](double level) {
        enter(above, level);
        rings(pocket(cycle_.allowance_side), feed_);
        above = level;
      });
    }
    if (cycle_.finishes_side)
      at_each_depth(cycle_.finishes_base ? cycle_.allowance_base : 0.0, cycle_.finish_infeed, [&](double level) {
        tool_.rapid_level(level);
        const MillOutline wall = pocket(0.0);
        finish_side(wall, wall.smaller_half());
        tool_.cut({0.0, 0.0}, finish_feed_);
      });
    if (!cycle_.finishes_base) return;
    tool_.rapid_level(
        std::min(in_front() * side_, (cycle_.depth + side_ * (cycle_.allowance_base + cycle_.clearance)) * side_) *
        side_);
    tool_.cut_level(cycle_.depth, feed_in_);
    rings(pocket(0.0), finish_feed_);
  }

  // From the centre at the level above to the centre at the level.
  void enter(double above, double level) {
    const MillOutline room = pocket(cycle_.allowance_side);
    const double radius = std::min(cycle_.entry_radius, room.smaller_half());
    const double swing = room.half_length;
    if (cycle_.entry == MillEntry::rapid) return tool_.rapid_level(level);
    if (cycle_.entry == MillEntry::helix && radius > kNone_mm) return enter_by_helix(radius, above, level);
    if (cycle_.entry == MillEntry::oscillation && swing > kNone_mm) return enter_to_and_fro(swing, above, level);
    tool_.cut_level(level, feed_in_);
  }

  void enter_by_helix(double radius, double above, double level) {
    const int halves = 2 * counted(steps(std::abs(above - level), cycle_.entry_depth));
    tool_.cut({radius, 0.0}, feed_);
    for (int half = 1; half <= halves; ++half) {
      const double x = half % 2 == 1 ? -radius : radius;
      tool_.helix({x, 0.0}, {0.0, 0.0}, above + (level - above) * half / halves, turn_, feed_);
    }
    tool_.arc({-radius, 0.0}, {0.0, 0.0}, turn_, feed_);
    tool_.arc({radius, 0.0}, {0.0, 0.0}, turn_, feed_);
    tool_.cut({0.0, 0.0}, feed_);
  }

  void enter_to_and_fro(double swing, double above, double level) {
    const double deepest = 2.0 * swing * std::tan(cycle_.entry_angle_deg * std::numbers::pi / 180.0);
    const int runs = counted(steps(std::abs(above - level), deepest));
    tool_.cut({-swing, 0.0}, feed_);
    for (int run = 1; run <= runs; ++run) {
      const double x = run % 2 == 1 ? swing : -swing;
      tool_.cut({x, 0.0}, above + (level - above) * run / runs, feed_);
    }
    tool_.cut({0.0, 0.0}, feed_);
  }

  // From the centre, and back to it.
  void rings(const MillOutline& outline, double feed) {
    const double rest = outline.smaller_half() - kInnermost * radius_;
    const double widest = std::min(step(), kUsualStep * 2.0 * radius_);
    const int count = rest > kNone_mm ? counted(steps(rest, widest)) : 0;
    for (int n = count; n >= 0; --n) {
      const MillOutline ring = n > 0 ? outline.inside(rest * n / count) : outline;
      tool_.cut(ring.start(), feed);
      cut_around(ring, turn_, feed, tool_);
    }
    tool_.cut({0.0, 0.0}, feed);
  }

  // Once around; `room` is how far the path's start is from its middle.
  template <typename Path>
  void finish_side(const Path& path, double room) {
    const double radius = std::min(kApproach_mm, room);
    const double y = turn_ == Turn::counterclockwise ? radius : -radius;
    const PlanePoint center = {path.start().p - radius, 0.0};
    tool_.cut({center.p, -y}, finish_feed_);
    tool_.arc(path.start(), center, turn_, finish_feed_);
    cut_around(path, turn_, finish_feed_, tool_);
    tool_.arc({center.p, y}, center, turn_, finish_feed_);
  }

  // --- slots on a circle

  [[nodiscard]] BentSlot bent_slot(double allowance) const {
    const double off = std::max(0.0, cycle_.width / 2.0 - radius_ - allowance);
    return {cycle_.bend_radius, cycle_.bend_deg, off};
  }

  void mill_bent_slot() {
    const BentSlot rough = bent_slot(cycle_.allowance_side);
    const BentSlot wall = bent_slot(0.0);
    tool_.rapid(wall.middle());
    tool_.rapid_level(in_front());
    if (cycle_.roughs)
      at_each_depth(0.0, cycle_.infeed, [&](double level) {
        tool_.cut_level(level, feed_in_);
        cut_along(rough, feed_, tool_);
        const int count = counted(rough.off > kNone_mm ? steps(rough.off, step()) : 0.0);
        for (int n = 1; n <= count; ++n) {
          const BentSlot ring = {rough.radius, rough.angle_deg, rough.off * n / count};
          tool_.cut(ring.start(), feed_);
          cut_around(ring, turn_, feed_, tool_);
        }
        tool_.cut(rough.middle(), feed_);
      });
    if (!cycle_.finishes_side) return;
    if (cycle_.roughs) tool_.rapid_level(in_front());
    at_each_depth(0.0, cycle_.finish_infeed, [&](double level) {
      tool_.cut_level(level, feed_in_);
      if (wall.off <= kNone_mm) return cut_along(wall, finish_feed_, tool_);
      finish_side(wall, wall.off);
      tool_.cut(wall.middle(), finish_feed_);
    });
  }

  // --- spigots

  [[nodiscard]] MillOutline spigot(double allowance) const {
    const double by = radius_ + allowance;
    return {cycle_.length / 2.0 + by, cycle_.width / 2.0 + by, cycle_.corner_radius + by};
  }

  void mill_spigot() {
    const double wide = std::max(cycle_.length + 2.0 * cycle_.allowance_side, cycle_.blank_length);
    const double start = wide / 2.0 + radius_ + std::max(cycle_.clearance, radius_);
    tool_.rapid({start, 0.0});
    tool_.rapid_level(in_front());
    const auto around = [&](double allowance, double feed) {
      return [this, start, allowance, feed](double level) {
        tool_.cut_level(level, feed_in_);
        go_around(spigot(allowance), start, feed);
      };
    };
    if (cycle_.roughs) at_each_depth(cycle_.allowance_base, cycle_.infeed, around(cycle_.allowance_side, feed_));
    if (cycle_.roughs && (cycle_.finishes_side || cycle_.finishes_base)) tool_.rapid_level(in_front());
    if (cycle_.finishes_side)
      at_each_depth(cycle_.finishes_base ? cycle_.allowance_base : 0.0, cycle_.finish_infeed,
                    around(0.0, finish_feed_));
    if (cycle_.finishes_base) around(0.0, finish_feed_)(cycle_.depth);
  }

  void go_around(const MillOutline& outline, double start, double feed) {
    const PlanePoint center = {(outline.half_length + start) / 2.0, 0.0};
    const Turn onto = turn_ == Turn::counterclockwise ? Turn::clockwise : Turn::counterclockwise;
    tool_.arc(outline.start(), center, onto, feed);
    cut_around(outline, turn_, feed, tool_);
    tool_.arc({start, 0.0}, center, onto, feed);
  }

  // --- long holes

  void mill_long_hole() {
    const double half = cycle_.length / 2.0 - radius_;
    double end = tool_.is_known() && tool_.from_program().p > 0.0 ? half : -half;
    tool_.rapid({end, 0.0});
    tool_.rapid_level(in_front());
    at_each_depth(0.0, cycle_.infeed, [&](double level) {
      tool_.cut_level(level, feed_in_);
      end = -end;
      tool_.cut({end, 0.0}, feed_);
    });
  }

  // --- faces

  void mill_face() {
    if (cycle_.roughs) at_each_depth(cycle_.allowance_base, cycle_.infeed, [&](double level) { face(level, feed_); });
    if (cycle_.finishes_base) face(cycle_.depth, finish_feed_);
  }

  // The first cut reaches a step into the face, the last one ends with its edge, or beyond it. Where cuts go to and
  // fro, one begins where the last one ended.
  void face(double level, double feed) {
    const bool along_first = cycle_.cuts == ir::FaceCuts::first || cycle_.cuts == ir::FaceCuts::first_to_and_fro;
    const bool goes_back =
        cycle_.cuts == ir::FaceCuts::first_to_and_fro || cycle_.cuts == ir::FaceCuts::second_to_and_fro;
    const double edge = (along_first ? cycle_.length : cycle_.width) / 2.0 + radius_;
    const double width = along_first ? cycle_.width : cycle_.length;
    const double across = width + cycle_.beyond_side;
    const auto point = [&](double lengthwise, double at) {
      return along_first ? PlanePoint{lengthwise, at} : PlanePoint{at, lengthwise};
    };
    const int count = counted(steps(across, step()));
    double begin = -(edge + cycle_.clearance);
    double end = edge + cycle_.beyond_end;
    for (int n = 1; n <= count; ++n) {
      const double at = (n < count ? step() * n : across) - radius_ - width / 2.0;
      if (n == 1 || !goes_back) {
        tool_.rapid(point(begin, at));
        tool_.rapid_level(level);
      } else {
        tool_.cut(point(begin, at), feed);
      }
      tool_.cut(point(end, at), feed);
      if (goes_back)
        begin = std::exchange(end, -end);
      else
        tool_.rapid_level(in_front());
    }
    tool_.rapid_level(in_front());
  }

  const ir::MillCycle& cycle_;
  const BlockRules& rules_;
  ModalState& state_;
  const BlockResult& result_;
  double radius_;
  double feed_;
  double feed_in_;
  double finish_feed_;
  double side_;  // in which levels rise from the base
  Turn turn_ = Turn::counterclockwise;
  MillTool tool_;
};

}  // namespace

MillOutcome mill(const ir::MillCycle& cycle, double radius_mm, const BlockRules& rules, ModalState& state,
                 MotionBuffer& out, BlockResult& result) {
  return Miller(cycle, radius_mm, rules, state, out, result).run();
}

}  // namespace dripfeed::interpreter
