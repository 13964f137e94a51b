// Drilling cycles of controls that stay clear of the work in a form of their own (LinuxCNC): below the R level they
// lift to it before they go anywhere, what comes back by feed does so to the end, and G98 never ends below R.
#pragma once

#include "dialects/ir/cycle.h"

namespace dripfeed::ir {

// Added to the argument of Function::drill, together with kDrillAlongZ and kDrillAlongX.
inline constexpr std::int16_t kDrillKeepsClear = 300;

}  // namespace dripfeed::ir
