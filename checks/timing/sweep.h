// The loops of the look-ahead over a range of pieces. The caller owns the arrays and cuts them into ranges; two ranges
// that do not overlap may be swept by two threads.
#pragma once

#include <cstddef>

#include "checks/timing/piece_arrays.h"

namespace dripfeed::timing {

struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;  // not in it
};

// What a piece can change the square of the speed by: 2·a·L.
inline double change2(const PieceArrays& pieces, std::size_t i) {
  return 2.0 * pieces.acceleration[i] * pieces.length[i];
}

// Highest square at the start of each piece of the range by its own limit and those of the two pieces that meet there.
// Junction 0 is at rest.
void junction_limits(const PieceArrays& pieces, Range range, double* speed2);
// A control that sees `blocks` pieces must be able to stop in them. sums[i]: change2 of all pieces before i, size()
// + 1.
void horizon_limits(const double* sums, std::size_t size, std::size_t blocks, Range range, double* speed2);

// speed2[i] = min(speed2[i], speed2[i+1] + change2[i]) from the last of the range to its first; `after` is the square
// after it.
void sweep_back(const PieceArrays& pieces, Range range, double after, double* speed2);
// As sweep_back of a range that was swept with a higher `after`: ends at the first junction that stays the same to the
// last bit, because all before it then stay, too. Returns how many changed.
std::size_t resweep_back(const PieceArrays& pieces, Range range, double after, double* speed2);

// speed2[i+1] = min(speed2[i+1], speed2[i] + change2[i]) for all but the last of the range: junctions of it alone.
void sweep_ahead(const PieceArrays& pieces, Range range, double* speed2);
// The first junction of a range that was swept from a higher square becomes `first`; ends as resweep_back.
std::size_t resweep_ahead(const PieceArrays& pieces, Range range, double first, double* speed2);

// Seconds of each piece: a trapezoid of speed between its two junctions.
void durations(const PieceArrays& pieces, Range range, const double* speed2, double* duration_s);

struct Trapezoid {
  double peak = 0.0;  // mm/s
  double duration_s = 0.0;
  double brake_s = 0.0;  // of it, the slowing down at its end
};
Trapezoid trapezoid_of(const Piece& piece, double start2, double end2);

}  // namespace dripfeed::timing
