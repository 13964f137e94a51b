// Arc centres that are places and not distances (I=AC(10)): the other controls know only distances from the start.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

// Each absolute centre word becomes its distance from where the block starts: a number where that place is known from
// the blocks before it, otherwise calculated from the control's own end of the last block (#5001, workpiece
// coordinates: B-64604EN, system variables of positions). Errors at their blocks: on lathes, whose positions are
// diameters, and in rotated, scaled or mirrored coordinates, where #5001 is another place.
std::vector<text::Diagnostic> translate_centers(ir::Program& program, const ir::Control& from, const ir::Control& to);

}  // namespace dripfeed::passes
