// Codes of lathes: those of every G-code system (parameter 3401), and for each system the rest. Single cycles (G90 of
// system A) are modal like motions, multiple repetitive cycles (G71) are not.
#include <array>

#include "dialects/ir/cycle.h"
#include "dialects/ir/frame_use.h"
#include "dialects/macro_b/tables/codes.h"

namespace dripfeed::macro_b {

namespace {

using ir::argument_of;
using ir::CodeRow;
using ir::drill_argument;
using ir::DrillCycle;
using ir::Function;
using ir::ModalGroup;
using ir::RepetitiveCycle;
using ir::TurningCycle;

constexpr std::string_view kList = "0i-F B-64604EN-1, G code list; Mazak and Mitsubishi lathe lists alike";

// clang-format off
constexpr auto kLathe = std::to_array<CodeRow>({
    {"G34", 340, Function::thread_changing, 0, ModalGroup::motion, kList},
    {"G36", 360, Function::measure_tool, 1, ModalGroup::non_modal, kList},
    {"G37.1", 371, Function::measure_tool, 2, ModalGroup::non_modal, kList},
    {"G37.2", 372, Function::measure_tool, 3, ModalGroup::non_modal, kList},
    {"G43.7", 437, Function::length_offset_plus, 0, ModalGroup::length_offset, kList},
    {"G50.2", 502, Function::no_effect, 0, ModalGroup::other, kList},
    {"G50.3", 503, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G51.2", 512, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G68.1", 681, Function::rotate, ir::kFrameAboutPoint, ModalGroup::frame, kList},
    {"G69.1", 691, Function::rotate, ir::kFrameEnds, ModalGroup::frame, kList},
    {"G83", 830, Function::drill, drill_argument(DrillCycle::deep_hole, ir::kDrillAlongZ), ModalGroup::cycle, kList},
    {"G84", 840, Function::drill, drill_argument(DrillCycle::tap_right, ir::kDrillAlongZ), ModalGroup::cycle, kList},
    {"G84.2", 842, Function::drill, drill_argument(DrillCycle::tap_right, ir::kDrillAlongZ), ModalGroup::cycle, kList},
    {"G85", 850, Function::drill, drill_argument(DrillCycle::feed_out_dwell, ir::kDrillAlongZ), ModalGroup::cycle, kList},
    {"G87", 870, Function::drill, drill_argument(DrillCycle::deep_hole, ir::kDrillAlongX), ModalGroup::cycle, kList},
    {"G87.5", 875, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G87.6", 876, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G88", 880, Function::drill, drill_argument(DrillCycle::tap_right, ir::kDrillAlongX), ModalGroup::cycle, kList},
    {"G88.2", 882, Function::drill, drill_argument(DrillCycle::tap_right, ir::kDrillAlongX), ModalGroup::cycle, kList},
    {"G89", 890, Function::drill, drill_argument(DrillCycle::feed_out_dwell, ir::kDrillAlongX), ModalGroup::cycle, kList},
    {"G250", 2500, Function::no_effect, 0, ModalGroup::other, kList},
    {"G251", 2510, Function::not_modelled, 0, ModalGroup::other, kList},
});
constexpr auto kSystemA = std::to_array<CodeRow>({
    {"G32", 320, Function::thread, 0, ModalGroup::motion, kList},
    {"G50", 500, Function::set_coordinates, 0, ModalGroup::non_modal, kList},
    {"G90", 900, Function::turning_cycle, argument_of(TurningCycle::along_z), ModalGroup::motion, kList},
    {"G92", 920, Function::turning_cycle, argument_of(TurningCycle::thread), ModalGroup::motion, kList},
    {"G94", 940, Function::turning_cycle, argument_of(TurningCycle::along_x), ModalGroup::motion, kList},
    {"G98", 980, Function::feed_per_min, 0, ModalGroup::feed, kList},
    {"G99", 990, Function::feed_per_rev, 0, ModalGroup::feed, kList},
});
constexpr auto kSystemsAB = std::to_array<CodeRow>({
    {"G20", 200, Function::unit_inch, 0, ModalGroup::unit, kList},
    {"G21", 210, Function::unit_mm, 0, ModalGroup::unit, kList},
    {"G70", 700, Function::repetitive_cycle, argument_of(RepetitiveCycle::finish), ModalGroup::non_modal, kList},
    {"G71", 710, Function::repetitive_cycle, argument_of(RepetitiveCycle::rough_along_z), ModalGroup::non_modal, kList},
    {"G72", 720, Function::repetitive_cycle, argument_of(RepetitiveCycle::rough_along_x), ModalGroup::non_modal, kList},
    {"G73", 730, Function::repetitive_cycle, argument_of(RepetitiveCycle::pattern), ModalGroup::non_modal, kList},
    {"G74", 740, Function::repetitive_cycle, argument_of(RepetitiveCycle::peck_z), ModalGroup::non_modal, kList},
    {"G75", 750, Function::repetitive_cycle, argument_of(RepetitiveCycle::peck_x), ModalGroup::non_modal, kList},
    {"G76", 760, Function::repetitive_cycle, argument_of(RepetitiveCycle::thread), ModalGroup::non_modal, kList},
});
constexpr auto kSystemB = std::to_array<CodeRow>({
    {"G77", 770, Function::turning_cycle, argument_of(TurningCycle::along_z), ModalGroup::motion, kList},
    {"G78", 780, Function::turning_cycle, argument_of(TurningCycle::thread), ModalGroup::motion, kList},
    {"G79", 790, Function::turning_cycle, argument_of(TurningCycle::along_x), ModalGroup::motion, kList},
});
constexpr auto kSystemsBC = std::to_array<CodeRow>({
    {"G33", 330, Function::thread, 0, ModalGroup::motion, kList},
    {"G50", 500, Function::scale, ir::kFrameEnds, ModalGroup::frame, kList},
    {"G51", 510, Function::scale, ir::kFrameAboutPoint, ModalGroup::frame, kList},
    {"G90", 900, Function::absolute, 0, ModalGroup::distance, kList},
    {"G91", 910, Function::incremental, 0, ModalGroup::distance, kList},
    {"G92", 920, Function::set_coordinates, 0, ModalGroup::non_modal, kList},
    {"G93", 930, Function::feed_inverse_time, 0, ModalGroup::feed, kList},
    {"G94", 940, Function::feed_per_min, 0, ModalGroup::feed, kList},
    {"G95", 950, Function::feed_per_rev, 0, ModalGroup::feed, kList},
    {"G98", 980, Function::return_to_initial, 0, ModalGroup::return_level, kList},
    {"G99", 990, Function::return_to_r, 0, ModalGroup::return_level, kList},
});
constexpr auto kSystemC = std::to_array<CodeRow>({
    {"G20", 200, Function::turning_cycle, argument_of(TurningCycle::along_z), ModalGroup::motion, kList},
    {"G21", 210, Function::turning_cycle, argument_of(TurningCycle::thread), ModalGroup::motion, kList},
    {"G24", 240, Function::turning_cycle, argument_of(TurningCycle::along_x), ModalGroup::motion, kList},
    {"G70", 700, Function::unit_inch, 0, ModalGroup::unit, kList},
    {"G71", 710, Function::unit_mm, 0, ModalGroup::unit, kList},
    {"G72", 720, Function::repetitive_cycle, argument_of(RepetitiveCycle::finish), ModalGroup::non_modal, kList},
    {"G73", 730, Function::repetitive_cycle, argument_of(RepetitiveCycle::rough_along_z), ModalGroup::non_modal, kList},
    {"G74", 740, Function::repetitive_cycle, argument_of(RepetitiveCycle::rough_along_x), ModalGroup::non_modal, kList},
    {"G75", 750, Function::repetitive_cycle, argument_of(RepetitiveCycle::pattern), ModalGroup::non_modal, kList},
    {"G76", 760, Function::repetitive_cycle, argument_of(RepetitiveCycle::peck_z), ModalGroup::non_modal, kList},
    {"G77", 770, Function::repetitive_cycle, argument_of(RepetitiveCycle::peck_x), ModalGroup::non_modal, kList},
    {"G78", 780, Function::repetitive_cycle, argument_of(RepetitiveCycle::thread), ModalGroup::non_modal, kList},
});
// clang-format on

}  // namespace

std::vector<CodeRow> lathe_g_codes(ir::GSystem system) {
  switch (system) {
    case ir::GSystem::a: return join_codes({kLathe, kSystemsAB, kSystemA});
    case ir::GSystem::b: return join_codes({kLathe, kSystemsAB, kSystemsBC, kSystemB});
    case ir::GSystem::c: return join_codes({kLathe, kSystemsBC, kSystemC});
  }
  return {};
}

}  // namespace dripfeed::macro_b
