// Variables beyond those of all '#'-variable controls. Since NGC each range of the old numbers has a second one from
// #10000 on for the same memory; which of them a program uses does not matter as long as it uses one.
#include "dialects/macro_b/tables/variables.h"

#include <array>

#include "dialects/haas/tables.h"

namespace dripfeed::haas {

namespace {

using ir::SystemValue;
using ir::SystemVariableRow;
using ir::VariableUse;

constexpr std::string_view kSystem = "Haas NGC operator's manual, macros, system variables";
constexpr auto kSystemVariables = std::to_array<SystemVariableRow>({
    {"", 3026, 3026, SystemValue::tool_number, false, kSystem},
    {"", 3027, 3027, SystemValue::spindle_speed, false, kSystem},
    {"", 14001, 15966, SystemValue::work_offset_value, true, kSystem, false, 1},
    {"", 2001, 2999, SystemValue::not_modelled, true, kSystem, true},  // tool offsets
    {"", 1136, 1155, SystemValue::not_modelled, true, kSystem, true},
    {"", 3020, 3025, SystemValue::changing, true, kSystem, true},
    {"", 3101, 3101, SystemValue::not_modelled, true, kSystem, true},
    {"", 5401, 5499, SystemValue::changing, true, kSystem, true},
    {"", 12000, 12255, SystemValue::not_modelled, true, kSystem, true},
});
constexpr auto kRanges = std::to_array<macro_b::RangeRow>({
    {1036, 1063, VariableUse::system, false},      // inputs
    {1064, 1098, VariableUse::system, false},      // loads and analog inputs
    {1136, 1155, VariableUse::system, true},       // outputs
    {1264, 1268, VariableUse::system, false},      // loads of further axes
    {1601, 2000, VariableUse::system, true},       // flutes and vibration by tool
    {2965, 2999, VariableUse::system, true},       // tool offsets
    {3020, 3028, VariableUse::system, true},       // timers, tool in the spindle, its speed
    {3030, 3034, VariableUse::system, false},      // single block, dry run, block skip, optional stop, safe run
    {3101, 3101, VariableUse::system, true},       // as programs of probes use it
    {3196, 3401, VariableUse::system, true},       // timers, diameters and coolant position by tool
    {5401, 5499, VariableUse::system, true},       // tool life: feed time
    {8500, 8699, VariableUse::system, true},       // tool groups and usage
    {10000, 10999, VariableUse::permanent, true},  // the second numbers of #100 to #999
    {11000, 11255, VariableUse::system, false},    // inputs
    {12000, 12255, VariableUse::system, true},     // outputs
    {13000, 13063, VariableUse::system, false},    // analog inputs
    {14001, 15966, VariableUse::system, true},     // G154 P1 to P99
    {20000, 29999, VariableUse::system, false},    // settings
    {30000, 39999, VariableUse::system, false},    // parameters
    {50001, 56000, VariableUse::system, true},     // tool table
});

}  // namespace

std::span<const SystemVariableRow> system_variables() {
  static const std::vector<SystemVariableRow> kAll = macro_b::join_system_variables(kSystemVariables);
  return kAll;
}

std::vector<ir::VariableRange> variable_ranges() { return macro_b::join_ranges(kRanges); }

}  // namespace dripfeed::haas
