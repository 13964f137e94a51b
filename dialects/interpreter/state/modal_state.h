// What a control remembers from block to block. A plain value: a copy is a snapshot from which a run can go on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dialects/interpreter/state/frame_value.h"
#include "dialects/interpreter/state/plain_block.h"
#include "dialects/interpreter/state/spindles.h"
#include "dialects/ir/cycle.h"
#include "dialects/ir/function.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/semantics.h"

namespace dripfeed::interpreter {

// Lengths by axis in mm or degrees; a diameter axis as diameter.
using AxisValues = std::array<double, ir::kAxisCount>;
constexpr std::size_t index_of(ir::Axis axis) { return static_cast<std::size_t>(axis); }
inline constexpr std::uint16_t kAllAxes = (1U << ir::kAxisCount) - 1U;

inline constexpr std::int32_t kOffsetUnknown = -1;
inline constexpr std::int32_t kExtendedOffset = 100;  // G54.1 P1 is work offset 101

// A mirror, scale or rotation about a point of its own; radius values in the coordinates that it is named in.
struct PointFrame {
  Matrix matrix = kIdentity;
  Vector center{};
  bool active = false;
};

// The modal codes and the programmable shift: what a subprogram with SAVE gives back when it returns.
struct Modes {
  ir::Function motion = ir::Function::rapid;  // rapid, linear, arc_cw, arc_ccw, thread …
  bool motion_given = false;                  // by a code, or known from power-on
  bool motion_modelled = true;                // false: a cycle or curve is active that is not interpreted
  ir::Plane plane = ir::Plane::xy;
  ir::FeedMode feed_mode = ir::FeedMode::per_min;
  ir::DiameterMode diameter = ir::DiameterMode::radius;
  ir::CompSide comp = ir::CompSide::off;
  bool inch = false;
  bool inch_feed = false;     // feeds are in inch, too
  bool unit_of_feed = false;  // the unit was stated by a code that holds for feeds, too: G700, G710
  bool absolute = true;
  bool exact_stop = false;
  bool surface_speed = false;  // G96
  bool return_to_r = false;    // G99: drilling ends at the R level
  std::int32_t work_offset = kOffsetUnknown;
  AxisValues shift{};                        // local: G52, TRANS
  AxisValues fine_shift{};                   // the part of it that ATRANS and G59 made
  Matrix matrix = kIdentity;                 // ROT, SCALE, MIRROR
  bool has_matrix = false;                   // it is not the identity
  AxisValues local_shift{};                  // of `shift`: what G52 says; the rest comes from frames about points
  std::array<PointFrame, 3> point_frames{};  // G51.1, G51, G68: the outer one first
  bool lead_shrinks = false;                 // G35 of SINUMERIK, where a lead changes
  std::int16_t spline = 0;                   // which one, and how it begins and ends: ir/spline_use.h
  std::int16_t spline_begin = 0;
  std::int16_t spline_end = 0;
  bool polar_words = false;          // G16: the plane's two letters are a radius and an angle
  std::uint8_t frame_languages = 0;  // in which the programmable frame was made: 1 the control's own, 2 its other one
  FrameValue settable;               // of the active work offset
  bool settable_known = false;
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

// What the trace was given last: events are given when what is commanded differs from it.
struct Announced {
  std::int32_t work_offset = kOffsetUnknown;
  Tool tool;
  Spindle spindle;
  ir::CompSide comp = ir::CompSide::off;
  ir::CoolantState coolant = ir::CoolantState::off;
  bool every_order = false;  // also where nothing differs: RunOptions::every_order
};

// The drilling cycle in effect and the words that it keeps from block to block. Levels are as ModalState::position, of
// the drilling axis.
struct Drilling {
  bool active = false;
  bool entered = false;  // the initial level is taken
  std::uint8_t axis = 0;
  ir::DrillCycle cycle = ir::DrillCycle::drill;
  std::int16_t along = 0;  // kDrillAlongZ, kDrillAlongX; 0: the plane's normal
  double initial = 0.0;    // level where the cycle began
  bool initial_known = false;
  double r = 0.0;  // as programmed, in mm
  bool has_r = false;
  bool r_by_distance = false;  // … from the initial level
  double depth = 0.0;
  bool has_depth = false;
  bool depth_by_distance = false;  // … from the R level
  double peck_mm = 0.0;            // Q
  double dwell_s = 0.0;            // P
  bool by_lead = false;            // a synchronous tap (,R1): F is the lead
  double shift_p_mm = 0.0;         // I, J of the plane's first and second axis, or Q along the first
  double shift_q_mm = 0.0;
};

// The single turning cycle in effect and its words.
using ir::TurningCycle;
struct Turning {
  bool active = false;
  TurningCycle cycle = TurningCycle::along_z;
  bool has_x = false;
  bool has_z = false;
  double x = 0.0;  // as ModalState::position
  double z = 0.0;
  double taper = 0.0;  // R as programmed, mm: start minus end, radius in X
};

// What multiple repetitive cycles keep: the words of the first of two blocks, and the cycle that was called last.
// Lengths in mm, X as radius.
struct Repetitive {
  std::uint8_t cycle = 0;  // RepetitiveCycle
  std::uint32_t first_block = 0;
  std::uint32_t last_block = 0;
  double allowance_x_mm = 0.0;
  double allowance_z_mm = 0.0;
  double depth_mm = 0.0;
  double retract_mm = 0.0;
  double relief_x_mm = 0.0;  // G73
  double relief_z_mm = 0.0;
  std::int32_t passes = 1;
  double peck_retract_mm = 0.0;
  std::int32_t finishes = 1;  // G76
  double angle_deg = 60.0;
  double run_out_leads = 0.0;  // the end of a thread, where the tool leaves at 45 degrees
  double least_cut_mm = 0.0;
  double allowance_mm = 0.0;
  double first_cut_mm = 0.0;
};

// What polar words go by: all of programmed coordinates, radius values.
struct Polar {
  Vector pole{};
  double angle_deg = 0.0;
  double radius_mm = 0.0;
};

// A chamfer or rounding that waits for the move after the corner.
struct PendingCorner {
  std::uint8_t kind = 0;  // CornerKind
  double size_mm = 0.0;
  std::size_t motion = 0;  // place in the buffer of the move before the corner
};

// Direct drawing input: a line of which only the angle is known, until the block after it says where it ends.
struct PendingLine {
  bool active = false;
  double angle_deg = 0.0;
  std::uint16_t unknown_before = 0;  // ModalState::unknown without what the line made unknown
  std::uint64_t corner = 0;          // bit of the address of its chamfer or rounding
  double corner_value = 0.0;
};

// Polar and cylindrical interpolation: two coordinates that a linear and a rotary axis make together.
struct Transformation {
  enum class Shape : std::uint8_t { none, face, cylinder };
  Shape shape = Shape::none;
  bool by_rotary = false;   // the letter across is the rotary axis's own; otherwise Y
  std::uint8_t rotary = 5;  // index of the axis that turns
  double radius_mm = 0.0;   // of the cylinder
  double along_mm = 0.0;    // face: the coordinate of X, a radius value
  double across_mm = 0.0;   // face: the one that stands on it; cylinder: on its circumference
  bool along_known = false;
  bool across_known = false;
  bool rotary_known = false;  // where the rotary axis stands in its own degrees
  double zero_deg = 0.0;      // face: the rotary axis where `along` points away from the centre
};

// G06.2: what was stated of a curve that is not complete.
struct CurveInput {
  bool open = false;
  std::size_t order = 4;
  std::vector<AxisValues> points;  // as ModalState::position
  std::vector<double> weights;
  std::vector<double> knots;
  std::vector<std::uint32_t> lines;  // of the points
  std::uint16_t commanded = 0;       // bit per axis
};

// A spline that has not ended: its points, each with the straight move that stands for it in the buffer until the curve
// is known. The first point is where the tool was; no move stands for it.
struct SplinePoint {
  AxisValues at{};  // as ModalState::position
  double weight = 1.0;
  double distance = -1.0;  // PL; below 0: not given
  std::size_t motion = 0;  // place in the buffer
};
struct SplineRun {
  bool active = false;
  bool is_first = true;  // it begins with the first point that is kept; earlier ones are not needed any more
  std::int16_t kind = 0;
  std::int16_t begin = 0;
  std::size_t degree = 3;
  std::size_t done = 0;  // segments that are made of the points that are kept
  std::vector<SplinePoint> points;
  Vector tangent{};  // of the move before it, radius values
  bool tangent_known = false;
};

// A corner on a face or cylinder that waits for the move after it.
struct PlaneCorner {
  std::uint8_t kind = 0;  // CornerKind
  double size_mm = 0.0;
  ir::Motion before;       // the move before it, in that plane
  std::size_t motion = 0;  // where its pieces stand in the buffer
  std::size_t pieces = 0;
  AxisValues real{};  // where the machine's axes stood before it
  std::uint16_t unknown = 0;
};

struct ModalState {
  Modes modes;

  Drilling drilling;
  Turning turning;
  Repetitive repetitive;
  std::uint32_t stated = 0;          // bit per ir::ModalGroup: the program stated a code of it
  bool tool_stated = false;          // … a tool
  AxisValues position{};             // in the active work offset
  std::uint16_t unknown = kAllAxes;  // bit per axis: `position` is the last that was known, not where it is
  // Bit per axis: a frame has changed since it was programmed absolutely, and setting data decides whether an increment
  // takes the change along.
  std::uint16_t shifted = 0;
  AxisValues coordinate_shift{};  // G92
  AxisValues touch{};             // where a probe touches, as `position`
  std::uint16_t touch_known = 0;  // bit per axis
  AxisValues skipped{};           // where the last skip move ended
  std::uint16_t skipped_known = 0;
  double clock_ms = 0.0;      // of what was executed: blocks by the control's cost, and dwells
  std::uint64_t untimed = 0;  // blocks whose time is not among it: they move, or the machine carries them out
  double comp_number = 0.0;
  double length_number = 0.0;  // D, H
  ir::LengthOffset length_offset = ir::LengthOffset::off;
  std::uint16_t length_offset_number = 0;  // as Motion::length_offset_number
  std::uint8_t gaps = 0;                   // those of ir::Motion::gaps that stay
  double feed = 0.0;                       // as Motion::feed
  bool feed_unknown = false;               // given by a value that is not known, or by a caller that is not run
  double rpm = 0.0;                        // S as written, by what it means; 0: none given, or not known
  double surface_speed_m_min = 0.0;        // … 0: the same
  bool speed_unknown = false;              // of `rpm`: by a value, or kept from a surface speed at a place, not known
  bool surface_by_x = false;               // G96 goes by the diameter in X
  double spindle_limit_rpm = 0.0;
  ir::SpindleState spindle = ir::SpindleState::stopped;
  Spindles spindles;
  ir::CoolantState coolant = ir::CoolantState::off;
  Polar polar;
  AxisValues intermediate{};             // of the last G28, as `position`
  std::uint16_t intermediate_known = 0;  // bit per axis
  Vector tangent{};                      // direction at the end of the last move of a contour, radius values
  bool tangent_known = false;
  double modal_rounding_mm = 0.0;  // RNDM
  bool offsets_contour = false;    // OFFN is not 0, or not known
  PendingCorner corner;
  PendingLine line;
  Tool selected;  // T, before M6
  Tool tool;
  Announced announced;
  Transformation transformation;
  CurveInput curve;
  SplineRun spline;
  PlaneCorner plane_corner;

  [[nodiscard]] bool has_stated(ir::ModalGroup group) const {
    return (stated >> static_cast<unsigned>(group) & 1U) != 0;
  }
};

// Whether what is in effect of that group may be from before the program: it states no code of the group, and the
// machine's state at power-on is not known either.
inline bool may_be_older(const ir::Semantics& semantics, const ModalState& state, ir::ModalGroup group) {
  return semantics.unset_is_unknown && !semantics.power_on_known && !state.has_stated(group);
}

}  // namespace dripfeed::interpreter
