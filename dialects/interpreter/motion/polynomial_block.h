// POLY: a block whose axes go as polynomials of one parameter. It becomes a chain of spline motions, points of the
// curve, no chord of them farther from it than kCurveChord_mm.
#pragma once

#include "dialects/interpreter/motion/move.h"
#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"
#include "dialects/ir/polynomial_words.h"

namespace dripfeed::interpreter {

inline constexpr std::uint64_t kPolynomialWords = [] {
  std::uint64_t bits = 0;
  for (std::size_t axis = 0; axis < ir::kPolynomialAxes; ++axis)
    for (std::size_t power = ir::kFirstPower; power <= ir::kLastPower; ++power)
      bits |= bit_of(ir::coefficient_of(axis, power));
  return bits;
}();

// Whether the block has words of a polynomial (PO) besides its end.
inline bool has_polynomial_words(const PlainBlock& block) {
  return ((block.present | block.unknown) & kPolynomialWords) != 0;
}
// A block under POLY, with such words or without: without them it is a straight cut. Fault curve_invalid: a path of
// the parameter (PL) that no control has, coefficients beyond all numbers.
void move_along_polynomial(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options,
                           const Target& target, ModalState& state, MotionBuffer& out, BlockResult& result);

}  // namespace dripfeed::interpreter
