// Turning cycles for a control that has none of that kind: G90, G92 and G94 as the four moves around their rectangle,
// G74 to G76 and CYCLE97 as all their moves. What they depend on must be known: where the tool stands, what the cycle
// keeps, and for G74 to G76 and CYCLE97 each number.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// What cannot be written so is an error at its block.
std::vector<text::Diagnostic> lower_turning(ir::Program& program, const ir::Control& from, const ir::Control& to);

}  // namespace dripfeed::compile
