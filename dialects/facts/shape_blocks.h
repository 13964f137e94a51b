// The blocks that G70 to G73 name by P and Q: they are run for their cycle alone. After it the program goes on after
// them.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::facts {

struct Shape {
  std::uint32_t cycle = 0;  // statements
  std::uint32_t first = 0;
  std::uint32_t end = 0;  // after its last one
  // It stands right after a roughing cycle, and nothing jumps into it: from the cycle the program goes on at `end`.
  bool is_left_out = false;
};
std::vector<Shape> shapes_of(const ir::Program& program);

}  // namespace dripfeed::facts
