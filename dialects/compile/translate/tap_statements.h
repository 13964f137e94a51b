// Which statements of a lathe's program tap a thread, where the other control says it otherwise: G84 and G88 of the
// numbered controls; CYCLE84, CYCLE840, G331 with G332 and G63 twice of SINUMERIK.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

enum class TapRole : std::uint8_t {
  none,
  tap,
  part,     // belongs to a tap: the retract, M29, MCALL; what else its block says stays
  orients,  // SPOS=0 before G331: the spindle stands
};

struct TapStatement {
  TapRole role = TapRole::none;
  bool rigid = false;                  // the spindle is turned by its position
  bool own_speed = false;              // by a call: whether its speed is that of what follows, the manual does not say
  bool needs_stop = false;             // G331: the spindle was brought to a stop
  std::uint32_t owner = ir::kNoIndex;  // of the retract: the statement of the approach
  std::string fault = {};              // why it cannot be written
};

// For each statement, in the order of the text.
std::vector<TapStatement> tap_statements(const ir::Program& program, const ir::Control& from, const ir::Control& to);

}  // namespace dripfeed::compile
