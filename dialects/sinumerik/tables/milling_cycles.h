// Siemens' milling cycles that are interpreted: the order of each one's parameters, and what its values mean.
#pragma once

#include <span>
#include <string_view>

#include "dialects/ir/mill_cycle.h"

namespace dripfeed::sinumerik {

struct MillRow {
  std::string_view name;
  std::string_view parameters;  // by Siemens' names, in their order
  ir::ReadMillCycle read;
};

std::span<const MillRow> milling_cycles();

}  // namespace dripfeed::sinumerik
