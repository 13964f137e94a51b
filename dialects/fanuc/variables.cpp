// Variables of the 0i-F/30i generation beyond those of all '#'-variable controls.
#include "dialects/macro_b/tables/variables.h"

#include <array>

#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

namespace {

using ir::SystemValue;
using ir::SystemVariableRow;
using ir::VariableUse;

constexpr std::string_view kSystem = "0i-F B-64604EN, system variables";

constexpr auto kSystemVariables = std::to_array<SystemVariableRow>({
    {"", 4012, 4030, SystemValue::active_code, false, kSystem},
    {"", 4212, 4230, SystemValue::active_code, false, kSystem},
    {"", 14001, 20000, SystemValue::work_offset_value, true, kSystem, false, 1},
    // Tool offsets: lengths count as not known from there. Those left out are work offsets of mills with a small memory
    // of tool offsets, and the work shifts of lathes (#2501, #2601).
    {"", 2001, 2499, SystemValue::not_modelled, true, kSystem, true},
    {"", 2507, 2599, SystemValue::not_modelled, true, kSystem, true},
    {"", 2607, 2699, SystemValue::not_modelled, true, kSystem, true},
    {"", 2701, 2799, SystemValue::not_modelled, true, kSystem, true},
    {"", 2801, 2999, SystemValue::not_modelled, true, kSystem, true},
    {"", 10001, 13999, SystemValue::not_modelled, true, kSystem, true},
});

constexpr auto kRanges = std::to_array<macro_b::RangeRow>({
    {8000, 8999, VariableUse::system, true},
    {10001, 13999, VariableUse::system, true},  // tool offsets, memory C
    {14001, 20000, VariableUse::system, true},  // G54.1 P1..P300
});

// The names that the 30i and 0i-F know themselves (B-64604EN, "System variables"): those whose numbers are of use.
constexpr auto kNames = std::to_array<macro_b::NamedVariable>({
    {"_ALM", 3000, false},   {"_CLOCK1", 3001, false}, {"_CLOCK2", 3002, false}, {"_CNTL1", 3003, false},
    {"_CNTL2", 3004, false}, {"_MSGSTP", 3006, false}, {"_MRIMG", 3007, false},  {"_DATE", 3011, false},
    {"_TIME", 3012, false},  {"_PRTSA", 3901, false},  {"_PRTSN", 3902, false},  {"_BUFG", 4001, true},
    {"_ACTG", 4201, true},   {"_ABSIO", 5001, true},   {"_ABSMT", 5021, true},   {"_ABSOT", 5041, true},
    {"_ABSKP", 5061, true},  {"_WZCMN", 5201, true},   {"_WZG54", 5221, true},   {"_WZG55", 5241, true},
    {"_WZG56", 5261, true},  {"_WZG57", 5281, true},   {"_WZG58", 5301, true},   {"_WZG59", 5321, true},
});

}  // namespace

std::span<const macro_b::NamedVariable> named_variables() { return kNames; }

std::span<const SystemVariableRow> system_variables() {
  static const std::vector<SystemVariableRow> kAll = macro_b::join_system_variables(kSystemVariables);
  return kAll;
}

std::vector<ir::VariableRange> variable_ranges() { return macro_b::join_ranges(kRanges); }

}  // namespace dripfeed::fanuc
