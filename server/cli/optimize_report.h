// What optimizing gained, for standard error.
#pragma once

#include <string_view>

#include "dialects/compile/render/optimized.h"

namespace dripfeed::cli {

void print_changes(const compile::OptimizeResult& result, std::string_view name);
// Both runs' times and where the figures are from; or why the program was left as it was.
void print_saving(const compile::OptimizeResult& result, std::string_view name, const ir::CostModel& cost);

}  // namespace dripfeed::cli
