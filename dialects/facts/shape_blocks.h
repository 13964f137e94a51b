// The blocks that G70 to G73 name by P and Q: they are run for their cycle alone. After it the program goes on after
// them.
#pragma once

#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::facts {

// By statement.
std::vector<bool> blocks_of_shapes(const ir::Program& program);
// Those that stand right after the roughing cycle that cuts them, and that nothing jumps into: behind its cycle the
// program goes on after them.
std::vector<bool> blocks_left_out(const ir::Program& program);

}  // namespace dripfeed::facts
