// From where to where in the text a variable's value is needed, on the safe side: a use inside a loop needs it in the
// whole loop, and where calls or unknown statements may look at it, everywhere.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::passes {

// Statements first..last, both included; empty at the start.
struct LiveRange {
  std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t last = 0;
  [[nodiscard]] bool empty() const { return first > last; }
  [[nodiscard]] bool meets(const LiveRange& other) const { return first <= other.last && other.first <= last; }
  static LiveRange always() { return {0, std::numeric_limits<std::uint32_t>::max()}; }
};

class LiveRanges {
 public:
  explicit LiveRanges(const ir::Program& program);
  // Makes `range` hold a use at the statement, and all loops around it.
  void extend(LiveRange& range, std::uint32_t statement) const;

 private:
  std::vector<LiveRange> loop_of_;  // by statement: the outermost loop around it
};

}  // namespace dripfeed::passes
