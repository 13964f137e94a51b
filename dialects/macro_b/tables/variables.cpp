// A variable that is not in a range does not exist; options are the machine profile's to add.
#include "dialects/macro_b/tables/variables.h"

#include <array>

namespace dripfeed::macro_b {

namespace {

using ir::SystemValue;
using ir::SystemVariableRow;
using ir::VariableUse;

constexpr std::string_view kSystem = "0i-F B-64604EN, system variables; Mazak and Mitsubishi alike";

constexpr auto kSystemVariables = std::to_array<SystemVariableRow>({
    {"", 3001, 3001, SystemValue::clock_ms, true, kSystem},
    {"", 3002, 3002, SystemValue::clock_hours, true, kSystem},
    {"", 4001, 4011, SystemValue::active_code, false, kSystem},  // the groups that these controls number alike
    {"", 4107, 4107, SystemValue::comp_number, false, kSystem},
    {"", 4109, 4109, SystemValue::feed, false, kSystem},
    {"", 4111, 4111, SystemValue::length_number, false, kSystem},
    {"", 4114, 4114, SystemValue::block_number, false, kSystem},
    {"", 4115, 4115, SystemValue::program_number, false, kSystem},
    {"", 4119, 4119, SystemValue::spindle_speed, false, kSystem},
    {"", 4120, 4120, SystemValue::tool_number, false, kSystem},
    {"", 4201, 4211, SystemValue::active_code, false, kSystem},
    {"", 4309, 4309, SystemValue::feed, false, kSystem},
    {"", 4320, 4320, SystemValue::tool_number, false, kSystem},
    {"", 5001, 5020, SystemValue::end_position, false, kSystem},
    {"", 5021, 5040, SystemValue::machine_position, false, kSystem},
    {"", 5041, 5060, SystemValue::end_position, false, kSystem},
    {"", 5061, 5080, SystemValue::skip_position, false, kSystem},
    {"", 5201, 5340, SystemValue::work_offset_value, true, kSystem},
    {"", 7001, 7960, SystemValue::work_offset_value, true, kSystem, false, 1},
    // What may be written without a move, a shift or a mode becoming another one.
    {"", 1100, 1135, SystemValue::not_modelled, true, kSystem, true},
    {"", 3000, 3000, SystemValue::not_modelled, true, kSystem, true},
    {"", 3003, 3004, SystemValue::not_modelled, true, kSystem, true},
    {"", 3006, 3006, SystemValue::not_modelled, true, kSystem, true},
    {"", 3901, 3901, SystemValue::changing, true, kSystem, true},
    {"", 3902, 3902, SystemValue::not_modelled, true, kSystem, true},
});

constexpr auto kRanges = std::to_array<RangeRow>({
    {1, 33, VariableUse::local, true},
    {100, 199, VariableUse::common, true},
    {500, 999, VariableUse::permanent, true},
    {1000, 1035, VariableUse::system, false},  // signals from the PMC
    {1100, 1135, VariableUse::system, true},   // signals to the PMC
    {2001, 2964, VariableUse::system, true},   // tool offsets
    {3000, 3007, VariableUse::system, true},   // alarm, clocks, single block, message
    {3008, 3008, VariableUse::system, false},  // restart
    {3011, 3012, VariableUse::system, false},  // date, time
    {3901, 3902, VariableUse::system, true},   // parts
    {4000, 4530, VariableUse::system, false},  // modal codes
    {5001, 5200, VariableUse::system, false},  // positions
    {5201, 5340, VariableUse::system, true},   // work offsets
    {5500, 5999, VariableUse::system, true},   // fixture offsets
    {7001, 7960, VariableUse::system, true},   // G54.1 P1..P48
});

}  // namespace

std::vector<ir::VariableRange> join_ranges(std::span<const RangeRow> own) {
  std::vector<ir::VariableRange> ranges;
  const auto add = [&](const RangeRow& r) { ranges.push_back({ir::Bank::hash, r.first, r.last, r.use, r.writable}); };
  for (const RangeRow& row : kRanges) add(row);
  for (const RangeRow& row : own) add(row);
  return ranges;
}

std::vector<SystemVariableRow> join_system_variables(std::span<const SystemVariableRow> own) {
  std::vector<SystemVariableRow> rows(kSystemVariables.begin(), kSystemVariables.end());
  rows.insert(rows.end(), own.begin(), own.end());
  return rows;
}

}  // namespace dripfeed::macro_b
