// Siemens' cycles that are interpreted, as what they do. The only place that knows their names and the order of their
// parameters: readers put the row into the call, writers look for the row that does what they need.
#pragma once

#include <span>
#include <string_view>

#include "dialects/ir/called_cycle.h"

namespace dripfeed::sinumerik {

std::span<const ir::CalledCycle> called_cycles();
// nullptr for every other name.
const ir::CalledCycle* find_called_cycle(std::string_view name);
// The cycle that makes such a hole. `hole`: also what CYCLE83, CYCLE84 and CYCLE86 make by a value of theirs; nullptr:
// none does.
const ir::CalledCycle* cycle_for(ir::DrillCycle hole);

}  // namespace dripfeed::sinumerik
