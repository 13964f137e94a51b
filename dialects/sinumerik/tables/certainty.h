// What is certain. An error is what the control alarms on whatever exists next to the program. What definition files,
// other programs, cycles and options decide is open: a warning that says what would settle it, one for each name, and
// no verdict is better than unknown until it is settled.
#pragma once

#include <span>

#include "dialects/ir/control.h"

namespace dripfeed::sinumerik {

// The faults that are open, for ir::Control::outside.
std::span<const ir::OutsideRow> open_faults();

}  // namespace dripfeed::sinumerik
