// What the '#'-variable controls have in common besides tables: the usual semantics by kind of machine.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"

namespace dripfeed::macro_b {

// What is each dialect's own.
struct ControlTables {
  std::string_view dialect;
  std::string_view title;
  ir::ControlLimits limits;
  ir::CostModel cost;
  std::span<const ir::CodeRow> g_codes;
  std::span<const ir::CodeRow> m_codes;
  std::span<const ir::SystemVariableRow> system_variables;
  std::span<const ir::AlarmRow> alarms;
  std::vector<ir::VariableRange> variables;
};

// With the usual axes and semantics of such a machine.
ir::Control usual_control(ir::MachineKind kind, ir::GSystem system, ControlTables tables);

}  // namespace dripfeed::macro_b
