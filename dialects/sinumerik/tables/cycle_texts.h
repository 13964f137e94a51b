// Texts of the standard cycles, one a cycle. "@name" in a text stands for a fragment that cycles share
// (standard_cycles.cpp).
#pragma once

#include <span>
#include <string_view>

namespace dripfeed::sinumerik {

struct CycleText {
  std::string_view name;
  std::string_view text;
};

std::span<const CycleText> drilling_cycles();
std::span<const CycleText> turning_cycles();

}  // namespace dripfeed::sinumerik
