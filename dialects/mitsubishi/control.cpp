// The usual Mitsubishi controls; a machine's profile overrides single fields.
#include "dialects/macro_b/tables/control.h"

#include "dialects/mitsubishi/mitsubishi.h"
#include "dialects/mitsubishi/tables.h"

namespace dripfeed::mitsubishi {

namespace {

// The published block rate of the M80 is 33.7 thousand blocks a minute; the rest is scaled after the measured constants
// of another control.
constexpr ir::CostModel kCost = {.block_ms = 1.78,
                                 .number_read_ms = 0.15,
                                 .named_read_ms = 0.15,
                                 .operator_ms = 0.04,
                                 .function_ms = 0.2,
                                 .round_ms = 1.78,
                                 .origin = "M80, 33.7 thousand blocks a minute"};

}  // namespace

const macro_b::Grammar& grammar() {
  static const macro_b::Grammar kGrammar = {.keywords = keywords(),
                                            .highest_loop_number = 127,
                                            .highest_block_number = 999'999,
                                            .macro_digits = 15,
                                            .condition_blocks = true,
                                            .drip_forbids_output = true,
                                            .bare_expressions = true,
                                            .packed_calls = false,
                                            .start_letter = 'H'};
  return kGrammar;
}

ir::Control control(ir::MachineKind kind, ir::GSystem system) {
  ir::Control c = macro_b::usual_control(
      kind, system,
      {.dialect = "mitsubishi-m80",
       .title = kind == ir::MachineKind::mill ? "Mitsubishi M80 (machining center)" : "Mitsubishi M80 (lathe)",
       .limits = {.block_length_bytes = 256,
                  .loop_nesting = 27,
                  .condition_nesting = 10,
                  .call_nesting = 10,
                  .name_length = 32},
       .cost = kCost,
       .g_codes = g_codes(kind, system),
       .m_codes = m_codes(),
       .system_variables = system_variables(),
       .alarms = alarms(),
       .variables = variable_ranges()});
  c.semantics.machine_move = ir::MachineMove::programmed;
  c.semantics.scale_unit = 1e-6;
  c.semantics.scale_unit_known = true;
  c.semantics.length_needs_code = kind == ir::MachineKind::mill;
  c.semantics.rigid_tap = ir::RigidTap::comma_r;
  return c;
}

}  // namespace dripfeed::mitsubishi
