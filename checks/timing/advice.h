// What would keep a machine from waiting: the same rows run again, with a faster line or with slower feeds.
#pragma once

#include <vector>

#include "checks/timing/piece_arrays.h"
#include "checks/timing/rows.h"
#include "checks/timing/supply.h"
#include "checks/timing/timing.h"

namespace dripfeed::timing {

// A whole program. feed_mm_s and limit_mm_s of each piece: what is programmed (kNoLimit for rapids) and what the axes
// allow.
struct WholeProgram {
  const Rows& rows;
  const PieceArrays& pieces;
  const std::vector<double>& feed_mm_s;
  const std::vector<double>& limit_mm_s;
};

// `supply` and `line` as the program was timed with.
Advice advise(const WholeProgram& program, const SupplySettings& supply, const std::optional<Line>& line,
              std::size_t look_ahead, unsigned threads);

}  // namespace dripfeed::timing
