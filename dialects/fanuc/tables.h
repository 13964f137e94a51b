// The tables of the Fanuc controls: codes, system variables, variable ranges, alarms. One row a fact; what reads them
// is elsewhere. All spans live as long as the program.
#pragma once

#include <span>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::fanuc {

std::span<const ir::CodeRow> g_codes(ir::MachineKind kind, ir::GSystem system);
std::span<const ir::CodeRow> m_codes();
std::span<const ir::SystemVariableRow> system_variables();
std::vector<ir::VariableRange> variable_ranges();
std::span<const macro_b::NamedVariable> named_variables();
std::span<const ir::AlarmRow> alarms();

}  // namespace dripfeed::fanuc
