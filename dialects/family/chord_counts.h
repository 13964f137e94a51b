// How many chords a curve takes to lie within its error of them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dialects/family/bind.h"

namespace dripfeed::family {

struct ChordCounts {
  std::vector<double> by_piece;  // kCurvePieces whole numbers, at least 1
  std::string fault;             // why there are none; empty for none
};

// The values of the curve's ends, its error and all that its axes name are known. Lengths in mm; x counts as a radius.
// For a curve r(t) the chord over a step h of t lies within h²/8·max|r''| of it (the remainder of linear
// interpolation). Across a chord of the direction u only |u × r''| counts, and u is that of a mean of r', which lies
// in the enclosure of r' (mean value theorem). Both derivatives are enclosed over each chord, see second_derivative.h:
// the counts are proved, before the coordinates are rounded.
ChordCounts chord_counts(const BoundFamily& bound, const ChordedCurve& curve);

// Its axes.
std::span<const StepWord> words_of(const Family& family, const ChordedCurve& curve);

}  // namespace dripfeed::family
