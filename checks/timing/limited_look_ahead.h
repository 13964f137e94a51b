// The look-ahead of A. Keinert, A. Verl, "Analysis of CNC software modules regarding parallelization capability": the
// path is cut into buffers of some hundred elements, each of which is swept back by itself from some elements after
// it, as if it ended there at rest. Other than plan_path it gives another plan where those are too few.
#pragma once

#include <cstddef>
#include <vector>

#include "checks/timing/piece_arrays.h"

namespace dripfeed::timing {

struct LimitedLookAhead {
  std::size_t elements = 300;     // a buffer
  std::size_t overlap_least = 5;  // elements after it that are swept, too
  std::size_t overlap_most = 50;
  unsigned threads = 1;
};

struct LimitedPlan {
  std::vector<double> limit2;  // (mm/s)² at each junction: the look-ahead profile; pieces + 1
  std::vector<std::size_t>
      overlap;          // of each buffer: what it takes to reach its last feed from rest, within the bounds
  std::size_t cut = 0;  // buffers for which overlap_most was too little
};

// The same for any number of threads. `plan` is overwritten.
void plan_limited(const PieceArrays& pieces, const LimitedLookAhead& settings, LimitedPlan& plan);

}  // namespace dripfeed::timing
