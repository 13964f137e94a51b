// Variables beyond those of all '#'-variable controls.
#include "dialects/macro_b/tables/variables.h"

#include <array>

#include "dialects/mazak/tables.h"

namespace dripfeed::mazak {

namespace {

using ir::SystemValue;
using ir::SystemVariableRow;
using ir::VariableUse;

constexpr std::string_view kSystem = "Mazak EIA/ISO programming manual, user macro";
constexpr auto kSystemVariables = std::to_array<SystemVariableRow>({
    {"", 70001, 75980, SystemValue::work_offset_value, true, kSystem, false, 1},
    {"", 2001, 2999, SystemValue::not_modelled, true, kSystem, true},
    {"", 10001, 19999, SystemValue::not_modelled, true, kSystem, true},
});
constexpr auto kRanges = std::to_array<macro_b::RangeRow>({
    {10001, 19999, VariableUse::system, true},   // tool offsets by block of geometry and wear
    {51998, 51999, VariableUse::system, false},  // spindle tool
    {60000, 69999, VariableUse::system, true},   // tool data, tool life
    {70001, 75980, VariableUse::system, true},   // G54.1 P1..P300
});

}  // namespace

std::span<const SystemVariableRow> system_variables() {
  static const std::vector<SystemVariableRow> kAll = macro_b::join_system_variables(kSystemVariables);
  return kAll;
}

std::vector<ir::VariableRange> variable_ranges() { return macro_b::join_ranges(kRanges); }

}  // namespace dripfeed::mazak
