// Variables of the 0i-F/30i generation: ranges with what may be written, and which system variables have a meaning
// here. A variable that is not in a range does not exist; options (#98000…) are the machine profile's to add.
#include <array>

#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

namespace {

using ir::SystemValue;
using ir::SystemVariableRow;
using ir::VariableUse;

constexpr std::string_view kSystem = "0i-F B-64604EN, system variables";

constexpr auto kSystemVariables = std::to_array<SystemVariableRow>({
    {"", 3001, 3001, SystemValue::clock_ms, true, kSystem},
    {"", 4001, 4030, SystemValue::active_code, false, kSystem},
    {"", 4109, 4109, SystemValue::feed, false, kSystem},
    {"", 4119, 4119, SystemValue::spindle_speed, false, kSystem},
    {"", 4120, 4120, SystemValue::tool_number, false, kSystem},
    {"", 5001, 5020, SystemValue::end_position, false, kSystem},
    {"", 5021, 5040, SystemValue::machine_position, false, kSystem},
    {"", 5041, 5060, SystemValue::end_position, false, kSystem},
    {"", 5201, 5340, SystemValue::work_offset_value, true, kSystem},
    {"", 7001, 7960, SystemValue::work_offset_value, true, kSystem},
    {"", 14001, 20000, SystemValue::work_offset_value, true, kSystem},
});

struct RangeRow {
  std::uint32_t first;
  std::uint32_t last;
  VariableUse use;
  bool writable;
};
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
    {8000, 8999, VariableUse::system, true},
    {10001, 13999, VariableUse::system, true},  // tool offsets, memory C
    {14001, 20000, VariableUse::system, true},  // G54.1 P1..P300
});

}  // namespace

std::span<const SystemVariableRow> system_variables() { return kSystemVariables; }

std::vector<ir::VariableRange> variable_ranges() {
  std::vector<ir::VariableRange> ranges;
  for (const RangeRow& row : kRanges) ranges.push_back({ir::Bank::hash, row.first, row.last, row.use, row.writable});
  return ranges;
}

}  // namespace dripfeed::fanuc
