// Where the part of a text that the control reads begins and ends: its % signs.
#pragma once

#include "dialects/ir/program.h"

namespace dripfeed::macro_b {

// Whether the text begins with %: after a leader, or after comments of whoever stored it where a program follows.
bool begins_with_tape_mark(const ir::Program& program);

}  // namespace dripfeed::macro_b
