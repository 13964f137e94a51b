// The region of a modal drilling call: from after it to the next MCALL of the text.
#pragma once

#include <cstdint>
#include <span>

#include "dialects/ir/program.h"

namespace dripfeed::macro_b {

// All its blocks only position, by the motion code in effect or by G0; `taps`: and leave feed and speed alone.
bool region_positions(const ir::Program& program, std::uint32_t call, bool taps);
// A program that is called there: its moves would be followed by holes, too.
bool calls_in_region(const ir::Program& program, std::uint32_t call);
// One of the program's `jumps` leads into it or out of it, or from there to where it is not known.
bool jumps_across_region(const ir::Program& program, std::uint32_t call, std::span<const std::uint32_t> jumps);

}  // namespace dripfeed::macro_b
