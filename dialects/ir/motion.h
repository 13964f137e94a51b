// What the interpreter emits, for every check and for the trace: motions and the events between them, control-neutral.
// Lengths in mm, angles in degrees, positions in the active work offset without tool compensation; diameter axes as
// diameters in `end`, radius in `center`.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "dialects/ir/cost_model.h"
#include "dialects/ir/semantics.h"

namespace dripfeed::ir {

// Where something happens: program (0 is the main one), 1-based line, and how many blocks were executed before.
struct Place {
  std::uint32_t program = 0;
  std::uint32_t line = 0;
  std::uint64_t ordinal = 0;
};

enum class MotionKind : std::uint8_t {
  rapid,
  linear,
  arc_cw,
  arc_ccw,
  spline,
  thread,  // moves
  dwell,
  offset,
  tool,
  comp,
  spindle,
  coolant,
  message,
  stop,
  end,  // events
};
constexpr bool is_move(MotionKind kind) { return kind <= MotionKind::thread; }

// Index of an axis in Motion::end, in the order of the trace.
enum class Axis : std::uint8_t { x, y, z, a, b, c, u, v, w };
inline constexpr std::size_t kAxisCount = 9;

enum class SpindleState : std::uint8_t { stopped, clockwise, counterclockwise };
enum class CompSide : std::uint8_t { off, left, right };
// Of the tool's length: added to the position of the programmed tip (G43, T0606, D1) or subtracted from it (G44).
enum class LengthOffset : std::uint8_t { off, plus, minus };
// Bits of Motion::gaps, what is not known of a motion. The first three stay once the program has changed the control's
// memory: what a machine's profile says of it counts no longer.
inline constexpr std::uint8_t kZerosChanged = 1;    // work offsets (G10 L2), or coordinates at an unknown place (G92)
inline constexpr std::uint8_t kLengthsChanged = 2;  // tool offsets
inline constexpr std::uint8_t kRadiiChanged = 8;    // radii that compensation takes: stays, too
inline constexpr std::uint8_t kEndUnknown = 4;      // of the axes in axes_unknown `end` is a guess, too: an increment
// Coordinates lie where the machine's kinematics and the control put them: a swivelled plane, a transformation. Stays.
inline constexpr std::uint8_t kFrameLost = 16;
enum class CoolantState : std::uint8_t { off, mist, flood };
// Bits of Motion::axes_commanded of an event, in a run that reports every order: what of it the block orders, also
// where nothing of the modelled state changes by it. The machine's own program (PLC) hears each of them.
inline constexpr std::uint16_t kOrdersTool = 1;         // T, where it brings a tool in
inline constexpr std::uint16_t kOrdersChange = 2;       // M6
inline constexpr std::uint16_t kOrdersSpindle = 4;      // M3, M4, M5
inline constexpr std::uint16_t kOrdersOrientation = 8;  // M19
inline constexpr std::uint16_t kOrdersSpeed = 16;       // S
inline constexpr std::uint16_t kOrdersLimit = 32;       // G50 S, LIMS
inline constexpr std::uint16_t kOrdersMist = 64;        // M7
inline constexpr std::uint16_t kOrdersFlood = 128;      // M8, M9: both off
inline constexpr std::uint16_t kOrdersEdge = 256;       // D, where it selects the tool's edge

struct Motion {
  Place place;
  MotionKind kind = MotionKind::rapid;
  Plane plane = Plane::xy;
  FeedMode feed_mode = FeedMode::per_min;
  LengthOffset length_offset = LengthOffset::off;  // in effect
  std::uint16_t axes_commanded = 0;                // bit per Axis: named in the block; events: kOrders…
  bool machine_coordinates = false;                // G53: `end` is in machine coordinates
  bool exact_stop = false;
  std::array<double, kAxisCount> start{};  // moves: where it begins, same frame as `end`
  std::array<double, kAxisCount> end{};
  // Arcs: centre minus start, I J K, radius values, mm. Threads: [0] is what the lead grows by in each turn, mm.
  std::array<double, 3> center{};
  double feed = 0.0;                 // mm/min, mm/rev or 1/min; 0 on rapids. Dwell: seconds
  double spindle_rpm = 0.0;          // in effect; with surface speed: the limit (0: none)
  double surface_speed_m_min = 0.0;  // G96 in effect; 0: constant rpm
  SpindleState spindle = SpindleState::stopped;
  CompSide comp = CompSide::off;
  CoolantState coolant = CoolantState::off;
  std::uint8_t gaps = 0;
  std::int32_t number = 0;           // offset: 0 none, 1 G54 …; tool: its number; stop: 0 program, 1 optional
  std::int32_t tool_offset = 0;      // tool: D or offset number; with `comp`: the D in effect
  std::uint32_t text = 0xFFFFFFFFU;  // message, tool by name: index into the run's strings
  ComputeCounts compute;             // work since the motion before
  // Bit per Axis: where the move starts is not known (never commanded, after a reference return, a move in machine
  // coordinates or another work offset); `start` then holds the last value that was.
  std::uint16_t axes_unknown = 0;
  std::uint16_t length_offset_number = 0;  // H, of T0606 the offset, D; 0 on controls of D: the tool's usual edge
};

class MotionSink {
 public:
  MotionSink() = default;
  MotionSink(const MotionSink&) = delete;
  MotionSink& operator=(const MotionSink&) = delete;
  virtual ~MotionSink() = default;
  // Batches of up to kMotionBatch motions, in order. The span is valid during the call only.
  virtual void consume(std::span<const Motion> motions) = 0;
};
inline constexpr std::size_t kMotionBatch = 1024;

}  // namespace dripfeed::ir
