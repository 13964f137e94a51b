// The tables of this control: codes, variables, alarms, grammar. One row a fact; all spans live as long as the program.
#pragma once

#include <span>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/macro_b/grammar.h"

namespace dripfeed::haas {

std::span<const ir::CodeRow> g_codes(ir::MachineKind kind, ir::GSystem system);
std::span<const ir::CodeRow> m_codes();
std::span<const ir::SystemVariableRow> system_variables();
std::vector<ir::VariableRange> variable_ranges();
std::span<const ir::AlarmRow> alarms();
const macro_b::Grammar& grammar();

}  // namespace dripfeed::haas
