// What is certain. An error is what the control alarms on whatever exists beside the program. What definition files,
// other programs, cycles and options decide is open: a warning that says what would settle it, one for each name, and
// no verdict is better than unknown until it is settled.
#pragma once

#include <span>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::sinumerik {

// The faults that are open, for ir::Control::outside.
std::span<const ir::OutsideRow> open_faults();

// Leaves of the open faults of one name the first in each program of the text.
void keep_one_per_name(const ir::Program& program, std::vector<text::Diagnostic>& diagnostics);

}  // namespace dripfeed::sinumerik
