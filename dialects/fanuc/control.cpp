// The usual controls: what the parameters are at most machines. A machine's profile overrides single fields.
#include "dialects/macro_b/tables/control.h"

#include "dialects/fanuc/fanuc.h"
#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

namespace {

// Block time of a control of this class with look-ahead (1 to 2 ms); the rest is scaled after the measured constants of
// another control and marked as not measured.
constexpr ir::CostModel kCost = {.block_ms = 2.0,
                                 .number_read_ms = 0.2,
                                 .named_read_ms = 0.2,
                                 .operator_ms = 0.05,
                                 .function_ms = 0.3,
                                 .round_ms = 2.0,
                                 .origin = "0i class"};

}  // namespace

const macro_b::Grammar& grammar() {
  static const macro_b::Grammar kGrammar = {.keywords = macro_b::common_keywords(),
                                            .named_variables = named_variables()};
  return kGrammar;
}

ir::Control control(ir::MachineKind kind, ir::GSystem system) {
  const bool mill = kind == ir::MachineKind::mill;
  ir::Control c = macro_b::usual_control(kind, system,
                                         {.dialect = "fanuc",
                                          .title = mill ? "Fanuc 0i-MF" : "Fanuc 0i-TF",
                                          .limits = {.call_nesting = 10, .macro_nesting = 5},
                                          .cost = kCost,
                                          .g_codes = g_codes(kind, system),
                                          .m_codes = m_codes(),
                                          .system_variables = system_variables(),
                                          .alarms = alarms(),
                                          .variables = variable_ranges()});
  c.semantics.user_alarm_base = 3000;
  c.semantics.arc_without_center_is_line = true;
  c.semantics.pecks_need_depth = mill;  // a lathe's G83 without Q drills in one
  c.semantics.length_needs_code = mill;
  c.semantics.g54_takes_p = true;
  c.semantics.rigid_tap = ir::RigidTap::m29;
  return c;
}

}  // namespace dripfeed::fanuc
