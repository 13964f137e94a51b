// What is asked of the codes of one block.
#pragma once

#include <algorithm>

#include "dialects/ir/program.h"

namespace dripfeed::ir {

inline bool has_code(const Program& program, const Block& block, Function function) {
  return std::ranges::any_of(program.codes_of(block), [&](const Code& code) { return code.function == function; });
}

}  // namespace dripfeed::ir
