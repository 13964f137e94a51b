// The tables of this control: codes, variables, alarms. One row a fact; all spans live as long as the program.
#pragma once

#include <span>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::mitsubishi {

std::span<const ir::CodeRow> g_codes(ir::MachineKind kind, ir::GSystem system);
std::span<const ir::CodeRow> m_codes();
std::span<const ir::SystemVariableRow> system_variables();
std::vector<ir::VariableRange> variable_ranges();
std::span<const ir::AlarmRow> alarms();
std::span<const macro_b::Keyword> keywords();

}  // namespace dripfeed::mitsubishi
