// A move in words, for a sentence about two moves that are not the same.
#pragma once

#include <string>

#include "dialects/ir/motion.h"

namespace dripfeed::compile {

// "line X10. Y2. F100": what of a move a reader looks for first, and what is in effect otherwise than with the other.
std::string describe_move(const ir::Motion& m, const ir::Motion& other);

}  // namespace dripfeed::compile
