// checks/machine.h: what the checks need to know of one machine: axes, limits, tools, work offsets, buffer, timing.
// Plain data. What is 0 or empty (a length: not given) is not known: a check that needs it says "not checked" and
// guesses nothing. The control and the line are elsewhere; reading it from a profile is left to others.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/cost_model.h"
#include "dialects/ir/motion.h"

namespace dripfeed::checks {

// Lengths in mm for X Y Z U V W, in degrees for A B C; travel in machine coordinates, never as a diameter.
struct MachineAxis {
  ir::Axis axis = ir::Axis::x;
  bool is_diameter = false;  // programs and work offsets give diameters; `min` and `max` are of the slide itself
  std::optional<double> min = {};
  std::optional<double> max = {};
  double rapid_mm_min = 0.0;
  double feed_limit_mm_min = 0.0;  // of this axis alone; 0: its rapid
  double acceleration_mm_s2 = 0.0;
  double jerk_mm_s3 = 0.0;                      // 0: not limited
  std::optional<double> reference = {};         // where G28 takes it
  std::optional<double> second_reference = {};  // … G30, and G30 P2
};

// The shank and holder of a mill above its edges: from a height above the tip on it is this wide, up to the next step
// or the spindle.
struct HolderStep {
  double from_mm = 0.0;
  double diameter_mm = 0.0;
};

// The insert of a turning tool around its nose (ISO 3002): for pictures; no check counts it.
struct Insert {
  double angle_deg = 0.0;           // between its two edges at the nose
  double entering_angle_deg = 0.0;  // of the leading edge against the direction of feed, as tip 1 to 4 has it
  double edge_mm = 0.0;             // length of an edge
};

// Where the imaginary tip, which the program moves, lies as seen from the centre of the nose, with +X up and +Z right;
// numbered as Fanuc and SINUMERIK do. 3 is the usual tool for outside turning towards the chuck.
//
//      +X       2   6   1
//       |       7  0,9  5      1..4: a corner of the square around the nose; 5..8: the middle of a side
//       +-- +Z  3   8   4      0, 9: the centre itself
struct Tool {
  std::int32_t number = 0;
  std::string name = {};    // by which programs call it: T="MILL_D10"; empty: by number alone
  std::int32_t offset = 0;  // the offset or D number that holds its figures
  double nose_radius_mm = 0.0;
  std::int32_t tip = 0;                  // 0..9
  double diameter_mm = 0.0;              // mills and drills
  std::optional<double> length_mm = {};  // mills: from the spindle's gauge line to the tip, along the spindle
  double corner_radius_mm = 0.0;         // mills: 0 flat, half the diameter a ball, between both a bull nose
  // Lathes: how far the slide's position lies beyond that of the tip, as radius in X.
  std::optional<double> length_x_mm = {};
  std::optional<double> length_z_mm = {};
  std::optional<Insert> insert = {};
  std::vector<HolderStep> holder = {};  // mills, from below; empty: not known
};

// Where a work offset puts its zero, in machine coordinates: slide positions, halved already where programs give
// diameters. An axis without a value is not known.
struct WorkOffset {
  std::int32_t number = 0;  // 1 is G54; 0 is none (G500)
  std::array<std::optional<double>, ir::kAxisCount> zero{};
};

// Of the control, for programs that are fed. 0: not known.
struct BufferSize {
  std::uint32_t bytes = 0;
  std::uint32_t blocks = 0;
};

struct TimingData {
  double sample_time_ms = 0.0;          // of the interpolator; 0: not known
  std::uint32_t look_ahead_blocks = 0;  // 0: not limited
  double tool_change_s = 0.0;
  double contour_tolerance_mm = 0.0;  // the control rounds corners within it (G64 with a tolerance, CYCLE832); 0: not
  std::optional<ir::CostModel> cost;  // of this machine; otherwise the control's usual one counts
  std::string cost_origin;            // of `cost`, whose own is not used
};

struct Machine {
  ir::MachineKind kind = ir::MachineKind::mill;
  std::vector<MachineAxis> axes;
  double feed_limit_mm_min = 0.0;
  double spindle_min_rpm = 0.0;
  double spindle_max_rpm = 0.0;
  std::vector<Tool> tools;
  std::vector<WorkOffset> work_offsets;
  // Where the work zero lies for offsets and axes that `work_offsets` says nothing of; as WorkOffset::zero.
  std::array<std::optional<double>, ir::kAxisCount> origin{};
  BufferSize buffer;
  TimingData timing;
};

// nullptr when the machine has none such.
inline const MachineAxis* find_axis(const Machine& machine, ir::Axis axis) {
  for (const MachineAxis& one : machine.axes) {
    if (one.axis == axis) return &one;
  }
  return nullptr;
}
inline const Tool* find_tool(const Machine& machine, std::int32_t number) {
  for (const Tool& one : machine.tools) {
    if (one.number == number) return &one;
  }
  return nullptr;
}
// "tool 5", of the event that takes it.
inline std::string called(const ir::Motion& tool) {
  return tool.number == 0 ? std::string("a tool that is called by a name") : "tool " + std::to_string(tool.number);
}
inline const WorkOffset* find_work_offset(const Machine& machine, std::int32_t number) {
  for (const WorkOffset& one : machine.work_offsets) {
    if (one.number == number) return &one;
  }
  return nullptr;
}

// Whether a move's figures can be positions of a machine: a calculation that ran away gives infinities, and
// differences of those are no numbers at all. mm, degrees.
inline constexpr double kFarthest = 1e9;
inline bool has_places(const ir::Motion& motion) {
  bool all = std::fabs(motion.feed) <= kFarthest;
  for (std::size_t i = 0; i < ir::kAxisCount; ++i)
    all = all && std::fabs(motion.end[i]) <= kFarthest && std::fabs(motion.start[i]) <= kFarthest;
  for (const double one : motion.center) all = all && std::fabs(one) <= kFarthest;
  return all;
}

// Whether a move leads along one of these axes, or starts on one at a place that is not known.
inline bool moves_any(const ir::Motion& motion, std::initializer_list<ir::Axis> axes) {
  return std::ranges::any_of(axes, [&](ir::Axis axis) {
    const auto i = static_cast<std::size_t>(axis);
    return motion.end[i] != motion.start[i] || ((motion.axes_commanded & motion.axes_unknown) >> i & 1U) != 0;
  });
}

// Whether a rotary axis turns in the move, or stands turned from where the part was set up.
inline bool is_turned(const ir::Motion& motion) {
  if (moves_any(motion, {ir::Axis::a, ir::Axis::b, ir::Axis::c})) return true;
  for (std::size_t i = static_cast<std::size_t>(ir::Axis::a); i <= static_cast<std::size_t>(ir::Axis::c); ++i)
    if (motion.end[i] != 0.0 && (motion.axes_unknown >> i & 1U) == 0) return true;
  return false;
}

// Whether a lathe's move lies next to the spindle's axis, or leads there.
inline bool is_off_axis(const ir::Motion& motion) {
  const auto y = static_cast<std::size_t>(ir::Axis::y);
  return moves_any(motion, {ir::Axis::y}) || motion.end[y] != 0.0;
}

// What makes a cut no turning in the z-x plane through the spindle's axis; "" for one that is.
inline std::string_view why_no_turning(const ir::Motion& motion) {
  if ((motion.gaps & ir::kFrameLost) != 0) return "a cut in a swivelled plane or under a transformation";
  if (moves_any(motion, {ir::Axis::c})) return "a cut that turns C";
  if (moves_any(motion, {ir::Axis::a, ir::Axis::b})) return "a cut that turns A or B";
  if (is_off_axis(motion)) return "a cut off the spindle's axis, with Y";
  return {};
}

}  // namespace dripfeed::checks
