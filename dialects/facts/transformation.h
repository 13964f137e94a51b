// Where a transformation (G12.1, G07.1, TRANSMIT, TRACYL) ends.
#pragma once

#include "dialects/ir/program.h"

namespace dripfeed::facts {

// TRAFOOF, G13.1, G07.1 C0. `code`: of Function::transformation, in the block.
bool ends_transformation(const ir::Program& program, const ir::Block& block, const ir::Code& code);

}  // namespace dripfeed::facts
