// Which places are still read after each statement, on whatever path a run takes.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/optimize/accesses.h"
#include "dialects/optimize/place_set.h"

namespace dripfeed::optimize {

class Liveness {
 public:
  Liveness(const ir::Program& program, const Places& places, const std::vector<Access>& accesses);
  // After the statement; before it.
  [[nodiscard]] bool after(std::uint32_t statement, Place place) const { return after_[statement].has(place); }
  [[nodiscard]] bool before(std::uint32_t statement, Place place) const { return before_[statement].has(place); }

 private:
  std::vector<PlaceSet> before_;
  std::vector<PlaceSet> after_;
};

}  // namespace dripfeed::optimize
