// G06.2: control points and knots come block by block; when the curve is complete it is one chain of spline motions.
// Points of the curve, no chord of them farther from it than kCurveChord_mm.
#pragma once

#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

// A block while G06.2 is in effect: P the order (first block), K the knot, axis words and R the control point.
// Fault curve_invalid: a knot that falls, a first point where the tool is not, an order that no control has.
void add_to_curve(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                  BlockResult& result);
// A point of a complete curve, in the knot span that begins at knots[span].
AxisValues point_of_curve(const CurveInput& input, std::size_t span, double u);
// The mode ends before the curve is complete: fault curve_invalid.
void break_curve(ModalState& state, BlockResult& result);

}  // namespace dripfeed::interpreter
