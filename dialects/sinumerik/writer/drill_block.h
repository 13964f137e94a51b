// A block of a modal drilling cycle, taken apart.
#pragma once

#include <vector>

#include "dialects/ir/cycle.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

// What one block of a drilling cycle says.
struct DrillBlock {
  std::vector<ir::Code> rest_codes;
  std::vector<ir::Word> rest_words;
  std::vector<ir::Word> positions;
  bool begins = false;     // has the cycle's code
  bool redefines = false;  // other words of the cycle
  bool drills = false;
  double repeats = 1.0;
};

// `axis`: that the cycle drills along.
DrillBlock drill_block(const Raising& raising, const ir::Block& block, ir::Address axis, ir::DrillCycle cycle);

}  // namespace dripfeed::sinumerik
