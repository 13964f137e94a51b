// The plan is two sweeps over squares of speed, in which a piece of length L and acceleration a changes the square by
// at most 2·a·L.
//
//   speed²
//     |     ______________ limit of the piece            backward: b[i] = min(limit[i], b[i+1] + 2aL)
//     |    /.            .\                              forward:  v[i+1] = min(b[i+1], v[i] + 2aL)
//     |   / .            . \      ___ ...
//     |  /  .            .  \____/                       The time of a piece is that of the trapezoid (or triangle)
//     +-----+------------+-----------> path              between v[i] and v[i+1] under its own limit.
//         corner       corner
//
// Both sweeps are chains of one addition and one minimum; everything else is kept out of them. Squares are finite and
// not negative, so a minimum is a minimum and the compiler may use its vector instructions.
#include "checks/timing/sweep.h"

#include <algorithm>
#include <cmath>

namespace dripfeed::timing {

void junction_limits(const PieceArrays& pieces, Range range, double* speed2) {
  const double* start2 = pieces.start2.data();
  const double* own2 = pieces.speed2.data();
  if (range.begin == 0 && range.end > 0) speed2[0] = 0.0;
  for (std::size_t i = std::max<std::size_t>(range.begin, 1); i < range.end; ++i) {
    const double both = own2[i] < own2[i - 1] ? own2[i] : own2[i - 1];
    speed2[i] = start2[i] < both ? start2[i] : both;
  }
}

void horizon_limits(const double* sums, std::size_t size, std::size_t blocks, Range range, double* speed2) {
  for (std::size_t i = range.begin; i < range.end; ++i) {
    speed2[i] = std::min(speed2[i], sums[std::min(size, i + blocks)] - sums[i]);
  }
}

void sweep_back(const PieceArrays& pieces, Range range, double after, double* speed2) {
  const double* length = pieces.length.data();
  const double* acceleration = pieces.acceleration.data();
  for (std::size_t i = range.end; i-- > range.begin;) {
    after = std::min(speed2[i], after + 2.0 * acceleration[i] * length[i]);
    speed2[i] = after;
  }
}

std::size_t resweep_back(const PieceArrays& pieces, Range range, double after, double* speed2) {
  std::size_t changed = 0;
  for (std::size_t i = range.end; i-- > range.begin; ++changed) {
    after = std::min(speed2[i], after + change2(pieces, i));
    if (after == speed2[i]) break;
    speed2[i] = after;
  }
  return changed;
}

void sweep_ahead(const PieceArrays& pieces, Range range, double* speed2) {
  const double* length = pieces.length.data();
  const double* acceleration = pieces.acceleration.data();
  if (range.begin >= range.end) return;
  double before = speed2[range.begin];
  for (std::size_t i = range.begin; i + 1 < range.end; ++i) {
    before = std::min(speed2[i + 1], before + 2.0 * acceleration[i] * length[i]);
    speed2[i + 1] = before;
  }
}

std::size_t resweep_ahead(const PieceArrays& pieces, Range range, double first, double* speed2) {
  std::size_t changed = 0;
  for (std::size_t i = range.begin; i < range.end; ++i, ++changed) {
    if (first == speed2[i]) break;
    speed2[i] = first;
    if (i + 1 < range.end) first = std::min(speed2[i + 1], first + change2(pieces, i));
  }
  return changed;
}

Trapezoid trapezoid_of(const Piece& piece, double start2, double end2) {
  const double change = 2.0 * piece.acceleration * piece.length;
  const double free2 = std::max(std::max(start2, end2), 0.5 * (start2 + end2 + change));
  const double peak2 = std::min(piece.speed2, free2);
  const double peak = std::sqrt(peak2);
  const double start = std::sqrt(start2);
  const double end = std::sqrt(end2);
  const double inverse = 1.0 / piece.acceleration;
  const double ramps = ((peak2 - start2) + (peak2 - end2)) * 0.5 * inverse;
  const double even = piece.length > ramps ? piece.length - ramps : 0.0;
  return {peak, ((peak - start) + (peak - end)) * inverse + even / peak, (peak - end) * inverse};
}

void durations(const PieceArrays& pieces, Range range, const double* speed2, double* duration_s) {
  const double* length = pieces.length.data();
  const double* own2 = pieces.speed2.data();
  const double* acceleration = pieces.acceleration.data();
  for (std::size_t i = range.begin; i < range.end; ++i) {
    duration_s[i] = trapezoid_of({length[i], own2[i], 0.0, acceleration[i]}, speed2[i], speed2[i + 1]).duration_s;
  }
}

}  // namespace dripfeed::timing
