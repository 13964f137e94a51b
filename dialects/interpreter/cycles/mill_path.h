// A milling cycle along a contour that the program states: the tool's centre goes along it at each depth, without
// compensation of the radius.
//
//        in o-----> first piece ... last piece ----->o out     straight: along the tangent, at the depth
//
// At each depth the tool goes down by feed at the point `in`, which is the contour's start where it goes in vertically.
#pragma once

#include <vector>

#include "dialects/interpreter/cycles/milling.h"

namespace dripfeed::interpreter {

// The motions are those of the contour's blocks, of which the first leads to its start. Like `mill`; afterwards the
// tool stands at the return level, over a place that is not known.
MillOutcome mill_path(const ir::MillCycle& cycle, const std::vector<ir::Motion>& contour, const BlockRules& rules,
                      ModalState& state, MotionBuffer& out, BlockResult& result);

}  // namespace dripfeed::interpreter
