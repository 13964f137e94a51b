// A proved range of the distance between a piece of path and the part of a curve next to it.
#pragma once

#include <optional>

#include "dialects/curves/parametric_curve.h"
#include "dialects/curves/path.h"

namespace dripfeed::curves {

// Encloses the signed distance of C(t), t in `t`, from the straight line of a segment or the circle of an arc, positive
// to the left of the path's direction. Branch and bound: a part of width w with the gap g known at its ends keeps
// within them ± max|g''|·w²/8, and parts that could still matter are halved until the range is known to within
// `relative` of its size. For a segment g'' = n·C''; for an arc g = ρ - r, g'' = |C'⊥|²/ρ + u·C''.
//
//      What that says of the path, when its ends have their feet at the ends of `t`: the perpendicular through any
//      point of the segment meets the curve within the range, so no point of the path lies farther from the curve than
//      the range says (or than an end does); and no point of the curve comes nearer to it.
//
// Nothing where the curve's second derivatives are not bounded, the piece has no length, or an arc's centre lies too
// near. The number of parts is bounded; beyond it the range is wider than asked for.
std::optional<Range> gap_range(const ParametricCurve& curve, Range t, const PathPiece& piece, double relative = 0.02);

}  // namespace dripfeed::curves
