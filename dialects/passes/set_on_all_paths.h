// Reads of variables that no assignment surely came before: on controls with '#' variables such a variable is empty,
// elsewhere it holds what another program or the operator left.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::passes {

// Which variables are watched: a number for each, the same for each use of it; nothing for all others.
using WatchedVariable = std::function<std::optional<std::uint32_t>(const ir::Variable&)>;

struct UnsetRead {
  std::uint32_t statement = 0;
  ir::VariableId variable = ir::VariableId::none;
  std::uint32_t watched = 0;  // as WatchedVariable numbered it
};

// In the order of the text; statements that are never reached have none.
std::vector<UnsetRead> reads_before_set(const ir::Program& program, const WatchedVariable& watched);

}  // namespace dripfeed::passes
