// The usual Haas controls; a machine's profile overrides single fields.
#include "dialects/macro_b/tables/control.h"

#include "dialects/haas/haas.h"
#include "dialects/haas/tables.h"

namespace dripfeed::haas {

namespace {

constexpr ir::CostModel kCost = {.block_ms = 1.0,
                                 .number_read_ms = 0.1,
                                 .named_read_ms = 0.1,
                                 .operator_ms = 0.03,
                                 .function_ms = 0.15,
                                 .round_ms = 1.0,
                                 .origin = "NGC class"};

}  // namespace

const macro_b::Grammar& grammar() {
  static const macro_b::Grammar kGrammar = {.keywords = macro_b::common_keywords(),
                                            .packed_calls = false,
                                            .dwell_point_is_seconds = true,
                                            .then_may_lack = true,
                                            .variables_have_parts = true,
                                            .reference_alone_is_all_axes = true,
                                            .repeat_letter = 'L'};
  return kGrammar;
}

ir::Control control(ir::MachineKind kind, ir::GSystem) {
  const bool mill = kind == ir::MachineKind::mill;
  ir::Control c = macro_b::usual_control(kind, ir::GSystem::a,
                                         {.dialect = "haas",
                                          .title = mill ? "Haas NGC (mill)" : "Haas NGC (lathe)",
                                          .limits = {.call_nesting = 9, .macro_nesting = 9},
                                          .cost = kCost,
                                          .g_codes = g_codes(kind, ir::GSystem::a),
                                          .m_codes = m_codes(),
                                          .system_variables = system_variables(),
                                          .alarms = alarms(),
                                          .variables = variable_ranges()});
  c.semantics.machine_move = ir::MachineMove::programmed;  // by the motion in effect; from memory
  c.semantics.drill_r_from_initial = false;
  c.semantics.length_needs_code = mill;
  c.semantics.change_needs_code = mill;
  c.semantics.taps_are_rigid = true;
  return c;
}

}  // namespace dripfeed::haas
