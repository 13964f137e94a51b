// Variables of the 0i-F/30i generation beyond those of all '#'-variable controls.
#include "dialects/macro_b/variables.h"

#include <array>

#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

namespace {

using ir::SystemValue;
using ir::SystemVariableRow;
using ir::VariableUse;

constexpr std::string_view kSystem = "0i-F B-64604EN, system variables";

constexpr auto kSystemVariables = std::to_array<SystemVariableRow>({
    {"", 14001, 20000, SystemValue::work_offset_value, true, kSystem},
});

constexpr auto kRanges = std::to_array<macro_b::RangeRow>({
    {8000, 8999, VariableUse::system, true},
    {10001, 13999, VariableUse::system, true},  // tool offsets, memory C
    {14001, 20000, VariableUse::system, true},  // G54.1 P1..P300
});

}  // namespace

std::span<const SystemVariableRow> system_variables() {
  static const std::vector<SystemVariableRow> kAll = macro_b::join_system_variables(kSystemVariables);
  return kAll;
}

std::vector<ir::VariableRange> variable_ranges() { return macro_b::join_ranges(kRanges); }

}  // namespace dripfeed::fanuc
