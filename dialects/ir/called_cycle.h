// Cycles of the control that programs call by name, with values in brackets: what each one does, and what each of its
// values is. Names and order of the values are the dialect's table; everybody else asks by meaning.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "dialects/ir/cycle.h"
#include "dialects/ir/mill_cycle.h"
#include "dialects/ir/program.h"

namespace dripfeed::ir {

enum class CalledSort : std::uint8_t {
  hole,             // CalledCycle::hole is what it does
  holes_in_row,     // positions where the hole in effect is made
  holes_on_circle,  // the same
  holes_anywhere,   // the same
  removal,          // turns a contour from the solid; it runs the contour's blocks
  thread,           // the passes of a turned thread
  milling,          // CalledCycle::read_milling makes of its values what it mills
};

// Levels are coordinates along the axis of the hole unless they are called distances; times in seconds (below 0: in
// turns of the spindle).
enum class CycleValue : std::uint8_t {
  other,
  return_level,
  surface,
  clearance,  // distance in front of the surface
  depth,
  depth_below_surface,  // distance, where there is no `depth`
  dwell,
  first_peck_level,
  first_peck,       // distance below the surface, where there is no `first_peck_level`
  less_each_peck,   // distance that each peck is shorter by
  first_dwell,      // where it begins, and after each peck
  first_peck_feed,  // factor of the feed
  removes_chips,    // each peck goes out of the hole, and not just back a little
  axis,             // its number in the plane; 0 and 3: the one that stands on the plane
  least_peck,
  peck_retract,    // distance back between pecks that break chips
  last_dwell,      // at the bottom
  peck_clearance,  // distance in front of the last peck where the feed begins
  spindle,         // 3, 4 or 5, as its M code: in a boring cycle
  spindle_back,    // on the retract of a tap
  spindle_after,   // after the cycle
  thread_size,     // of a metric thread, instead of its lead
  lead,
  spindle_angle,
  speed,
  speed_back,
  encoder,  // how a tap in a compensating chuck uses it
  feed_in,
  feed_out,
  shift_first,  // off the wall before the tool is drawn out
  shift_second,
  lift,
  pattern_first,  // first point, or centre
  pattern_second,
  pattern_angle,
  pattern_start,  // distance from the first point to the first hole
  pattern_step,   // distance or angle between holes
  pattern_radius,
  pattern_count,
  screen_geometry,  // modes of the operator's screen, a digit each
  screen_plane,
  screen_kinds,
  contour,  // name of a program, or of two labels
};

struct CalledCycle {
  std::string_view name;  // as programs call it
  CalledSort sort = CalledSort::hole;
  DrillCycle hole = DrillCycle::drill;  // a tap is right-handed, and breaks chips only where a value says so
  bool floats = false;                  // a tap in a compensating chuck
  std::vector<CycleValue> values = {};  // in the order of the arguments
  ReadMillCycle read_milling = nullptr;
};

inline constexpr std::size_t kNoPlace = SIZE_MAX;
// Where the value stands among the arguments; kNoPlace where the cycle has none of that meaning.
std::size_t place_of(const CalledCycle& cycle, CycleValue value);
// The call's value; none where it is left out, or where the cycle has none. `call.cycle` must not be null.
ExpressionId value_of(const Program& program, const Call& call, CycleValue value);
// … where it is a number, with or without sign.
std::optional<double> number_of(const Program& program, const Call& call, CycleValue value);
// What comes after that value.
std::span<const Argument> arguments_after(const Program& program, const Call& call, CycleValue value);

// Whether the call runs blocks of a contour, which one of its values names.
inline bool runs_contour(const Call& call) {
  return call.cycle != nullptr && place_of(*call.cycle, CycleValue::contour) != kNoPlace;
}
// Whether the call is one of a cycle of that sort.
inline bool is_called(const Call& call, CalledSort sort) { return call.cycle != nullptr && call.cycle->sort == sort; }

}  // namespace dripfeed::ir
