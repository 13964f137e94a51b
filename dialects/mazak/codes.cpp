// G codes in which Mazak differs from the common lists, by kind of machine. A mill-turn center (Integrex) has the list
// of machining centers and turning cycles of its own numbers: G290 for G90, G271 for G71.
#include "dialects/macro_b/tables/codes.h"

#include <array>

#include "dialects/ir/cycle.h"
#include "dialects/ir/hole_pattern.h"
#include "dialects/mazak/tables.h"

namespace dripfeed::mazak {

namespace {

using ir::argument_of;
using ir::CodeRow;
using ir::drill_argument;
using ir::DrillCycle;
using ir::Function;
using ir::ModalGroup;
using ir::RepetitiveCycle;
using ir::TurningCycle;

constexpr std::string_view kList = "Mazak EIA/ISO programming manual, G code list";

// clang-format off
constexpr auto kOwn = std::to_array<CodeRow>({
    {"G06.1", 61, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G45.1", 451, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G50.2", 502, Function::no_effect, 0, ModalGroup::other, kList},
    {"G51.2", 512, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G52.5", 525, Function::not_modelled, 0, ModalGroup::work_offset, kList},
    {"G53.5", 535, Function::not_modelled, 0, ModalGroup::work_offset, kList},
    {"G61.4", 614, Function::continuous_path, 0, ModalGroup::exact_stop, kList},
    {"G68.5", 685, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G69.5", 695, Function::no_effect, 0, ModalGroup::frame, kList},
    {"G109", 1090, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G110", 1100, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G111", 1110, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G112", 1120, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G124", 1240, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G125", 1250, Function::no_effect, 0, ModalGroup::other, kList},
    {"G148", 1480, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G149", 1490, Function::no_effect, 0, ModalGroup::other, kList},
});
constexpr auto kMill = std::to_array<CodeRow>({
    {"G17.1", 171, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G17.2", 172, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G17.3", 173, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G17.4", 174, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G17.5", 175, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G17.6", 176, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G17.7", 177, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G17.8", 178, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G17.9", 179, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G34.1", 341, Function::hole_pattern, ir::kHolesOnCircle, ModalGroup::non_modal, kList},
    {"G71.1", 711, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G72.1", 721, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G75", 750, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G77", 770, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G78", 780, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G79", 790, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G82.2", 822, Function::drill, drill_argument(DrillCycle::chip_break), ModalGroup::cycle, kList},
});
constexpr auto kLathe = std::to_array<CodeRow>({
    {"G122.1", 1221, Function::diameter_off, 0, ModalGroup::diameter, kList},
    {"G123.1", 1231, Function::diameter_on, 0, ModalGroup::diameter, kList},
});
constexpr auto kMillTurn = std::to_array<CodeRow>({
    // Rotation on some, mirroring of a second turret or conversion in space on others.
    {"G68", 680, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G69", 690, Function::no_effect, 0, ModalGroup::frame, kList},
    {"G50", 500, Function::set_coordinates, 0, ModalGroup::non_modal, kList},
    {"G122.1", 1221, Function::diameter_off, 0, ModalGroup::diameter, kList},
    {"G123.1", 1231, Function::diameter_on, 0, ModalGroup::diameter, kList},
    {"G270", 2700, Function::repetitive_cycle, argument_of(RepetitiveCycle::finish), ModalGroup::non_modal, kList},
    {"G271", 2710, Function::repetitive_cycle, argument_of(RepetitiveCycle::rough_along_z), ModalGroup::non_modal, kList},
    {"G272", 2720, Function::repetitive_cycle, argument_of(RepetitiveCycle::rough_along_x), ModalGroup::non_modal, kList},
    {"G273", 2730, Function::repetitive_cycle, argument_of(RepetitiveCycle::pattern), ModalGroup::non_modal, kList},
    {"G274", 2740, Function::repetitive_cycle, argument_of(RepetitiveCycle::peck_z), ModalGroup::non_modal, kList},
    {"G275", 2750, Function::repetitive_cycle, argument_of(RepetitiveCycle::peck_x), ModalGroup::non_modal, kList},
    {"G276", 2760, Function::repetitive_cycle, argument_of(RepetitiveCycle::thread), ModalGroup::non_modal, kList},
    {"G290", 2900, Function::turning_cycle, argument_of(TurningCycle::along_z), ModalGroup::motion, kList},
    {"G292", 2920, Function::turning_cycle, argument_of(TurningCycle::thread), ModalGroup::motion, kList},
    {"G294", 2940, Function::turning_cycle, argument_of(TurningCycle::along_x), ModalGroup::motion, kList},
});
// clang-format on

}  // namespace

std::span<const CodeRow> g_codes(ir::MachineKind kind, ir::GSystem system) {
  static const std::vector<CodeRow> kAll = macro_b::join_codes({macro_b::eia_g_codes(), kOwn});
  static const std::vector<CodeRow> kOfMills = macro_b::join_codes({macro_b::eia_mill_g_codes(), kMill});
  static const macro_b::CodeLists kLists({.all = kAll, .mill = kOfMills, .lathe = kLathe, .mill_turn = kMillTurn});
  return kLists.of(kind, system);
}

std::span<const CodeRow> m_codes() { return macro_b::m_codes(); }

}  // namespace dripfeed::mazak
