// R of drilling cycles on lathes: with Fanuc and its relatives a distance from the initial level in G90, too, with
// others a level.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// Gives each R the number that means the same level on `to`, and reports those whose initial level is not known.
std::vector<text::Diagnostic> drill_levels(ir::Program& program, const ir::Control& from, const ir::Control& to);

}  // namespace dripfeed::macro_b
