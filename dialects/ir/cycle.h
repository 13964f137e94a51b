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

// Of Function::repetitive_cycle, whose argument is the last digit of G70 to G76: those up to G73 follow a shape, which
// is blocks of the program.
inline constexpr std::int16_t kPatternRepeat = 3;
constexpr bool follows_shape(const Code& code) {
  return code.function == Function::repetitive_cycle && code.argument <= kPatternRepeat;
}

}  // namespace dripfeed::ir
