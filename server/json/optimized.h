// What optimizing a text gave, as JSON: for the API, and for `dripfeed optimize --json`.
#pragma once

#include <string>

#include "dialects/compile/render/optimized.h"
#include "dialects/text/source.h"

namespace dripfeed::json {

// {"text","origins","passes":[{"rule","edits"}],"changes":[{"line","rule","what"}],"left_because","not_verified","proved_max_mm",
// "not_merged",
// "before","after","cost","diagnostics"}: the two costs are null where the program was not run before and after,
// `left_because` is why it is unchanged. The text is null where it could not be read.
std::string optimized(const compile::OptimizeResult& result, const ir::CostModel& cost, const text::Source& source);

}  // namespace dripfeed::json
