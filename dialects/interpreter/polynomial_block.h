// POLY: a block whose axes go as polynomials of one parameter. It becomes a chain of spline motions, points of the
// curve, no chord of them farther from it than kCurveChord_mm.
#pragma once

#include "dialects/interpreter/apply.h"
#include "dialects/interpreter/move.h"

namespace dripfeed::interpreter {

// Whether the block has words of a polynomial (PO) beside its end.
bool has_polynomial_words(const PlainBlock& block);
// A block under POLY, with such words or without: without them it is a straight cut. Fault curve_invalid: a way of
// the parameter (PL) that no control has, coefficients beyond all numbers.
void move_along_polynomial(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options,
                           const Target& target, ModalState& state, MotionBuffer& out, BlockResult& result);

}  // namespace dripfeed::interpreter
