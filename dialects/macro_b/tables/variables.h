// Variables of the '#' controls: the ranges and system variables that all of them have, and those whose assignment is a
// statement of its own.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"

namespace dripfeed::macro_b {

// A parameter of the machine, PRM[n], and one of an axis, PRM[n]/[axis], as variables of bank `system`: their names.
inline constexpr std::string_view kParameter = "PRM";
inline constexpr std::string_view kParameterOfAxis = "PRM_OF_AXIS";

inline constexpr std::uint32_t kAlarmVariable = 3000;    // #3000 = n(TEXT): stop with an alarm
inline constexpr std::uint32_t kMessageVariable = 3006;  // #3006 = n(TEXT): stop with a message

struct RangeRow {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  ir::VariableUse use = ir::VariableUse::common;
  bool writable = true;
};

// The common ones with those of the dialect after them.
std::vector<ir::VariableRange> join_ranges(std::span<const RangeRow> own);
std::vector<ir::SystemVariableRow> join_system_variables(std::span<const ir::SystemVariableRow> own);

}  // namespace dripfeed::macro_b
