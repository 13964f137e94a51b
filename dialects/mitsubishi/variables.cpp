// Variables beyond those of all '#'-variable controls.
#include "dialects/macro_b/tables/variables.h"

#include <array>

#include "dialects/mitsubishi/tables.h"

namespace dripfeed::mitsubishi {

namespace {

using ir::SystemValue;
using ir::SystemVariableRow;
using ir::VariableUse;

constexpr std::string_view kSystem = "M800/M80 series programming manual, system variables";
constexpr auto kSystemVariables = std::to_array<SystemVariableRow>({
    {"", 101001, 115000, SystemValue::work_offset_value, true, kSystem, false, 49},
    {"", 1300, 1395, SystemValue::not_modelled, true, kSystem, true},
    {"", 2001, 2999, SystemValue::not_modelled, true, kSystem, true},
    {"", 10001, 16999, SystemValue::not_modelled, true, kSystem, true},
});
constexpr auto kRanges = std::to_array<macro_b::RangeRow>({
    {1200, 1295, VariableUse::system, false},   // more signals from the PLC
    {1300, 1395, VariableUse::system, true},    // … and to it
    {10001, 16999, VariableUse::system, true},  // tool offsets type II
    {30060, 31999, VariableUse::system, false},
    {60000, 64700, VariableUse::system, true},    // tool life
    {100000, 100110, VariableUse::system, true},  // parameter and device access
    {101001, 115000, VariableUse::system, true},  // G54.1 P49..P300
});

}  // namespace

std::span<const SystemVariableRow> system_variables() {
  static const std::vector<SystemVariableRow> kAll = macro_b::join_system_variables(kSystemVariables);
  return kAll;
}

std::vector<ir::VariableRange> variable_ranges() { return macro_b::join_ranges(kRanges); }

}  // namespace dripfeed::mitsubishi
