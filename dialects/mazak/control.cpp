// The usual Mazak controls; a machine's profile overrides single fields.
#include "dialects/macro_b/tables/control.h"

#include <array>

#include "dialects/mazak/mazak.h"
#include "dialects/mazak/tables.h"

namespace dripfeed::mazak {

namespace {

constexpr ir::CostModel kCost = {.block_ms = 1.0,
                                 .number_read_ms = 0.1,
                                 .named_read_ms = 0.1,
                                 .operator_ms = 0.03,
                                 .function_ms = 0.15,
                                 .round_ms = 1.0,
                                 .origin = "Matrix 2, Smooth class"};

std::string_view title_of(ir::MachineKind kind) {
  if (kind == ir::MachineKind::mill) return "Mazak Smooth (machining center)";
  return kind == ir::MachineKind::lathe ? "Mazak Matrix 2 (QTN)" : "Mazak Matrix 2 (Integrex)";
}

// Ten times the codes that an Integrex has and the others have not.
constexpr auto kIntegrexCodes = std::to_array<std::int32_t>({1221, 1231, 2700, 2710, 2760, 2900, 2920, 2940});

}  // namespace

const macro_b::Grammar& grammar() {
  static const macro_b::Grammar kGrammar = {.keywords = macro_b::common_keywords(),
                                            .mill_turn_codes = kIntegrexCodes,
                                            .highest_loop_number = 127,
                                            .highest_block_number = 99'999,
                                            .macro_digits = 15,
                                            .condition_blocks = true,
                                            .drip_forbids_conditions = true,
                                            .drip_forbids_output = true,
                                            .packed_calls = false,
                                            .start_letter = 'Q',
                                            .long_tool_words = true,
                                            .second_tool_is_next = true};
  return kGrammar;
}

ir::Control control(ir::MachineKind kind, ir::GSystem system) {
  ir::Control c = macro_b::usual_control(
      kind, system,
      {.dialect = "mazak",
       .title = title_of(kind),
       .limits =
           {.block_length_bytes = 248, .loop_nesting = 27, .call_nesting = 8, .name_length = 32, .shape_blocks = 100},
       .cost = kCost,
       .g_codes = g_codes(kind, system),
       .m_codes = m_codes(),
       .system_variables = system_variables(),
       .alarms = alarms(),
       .variables = variable_ranges()});
  c.semantics.machine_move = ir::MachineMove::programmed;  // as its relative; from memory
  c.semantics.scale_unit = 1e-6;
  c.semantics.scale_unit_known = true;
  // #3000 = n: alarms 980 to 999 for n up to 20, 979 for all above.
  c.semantics.user_alarm_base = 979;
  c.semantics.highest_user_alarm = 20;
  // A mill-turn center's cycles and tools are those of machining centers: T1.01 M6, G43 H1.
  if (kind == ir::MachineKind::mill_turn) {
    c.semantics.incremental_letters_uvw = true;
    c.semantics.tool_word = ir::ToolWord::number;
    c.semantics.drill_r_from_initial = false;
    c.axes = "XYZBC";
  }
  c.semantics.tool_number_has_suffix = true;
  c.semantics.rigid_tap = ir::RigidTap::own_code;
  return c;
}

}  // namespace dripfeed::mazak
