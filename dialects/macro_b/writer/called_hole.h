// What a called drilling cycle makes, as far as these controls can say it.
#pragma once

#include <expected>
#include <optional>
#include <string>

#include "dialects/ir/cycle.h"
#include "dialects/ir/program.h"

namespace dripfeed::macro_b {

// Lengths in units of the program.
struct Hole {
  std::string name;
  ir::DrillCycle cycle = ir::DrillCycle::drill;
  ir::ExpressionId back = ir::ExpressionId::none;   // RTP
  ir::ExpressionId level = ir::ExpressionId::none;  // RFP and SDIS
  ir::ExpressionId depth = ir::ExpressionId::none;
  double dwell_s = 0.0;
  bool pecks_below_level = false;  // the first peck is counted from below `level`
  double peck = 0.0;
  bool breaks_chips = false;
  double feed_in = 0.0;  // CYCLE85; 0: the one in effect
  double feed_out = 0.0;
  int spindle = 0;           // CYCLE86 to CYCLE88: 3 or 4, as its M function; stopped at the bottom
  bool orients = false;      // … to an angle
  double shift_first = 0.0;  // … and moved aside, away from the wall, before it is drawn out
  double shift_second = 0.0;
  double lift = 0.0;
  bool holds = false;     // … and the program waits
  bool floats = false;    // a tap in a compensating chuck; without a lead at the feed in effect
  int reversed = 0;       // … 3 or 4: how the spindle turns on the retract, 0: the other direction
  double lead = 0.0;      // of a tap, per turn
  double speed = 0.0;     // … in turns a minute
  int after = 0;          // … 3, 4 or 5: what the spindle does after it
  bool constant = false;  // all levels are numbers
};

// Also of those that have no counterpart.
bool is_drilling_cycle(const ir::Call& call);
// Adds constants to `program`. The error names what of the call cannot be written.
std::expected<Hole, std::string> called_hole(ir::Program& program, const ir::Call& call);
// A number with or without sign; nothing for what is computed or left out.
std::optional<double> constant_value(const ir::Program& program, ir::ExpressionId id);

}  // namespace dripfeed::macro_b
