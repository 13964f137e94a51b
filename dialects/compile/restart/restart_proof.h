// Whether the rest of a restart moves as the whole program does from the line on: the same moves with the same modes,
// events in the same order, from the same lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "dialects/compile/restart/restart_record.h"

namespace dripfeed::compile {

struct RestartProof {
  const RestartRun& whole;
  const RestartRun& rest;
  std::uint32_t whole_line = 0;  // the same block in both
  std::uint32_t rest_line = 0;
  // The rest begins with a tool change: until an axis is sent somewhere at rapid, it stands elsewhere, and what the
  // tool before had (length, spindle, coolant) is not there while nothing is cut.
  bool begins_with_tool = false;
  double rounding = 0.0;  // of a coordinate, mm or degrees

  // The first difference, "" without one; `moves` becomes how many moves are the same.
  [[nodiscard]] std::string difference(std::size_t& moves) const;
};

}  // namespace dripfeed::compile
