// The motion code in effect, on all ways.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::passes {

// Before each statement, and at the end; nothing where ways differ, where a called program decides, or where no code
// was said yet.
std::vector<std::optional<ir::Function>> motions_before(const ir::Program& program);

// Whether a block behind the statement may move without saying how, on whatever way it is reached.
bool needs_motion(const ir::Program& program, std::uint32_t statement);

}  // namespace dripfeed::passes
