// The table: names, what a run answers, whether a program may write, and the source (the list of system variables in
// Job Planning, PGA; List Manual System Variables, LIS1).
#include "dialects/sinumerik/tables/system_variables.h"

#include <algorithm>
#include <array>
#include <vector>

#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/tables/vocabulary.h"

namespace dripfeed::sinumerik {

namespace {

using enum ir::SystemValue;
using enum ir::SystemUse;

// clang-format off
constexpr auto kVariables = std::to_array<ir::SystemVariableRow>({
  {"$", 0, 0, not_modelled, false, "any other system variable"},
  // program
  {"$P_EP", 0, 0, end_position, false, "LIS1, programmed end position in the work coordinates"},
  {"$P_F", 0, 0, feed, false, "LIS1, last programmed path feed"},
  {"$P_S", 0, 0, spindle_speed, false, "LIS1, last programmed spindle speed"},
  {"$P_TOOLNO", 0, 0, tool_number, false, "LIS1, active tool number"},
  {"$P_TOOLP", 0, 0, selected_tool, false, "LIS1, last programmed tool"},
  {"$P_TOOL", 0, 0, tool_edge, false, "LIS1, active cutting edge"},
  {"$P_GG", 0, 0, active_code, false, "LIS1, index of the active code of a group"},
  {"$P_EXTGG", 0, 0, not_modelled, false, "LIS1, the same in ISO mode"},
  {"$P_SDIR", 0, 0, spindle_direction, false, "LIS1, last programmed spindle direction"},
  {"$P_MSNUM", 1, 1, constant, false, "LIS1, master spindle"},
  {"$P_EPM", 0, 0, not_modelled, false, "LIS1, programmed end position in machine coordinates"},
  {"$P_UIFR", 0, 0, settable_frame, true, "LIS1, settable frames"},
  {"$P_IFRAME", 0, 0, active_frame, true, "LIS1, active settable frame"},
  {"$P_PFRAME", 0, 0, programmable_frame, true, "LIS1, programmable frame"},
  {"$P_BFRAME", 0, 0, base_frame, true, "LIS1, current first base frame of the channel"},
  {"$P_UBFR", 0, 0, base_frame_in_data, true, "LIS1, first base frame of the channel, taken by G500, G54 ..."},
  {"$P_CHBFR", 0, 0, not_modelled, true, "LIS1, channel base frames"},
  {"$P_NCBFR", 0, 0, not_modelled, true, "LIS1, global base frames"},
  {"$P_ACTFRAME", 0, 0, total_frame, false, "LIS1, total frame"},
  {"$P_PROG", 0, 0, not_modelled, false, "LIS1, program names by level"},
  {"$P_STACK", 0, 0, not_modelled, false, "LIS1, program level"},
  {"$P_PROGPATH", 0, 0, not_modelled, false, "LIS1, program path"},
  {"$P_SUBPAR", 0, 0, parameter_given, false, "LIS1, whether a parameter was passed"},
  {"$P_AXN1", 0, 0, constant, false, "LIS1, first geometry axis"},
  {"$P_AXN2", 1, 1, constant, false, "LIS1, second geometry axis"},
  {"$P_AXN3", 2, 2, constant, false, "LIS1, third geometry axis"},
  {"$P_SIM", 0, 0, not_modelled, false, "LIS1, simulation runs"},
  {"$P_ISTEST", 0, 0, not_modelled, false, "LIS1, program test"},
  {"$P_DRYRUN", 0, 0, not_modelled, false, "LIS1, dry run feed"},
  {"$P_SEARCH", 0, 0, not_modelled, false, "LIS1, block search runs"},
  // actual values
  {"$AA_IW", 0, 0, end_position, false, "LIS1, actual position in work coordinates: the programmed one here"},
  {"$AA_IM", 0, 0, machine_position, false, "LIS1, actual position in machine coordinates"},
  {"$AA_IB", 0, 0, not_modelled, false, "LIS1, actual position in basic coordinates"},
  {"$AA_MW", 0, 0, skip_position, false, "LIS1, measured position in work coordinates"},
  {"$AA_MM", 0, 0, not_modelled, false, "LIS1, measured position in machine coordinates"},
  {"$AA_S", 0, 0, not_modelled, false, "LIS1, actual spindle speed"},
  {"$AC_MEA", 0, 0, not_modelled, false, "LIS1, probe has switched"},
  {"$AC_TIMER", 0, 0, changing, true, "LIS1, timer in seconds", false, 0, memory},
  {"$AC_TIME", 0, 0, changing, false, "LIS1, time since block start"},
  {"$AC_MARKER", 0, 0, not_modelled, true, "LIS1, marker", false, 0, memory},
  {"$AC_PARAM", 0, 0, not_modelled, true, "LIS1, parameter of synchronized actions", false, 0, memory},
  {"$AC_TOTAL_PARTS", 0, 0, changing, true, "LIS1, part counter"},
  {"$AC_REQUIRED_PARTS", 0, 0, not_modelled, true, "LIS1, part counter"},
  {"$AC_ACTUAL_PARTS", 0, 0, changing, true, "LIS1, part counter"},
  {"$AC_SPECIAL_PARTS", 0, 0, changing, true, "LIS1, part counter"},
  {"$AC_OPERATING_TIME", 0, 0, changing, true, "LIS1, run time of programs"},
  {"$AC_CYCLE_TIME", 0, 0, changing, true, "LIS1, run time of the program"},
  {"$AC_CUTTING_TIME", 0, 0, changing, true, "LIS1, cutting time"},
  {"$AN_SETUP_TIME", 0, 0, changing, true, "LIS1, time since the control started with default values"},
  {"$AN_POWERON_TIME", 0, 0, changing, true, "LIS1, time since the control started"},
  // arguments of a macro that was called in ISO mode, by the local variable that holds them elsewhere
  {"$C_A", 1, 1, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_A_PROG", 1, 1, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_B", 2, 2, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_B_PROG", 2, 2, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_C", 3, 3, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_C_PROG", 3, 3, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_D", 7, 7, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_D_PROG", 7, 7, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_E", 8, 8, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_E_PROG", 8, 8, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_F", 9, 9, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_F_PROG", 9, 9, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_H", 11, 11, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_H_PROG", 11, 11, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_I", 4, 4, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_I_PROG", 4, 4, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_J", 5, 5, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_J_PROG", 5, 5, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_K", 6, 6, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_K_PROG", 6, 6, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_M", 13, 13, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_M_PROG", 13, 13, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_Q", 17, 17, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_Q_PROG", 17, 17, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_R", 18, 18, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_R_PROG", 18, 18, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_S", 19, 19, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_S_PROG", 19, 19, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_T", 20, 20, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_T_PROG", 20, 20, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_U", 21, 21, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_U_PROG", 21, 21, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_V", 22, 22, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_V_PROG", 22, 22, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_W", 23, 23, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_W_PROG", 23, 23, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_X", 24, 24, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_X_PROG", 24, 24, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_Y", 25, 25, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_Y_PROG", 25, 25, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_Z", 26, 26, call_argument, false, "Function Manual ISO Dialects, macro programs"},
  {"$C_Z_PROG", 26, 26, call_argument_given, false, "Function Manual ISO Dialects, macro programs"},
  // tools; wear ($TC_DP15) and what else is added to radius and length stays with the last row of the list
  {"$TC_DP1", 0, 0, tool_type, true, "LIS1, type of a cutting edge"},
  {"$TC_DP3", 0, 0, tool_length, true, "LIS1, length 1 of a cutting edge"},
  {"$TC_DP6", 0, 0, tool_radius, true, "LIS1, radius of a cutting edge"},
  // … of the tool in the spindle: to read only
  {"$P_TOOLR", 0, 0, tool_radius, false, "LIS1, active tool radius"},
  {"$P_TOOLL", 0, 0, tool_length, false, "LIS1, active tool length"},
  // inputs, outputs, PLC, clock
  {"$A_IN", 0, 0, not_modelled, false, "LIS1, digital input"},
  {"$A_OUT", 0, 0, not_modelled, true, "LIS1, digital output", false, 0, output},
  {"$A_INA", 0, 0, not_modelled, false, "LIS1, analog input"},
  {"$A_OUTA", 0, 0, not_modelled, true, "LIS1, analog output", false, 0, output},
  {"$A_DBB", 0, 0, changing, true, "LIS1, byte shared with the PLC", false, 0, output},
  {"$A_DBW", 0, 0, changing, true, "LIS1, word shared with the PLC", false, 0, output},
  {"$A_DBD", 0, 0, changing, true, "LIS1, double word shared with the PLC", false, 0, output},
  {"$A_DBR", 0, 0, changing, true, "LIS1, real shared with the PLC", false, 0, output},
  {"$A_YEAR", 0, 0, not_modelled, false, "LIS1, clock"},
  {"$A_MONTH", 0, 0, not_modelled, false, "LIS1, clock"},
  {"$A_DAY", 0, 0, not_modelled, false, "LIS1, clock"},
  {"$A_HOUR", 0, 0, not_modelled, false, "LIS1, clock"},
  {"$A_MINUTE", 0, 0, not_modelled, false, "LIS1, clock"},
  {"$A_SECOND", 0, 0, not_modelled, false, "LIS1, clock"},
  {"$A_MSECOND", 0, 0, not_modelled, false, "LIS1, clock"},
});
// clang-format on

constexpr std::string_view kHarmless[] = {
    "$AC_TIMER",
    "$AC_MARKER",
    "$AC_PARAM",
    "$AC_TOTAL_PARTS",
    "$AC_REQUIRED_PARTS",
    "$AC_ACTUAL_PARTS",
    "$AC_SPECIAL_PARTS",
    "$AC_CYCLE_TIME",
    "$AC_CUTTING_TIME",
    "$AC_OPERATING_TIME",
    "$AN_SETUP_TIME",
    "$AN_POWERON_TIME",
    "$A_OUT",
    "$A_OUTA",
    "$A_DBB",
    "$A_DBW",
    "$A_DBD",
    "$A_DBR",
    "$P_UIFR",
    "$P_IFRAME",
    "$P_PFRAME",
    "$P_BFRAME",
    "$P_UBFR",
    "$TC_DP1",
    "$TC_DP3",
    "$TC_DP6",
};

}  // namespace

std::span<const ir::SystemVariableRow> system_variables() {
  static const std::vector<ir::SystemVariableRow> rows = [] {
    std::vector<ir::SystemVariableRow> all(kVariables.begin(), kVariables.end());
    for (ir::SystemVariableRow& row : all) row.inert = is_harmless_to_write(row.name);
    for (const WordList& list : vocabulary()) {
      if (list.role != Role::foreign) continue;
      for (const std::string_view name : list.names) all.push_back({name, 0, 0, not_modelled, false, "PGA, functions"});
    }
    return all;
  }();
  return rows;
}

std::uint32_t find_system_variable(std::string_view name) {
  static const NameIndex index = index_of(system_variables(), [](const ir::SystemVariableRow& r) { return r.name; });
  const std::uint32_t found = index.find(name);
  return found == NameIndex::kNotFound ? 0 : found;
}

bool is_harmless_to_write(std::string_view name) {
  return std::ranges::any_of(kHarmless, [name](std::string_view harmless) { return same_name(name, harmless); });
}

}  // namespace dripfeed::sinumerik
