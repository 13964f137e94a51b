// What the parameters are at most machines. A machine's profile overrides single fields.
#include "dialects/macro_b/tables/control.h"

#include <utility>

namespace dripfeed::macro_b {

namespace {

ir::Semantics usual_semantics() {
  ir::Semantics s;
  s.number_format = ir::NumberFormat::double_precision;
  s.decimal_mode = ir::DecimalMode::least_increment;  // Fanuc 3401#0 = 0, Mitsubishi #1078 = 0
  s.arc_tolerance_mm = 0.02;
  s.return_in_main_restarts = true;
  return s;
}

ir::Semantics lathe_semantics(ir::GSystem system) {
  ir::Semantics s = usual_semantics();
  s.incremental_letters_uvw = system == ir::GSystem::a;
  s.tool_word = ir::ToolWord::number_and_offset;
  s.power_on_plane = ir::Function::plane_zx;
  s.power_on_feed = ir::Function::feed_per_rev;
  s.power_on_diameter = ir::DiameterMode::diameter;
  s.drill_r_from_initial = true;  // Fanuc 5102#6 = 0
  return s;
}

}  // namespace

ir::Control usual_control(ir::MachineKind kind, ir::GSystem system, ControlTables tables) {
  const bool mill = kind == ir::MachineKind::mill;
  ir::Control c;
  c.kind = kind;
  c.g_system = mill ? ir::GSystem::a : system;
  c.axes = mill ? "XYZ" : kind == ir::MachineKind::lathe ? "XZ" : "XYZC";
  c.semantics = mill ? usual_semantics() : lathe_semantics(system);
  c.dialect = tables.dialect;
  c.title = tables.title;
  c.limits = tables.limits;
  c.cost = tables.cost;
  c.g_codes = tables.g_codes;
  c.m_codes = tables.m_codes;
  c.system_variables = tables.system_variables;
  c.alarms = tables.alarms;
  c.variables = std::move(tables.variables);
  return c;
}

}  // namespace dripfeed::macro_b
