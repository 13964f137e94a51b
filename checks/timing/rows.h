// What runs, one row a motion or event, as the supply and the execution see it.
#pragma once

#include <cstdint>
#include <vector>

namespace dripfeed::timing {

struct Row {
  std::uint32_t line = 0;
  std::uint32_t bytes = 0;  // on the wire
  bool is_new = true;       // begins another block; otherwise goes on with the one before (its second motion)
  bool is_piece = false;    // the plan gives its time; otherwise event_s is it
  bool is_rapid = false;
  std::uint32_t lines = 0;  // of the text, on the wire
  double compute_s = 0.0;
  double event_s = 0.0;  // dwell, tool change
};
using Rows = std::vector<Row>;

}  // namespace dripfeed::timing
