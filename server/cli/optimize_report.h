// What optimizing gained, for standard error.
#pragma once

#include <string_view>

#include "dialects/compile/optimized.h"
#include "server/cli/inputs.h"

namespace dripfeed::cli {

// The machine's own figures, or the usual ones of its control.
ir::CostModel cost_of(const ChosenControl& chosen);

void print_changes(const compile::OptimizeResult& result, std::string_view name);
// Both runs' times and where the figures are from; or why the program was left as it was.
void print_saving(const compile::OptimizeResult& result, std::string_view name, const ir::CostModel& cost);

}  // namespace dripfeed::cli
