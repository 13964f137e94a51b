// What a later block needs of what is in effect now.
#pragma once

#include <cstdint>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::facts {

// Whether a block after the statement may move without stating its motion, on whatever path it is reached.
bool needs_motion(const ir::Program& program, std::uint32_t statement);

// Whether the block goes to a machine position (G53, SUPA) along an axis that has the tool's length: of mills Z, and
// all of them where the program leaves the plane XY.
bool moves_length_to_machine(const ir::Program& program, const ir::Block& block, const ir::Control& control);

}  // namespace dripfeed::facts
