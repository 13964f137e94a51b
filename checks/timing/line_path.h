// Straight moves of three axes as flat arrays of points, and their pieces: what shape_of, speed_limit and corner_speed2
// say of one motion, for many at once.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "checks/timing/kinematics.h"
#include "checks/timing/piece_arrays.h"
#include "checks/timing/sweep.h"

namespace dripfeed::timing {

// points[axis][i], mm (x as radius): one more than moves; no two in a row the same. feed[i] of the move that ends at
// point i + 1, mm/s.
struct LinePath {
  std::array<std::vector<double>, 3> points;
  std::vector<double> feed;

  [[nodiscard]] std::size_t size() const { return feed.size(); }
};

// Pieces of the moves of `range`; `pieces` has the size of the path. Corners as V1 of A. Keinert, A. Verl; the first of
// the path starts from rest.
void line_pieces(const LinePath& path, const AxisRates& rates, Range range, PieceArrays& pieces);

}  // namespace dripfeed::timing
