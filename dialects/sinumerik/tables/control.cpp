// The usual 840D sl: tables, limits, semantics. What only the machine decides (power-on state, number of R parameters)
// is set to what is common and not said to be known.
#include "dialects/ir/control.h"

#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/alarms.h"
#include "dialects/sinumerik/tables/certainty.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/tables/system_variables.h"

namespace dripfeed::sinumerik {

namespace {

ir::Semantics semantics(bool lathe) {
  ir::Semantics s;
  s.has_vacant = false;
  s.unset_is_unknown = true;
  s.number_format = ir::NumberFormat::double_precision;
  s.comparison = ir::ComparisonMode::relative;
  s.relative_tolerance = 1e-12;
  s.round_half = ir::RoundHalf::up;
  s.round_up = ir::RoundUpMode::next_larger;
  s.atan_full_circle = false;
  s.asin_from_90_to_270 = false;
  s.integer_division_is_real = true;
  // 10 and 10. are the same in Siemens mode, on every machine.
  s.decimal_mode = ir::DecimalMode::calculator;
  s.decimal_mode_confirmed = true;
  s.incremental_letters_uvw = false;
  s.tool_word = ir::ToolWord::number;
  s.arc_radius_is_r = false;
  s.machine_move = ir::MachineMove::without_frames;
  s.dwell_p_is_ms = false;
  // MD21000 CIRCLE_ERROR_CONST and MD21010 CIRCLE_ERROR_FACTOR, of which the larger counts (Diagnostics Guide, alarm
  // 14040); their standard values from memory.
  s.arc_tolerance_mm = 0.01;
  s.arc_tolerance_factor = 0.001;
  // MD20150 GCODE_RESET_VALUES is the machine tool builder's; G1 and metric are the delivery state.
  s.power_on_known = false;
  s.power_on_motion = ir::Function::linear;
  s.power_on_plane = lathe ? ir::Function::plane_zx : ir::Function::plane_xy;
  s.power_on_unit = ir::Function::unit_mm;
  s.power_on_distance = ir::Function::absolute;
  s.power_on_feed = lathe ? ir::Function::feed_per_rev : ir::Function::feed_per_min;
  s.power_on_diameter = lathe ? ir::DiameterMode::diameter : ir::DiameterMode::radius;
  s.end_in_subprogram_returns = true;
  s.d_selects_edge = true;
  s.feed_code_ends_surface_speed = true;
  return s;
}

}  // namespace

ir::Control control(ir::MachineKind kind) {
  const bool lathe = kind != ir::MachineKind::mill;
  ir::Control c;
  c.dialect = "sinumerik-840d";
  c.title = "SINUMERIK 840D sl";
  c.kind = kind;
  c.axes = kind == ir::MachineKind::lathe ? "XZ" : kind == ir::MachineKind::mill ? "XYZ" : "XYZC";
  c.semantics = semantics(lathe);
  // PGA, user data: the definition files of Siemens, the machine tool builder, the user, and further ones.
  c.definition_files = {"SMAC", "MMAC", "UMAC", "SGUD", "MGUD", "UGUD", "PGUD",
                        "GUD4", "GUD5", "GUD6", "GUD7", "GUD8", "GUD9"};
  c.outside = open_faults();
  c.limits.block_length_bytes = 512;
  c.limits.digits = 0;  // none: constants are doubles
  c.limits.expression_nesting = 32;
  c.limits.loop_nesting = 16;
  c.limits.call_nesting = 16;
  c.limits.macro_nesting = 16;
  c.limits.name_length = 31;
  c.limits.linear_decimals = 3;
  // What all figures of that paper say together (tests/numeric/joint_cost_test.cpp), of an older and slower control.
  c.cost = {.block_ms = 0.782,
            .named_read_ms = 0.105,
            .named_write_ms = 0.105,
            .function_ms = 0.139,
            .jump_ms = 0.34,
            .call_ms = 52.64,
            .origin = "as an 810D, by G. Nikiel, Optimization of execution speed of the CNC parametric part programs"};
  c.g_codes = g_code_rows();
  c.m_codes = m_code_rows();
  c.system_variables = system_variables();
  c.alarms = alarms();
  // MD28050 MM_NUM_R_PARAM: 300 is usual on the 840D sl, 100 on the 810D.
  c.variables = {{ir::Bank::r, 0, 299, ir::VariableUse::permanent, true}};
  return c;
}

}  // namespace dripfeed::sinumerik
