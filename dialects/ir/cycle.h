// Drilling cycles by what they do, for every control that has modal ones (G73-G89) or calls that do the same. Which
// number a control gives them is its code table's; the motions are the interpreter's.
#pragma once

#include <cstdint>

#include "dialects/ir/statement.h"

namespace dripfeed::ir {

// Argument of Function::drill.
enum class DrillCycle : std::int16_t {
  drill,           // G81: in by feed, out by rapid
  drill_dwell,     // G82: dwell at the bottom
  deep_hole,       // G83: pecks, each out to the R level
  chip_break,      // G73: pecks, each back by a little
  tap_right,       // G84: out by feed with the spindle reversed
  tap_left,        // G74
  feed_out,        // G85: out by feed
  feed_out_dwell,  // G89: dwell, out by feed
  stop_out,        // G86: spindle stopped, out by rapid
  manual_out,      // G88: dwell, spindle stopped, program held
  fine_bore,       // G76: oriented and shifted away from the wall, out by rapid
  back_bore,       // G87: shifted in, bored upward from below
  count_,
};
// Added to the argument where the axis does not depend on the plane: lathes drill from the front (G83 to G85) along Z,
// and from the side (G87 to G89) along X.
inline constexpr std::int16_t kDrillAlongZ = 100;
inline constexpr std::int16_t kDrillAlongX = 200;
constexpr std::int16_t drill_argument(DrillCycle cycle, std::int16_t along = 0) {
  return static_cast<std::int16_t>(static_cast<std::int16_t>(cycle) + along);
}

// Argument of Function::turning_cycle: one pass each block. The codes are those of G-code system A.
enum class TurningCycle : std::int16_t { along_z, thread, along_x, count_ };  // G90, G92, G94

// Argument of Function::repetitive_cycle: many passes by one or two blocks. Those up to `pattern` follow a shape, which
// is blocks of the program.
enum class RepetitiveCycle : std::int16_t {
  finish,         // G70
  rough_along_z,  // G71
  rough_along_x,  // G72
  pattern,        // G73: the shape again and again
  peck_z,         // G74
  peck_x,         // G75
  thread,         // G76
  count_,
};

constexpr std::int16_t argument_of(TurningCycle cycle) { return static_cast<std::int16_t>(cycle); }
constexpr std::int16_t argument_of(RepetitiveCycle cycle) { return static_cast<std::int16_t>(cycle); }

constexpr bool is_cycle(const Code& code, RepetitiveCycle cycle) {
  return code.function == Function::repetitive_cycle && code.argument == argument_of(cycle);
}
constexpr bool follows_shape(const Code& code) {
  return code.function == Function::repetitive_cycle && code.argument <= argument_of(RepetitiveCycle::pattern);
}

}  // namespace dripfeed::ir
