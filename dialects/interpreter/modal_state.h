// What a control remembers from block to block. A plain value: a copy is a snapshot from which a run can go on.
#pragma once

#include <array>
#include <cstdint>

#include "dialects/interpreter/frame.h"
#include "dialects/interpreter/plain_block.h"
#include "dialects/ir/function.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/semantics.h"

namespace dripfeed::interpreter {

// Lengths by axis in mm or degrees; a diameter axis as diameter.
using AxisValues = std::array<double, ir::kAxisCount>;
constexpr std::size_t index_of(ir::Axis axis) { return static_cast<std::size_t>(axis); }
inline constexpr std::uint16_t kAllAxes = (1U << ir::kAxisCount) - 1U;

inline constexpr std::int32_t kOffsetUnknown = -1;

// The modal codes and the programmable shift: what a subprogram with SAVE gives back when it returns.
struct Modes {
  ir::Function motion = ir::Function::rapid;  // rapid, linear, arc_cw, arc_ccw, thread
  bool motion_given = false;                  // by a code, or known from power-on
  bool motion_modelled = true;                // false: a cycle or curve is active that is not interpreted
  ir::Plane plane = ir::Plane::xy;
  ir::FeedMode feed_mode = ir::FeedMode::per_min;
  ir::DiameterMode diameter = ir::DiameterMode::radius;
  ir::CompSide comp = ir::CompSide::off;
  bool inch = false;
  bool inch_feed = false;  // feeds are in inch, too
  bool absolute = true;
  bool exact_stop = false;
  bool surface_speed = false;  // G96
  std::int32_t work_offset = kOffsetUnknown;
  AxisValues shift{};         // local: G52, TRANS
  Matrix matrix = kIdentity;  // ROT, SCALE, MIRROR
  bool has_matrix = false;    // it is not the identity
};

struct Tool {
  std::int32_t number = 0;
  std::int32_t offset = 0;
  std::uint32_t name = kNoText;
  friend bool operator==(const Tool&, const Tool&) = default;
};

struct Spindle {
  ir::SpindleState state = ir::SpindleState::stopped;
  double rpm = 0.0;
  double surface_speed_m_min = 0.0;  // 0: constant rpm
  double limit_rpm = 0.0;            // counts with surface speed only
  friend bool operator==(const Spindle&, const Spindle&) = default;
};

// What the trace was told last: events are given when what is commanded differs from it.
struct Announced {
  std::int32_t work_offset = kOffsetUnknown;
  Tool tool;
  Spindle spindle;
  ir::CompSide comp = ir::CompSide::off;
  ir::CoolantState coolant = ir::CoolantState::off;
};

// What polar words go by: all of programmed coordinates, radius values.
struct Polar {
  Vector pole{};
  double angle_deg = 0.0;
  double radius_mm = 0.0;
};

// A chamfer or rounding that waits for the move behind the corner.
struct PendingCorner {
  std::uint8_t kind = 0;  // CornerKind
  double size_mm = 0.0;
  std::size_t motion = 0;  // place in the buffer of the move before the corner
};

struct ModalState {
  Modes modes;
  AxisValues position{};             // in the active work offset
  std::uint16_t unknown = kAllAxes;  // bit per axis: `position` is the last that was known, not where it is
  AxisValues coordinate_shift{};     // G92
  double feed = 0.0;                 // as Motion::feed
  bool feed_unknown = false;         // given by a value that is not known, or by a caller that is not run
  double rpm = 0.0;                  // S as written, by what it means
  double surface_speed_m_min = 0.0;
  double spindle_limit_rpm = 0.0;
  ir::SpindleState spindle = ir::SpindleState::stopped;
  ir::CoolantState coolant = ir::CoolantState::off;
  Polar polar;
  Vector tangent{};  // direction at the end of the last move of a contour, radius values
  bool tangent_known = false;
  double modal_rounding_mm = 0.0;  // RNDM
  PendingCorner corner;
  Tool selected;  // T, before M6
  Tool tool;
  Announced announced;
};

}  // namespace dripfeed::interpreter
