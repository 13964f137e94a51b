// What each statement reads and sets, and where that is not known.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/optimize/places.h"

namespace dripfeed::optimize {

struct Access {
  std::vector<Place> reads;
  std::vector<Place> sets;
  bool sets_for_sure = true;  // false: block skip may leave it out
  bool reads_shared = false;  // any numbered variable: by a computed number, or in a called program
  bool sets_shared = false;
  bool reads_outside = false;  // system variables, elements: what they give may be another value each time
  bool is_fixed = false;       // it stays as it is and where it is
};

Access access_of(const ir::Program& program, const Places& places, std::uint32_t statement);
std::vector<Access> accesses_of(const ir::Program& program, const Places& places);

// By place: set once in the whole program, outside of loops and branches, and by numbers alone. Who runs the program is
// meant to change it there, so it stays as it is written.
std::vector<bool> parameters_of(const ir::Program& program, const Places& places, const std::vector<Access>& accesses);

// Why nothing may be concluded from the order of the text; empty where it may.
std::string obstacle(const ir::Program& program);
// … of the statements [first, last), without their lines.
std::string obstacle(const ir::Program& program, std::uint32_t first, std::uint32_t last);

}  // namespace dripfeed::optimize
