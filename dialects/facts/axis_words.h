// Whether the axis words of a block are positions that its motion goes to.
#pragma once

#include "dialects/ir/program.h"

namespace dripfeed::facts {

// Words in the block of this code are the code's own (a dwell's time, a shift, limits, data), or name positions that
// only the machine knows (G53, a code whose number is computed, one that is not interpreted).
bool has_own_words(const ir::Code& code);
bool has_own_words(const ir::Program& program, const ir::Block& block);

}  // namespace dripfeed::facts
