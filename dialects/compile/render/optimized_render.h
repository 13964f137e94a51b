// A rendered macro made faster for its control. All variables of the text were chosen by rendering, so all of them are
// its own.
#pragma once

#include "dialects/compile/render/optimized.h"
#include "dialects/compile/render/render.h"

namespace dripfeed::compile {

// Changes text, counts and profile lines of `rendered`, a macro; what else comes back says what was found. Blocks, and
// native programs that are kept as they are, have an obstacle.
OptimizeResult optimize_rendered(RenderResult& rendered, const ir::Control& control, const ir::CostModel& cost,
                                 const optimize::Rules& rules = {});

}  // namespace dripfeed::compile
