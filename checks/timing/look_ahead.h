// The look-ahead plan of a whole path: at which speed each piece begins and how long it takes. Exact for any length, by
// any number of threads the same to the last bit.
#pragma once

#include <cstddef>
#include <vector>

#include "checks/timing/line_path.h"
#include "checks/timing/piece_arrays.h"

namespace dripfeed::timing {

struct LookAhead {
  std::size_t blocks = 0;  // pieces that the control sees at a time and can stop within; 0: all
  unsigned threads = 1;
  std::size_t grain = 4096;  // a thread is worth starting for so many pieces
};

struct SpeedPlan {
  std::vector<double> speed2;      // (mm/s)² at each junction: pieces + 1, at rest first and last
  std::vector<double> duration_s;  // of each piece
  double total_s = 0.0;
  std::size_t reswept = 0;  // junctions that had been speculated wrongly and were swept again
};

// Path from rest to rest. `plan` is overwritten; its memory is used again.
void plan_path(const PieceArrays& pieces, const LookAhead& look_ahead, SpeedPlan& plan);
// The same from points: `pieces` is filled by the threads that plan it.
void plan_lines(const LinePath& path, const AxisRates& rates, const LookAhead& look_ahead, PieceArrays& pieces,
                SpeedPlan& plan);

// sums[i] = change2 of all pieces before i; one more than pieces.
void change_sums(const PieceArrays& pieces, std::vector<double>& sums);

}  // namespace dripfeed::timing
