// Codes in which a Haas differs from the common lists. What mills a pocket, engraves, measures or tilts is known by
// name and not interpreted.
#include "dialects/macro_b/tables/codes.h"

#include <array>

#include "dialects/haas/tables.h"
#include "dialects/ir/cycle.h"
#include "dialects/ir/hole_pattern.h"

namespace dripfeed::haas {

namespace {

using ir::CodeRow;
using ir::drill_argument;
using ir::DrillCycle;
using ir::Function;
using ir::kDrillAlongZ;
using ir::ModalGroup;

constexpr std::string_view kList = "Haas NGC operator's manual, G codes";
constexpr std::string_view kMiscellaneous = "Haas NGC operator's manual, M codes";

// G110 to G129 are G154 P1 to P20, and have numbers from 101 on as those of G54.1 P.
constexpr std::int16_t kFirstExtended = 101;

// clang-format off
constexpr auto kAll = std::to_array<CodeRow>({
    {"G54.1", 541, Function::none, 0, ModalGroup::none, kList},  // is G154
    {"G100", 1000, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G101", 1010, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G103", 1030, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G107", 1070, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G110", 1100, Function::work_offset, kFirstExtended, ModalGroup::work_offset, kList},
    {"G111", 1110, Function::work_offset, kFirstExtended + 1, ModalGroup::work_offset, kList},
    {"G112", 1120, Function::work_offset, kFirstExtended + 2, ModalGroup::work_offset, kList},
    {"G113", 1130, Function::work_offset, kFirstExtended + 3, ModalGroup::work_offset, kList},
    {"G114", 1140, Function::work_offset, kFirstExtended + 4, ModalGroup::work_offset, kList},
    {"G115", 1150, Function::work_offset, kFirstExtended + 5, ModalGroup::work_offset, kList},
    {"G116", 1160, Function::work_offset, kFirstExtended + 6, ModalGroup::work_offset, kList},
    {"G117", 1170, Function::work_offset, kFirstExtended + 7, ModalGroup::work_offset, kList},
    {"G118", 1180, Function::work_offset, kFirstExtended + 8, ModalGroup::work_offset, kList},
    {"G119", 1190, Function::work_offset, kFirstExtended + 9, ModalGroup::work_offset, kList},
    {"G120", 1200, Function::work_offset, kFirstExtended + 10, ModalGroup::work_offset, kList},
    {"G121", 1210, Function::work_offset, kFirstExtended + 11, ModalGroup::work_offset, kList},
    {"G122", 1220, Function::work_offset, kFirstExtended + 12, ModalGroup::work_offset, kList},
    {"G123", 1230, Function::work_offset, kFirstExtended + 13, ModalGroup::work_offset, kList},
    {"G124", 1240, Function::work_offset, kFirstExtended + 14, ModalGroup::work_offset, kList},
    {"G125", 1250, Function::work_offset, kFirstExtended + 15, ModalGroup::work_offset, kList},
    {"G126", 1260, Function::work_offset, kFirstExtended + 16, ModalGroup::work_offset, kList},
    {"G127", 1270, Function::work_offset, kFirstExtended + 17, ModalGroup::work_offset, kList},
    {"G128", 1280, Function::work_offset, kFirstExtended + 18, ModalGroup::work_offset, kList},
    {"G129", 1290, Function::work_offset, kFirstExtended + 19, ModalGroup::work_offset, kList},
    {"G154", 1540, Function::extended_offset, 0, ModalGroup::work_offset, kList},
    {"G156", 1560, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G167", 1670, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G184", 1840, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G187", 1870, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G266", 2660, Function::not_modelled, 0, ModalGroup::non_modal, kList},
});
constexpr auto kMill = std::to_array<CodeRow>({
    {"G12", 120, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G13", 130, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G35", 350, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G36", 360, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G37", 370, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G47", 470, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G70", 700, Function::hole_pattern, ir::kHolesOnCircle, ModalGroup::non_modal, kList},
    {"G71", 710, Function::hole_pattern, ir::kHolesOnArc, ModalGroup::non_modal, kList},
    {"G72", 720, Function::hole_pattern, ir::kHolesOnLine, ModalGroup::non_modal, kList},
    {"G77", 770, Function::drill, drill_argument(DrillCycle::back_bore), ModalGroup::cycle, kList},
    {"G87", 870, Function::drill, drill_argument(DrillCycle::manual_out), ModalGroup::cycle, kList},
    {"G136", 1360, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G141", 1410, Function::not_modelled, 0, ModalGroup::comp, kList},
    {"G143", 1430, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G150", 1500, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G174", 1740, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G184", 1840, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G234", 2340, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G253", 2530, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G254", 2540, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G255", 2550, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G268", 2680, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G269", 2690, Function::not_modelled, 0, ModalGroup::frame, kList},
});
// A lathe's cycles say in one block what its relatives say in two.
constexpr auto kLathe = std::to_array<CodeRow>({
    {"G14", 140, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G15", 150, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G70", 700, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G71", 710, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G72", 720, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G73", 730, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G74", 740, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G75", 750, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G76", 760, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G81", 810, Function::drill, drill_argument(DrillCycle::drill, kDrillAlongZ), ModalGroup::cycle, kList},
    {"G82", 820, Function::drill, drill_argument(DrillCycle::drill_dwell, kDrillAlongZ), ModalGroup::cycle, kList},
    {"G85", 850, Function::drill, drill_argument(DrillCycle::feed_out, kDrillAlongZ), ModalGroup::cycle, kList},
    {"G86", 860, Function::drill, drill_argument(DrillCycle::stop_out, kDrillAlongZ), ModalGroup::cycle, kList},
    {"G87", 870, Function::drill, drill_argument(DrillCycle::manual_out, kDrillAlongZ), ModalGroup::cycle, kList},
    {"G88", 880, Function::drill, drill_argument(DrillCycle::manual_out, kDrillAlongZ), ModalGroup::cycle, kList},
    {"G89", 890, Function::drill, drill_argument(DrillCycle::feed_out_dwell, kDrillAlongZ), ModalGroup::cycle, kList},
    {"G95", 950, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G105", 1050, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G112", 1120, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G113", 1130, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G186", 1860, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G195", 1950, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G196", 1960, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G241", 2410, Function::drill, drill_argument(DrillCycle::drill, ir::kDrillAlongX), ModalGroup::cycle, kList},
    {"G242", 2420, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G243", 2430, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G245", 2450, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G246", 2460, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G249", 2490, Function::not_modelled, 0, ModalGroup::cycle, kList},
});
constexpr auto kM = std::to_array<CodeRow>({
    {"M16", 160, Function::tool_change, 0, ModalGroup::other, kMiscellaneous},
    {"M88", 880, Function::coolant_flood, 0, ModalGroup::coolant, kMiscellaneous},  // through the spindle
    {"M89", 890, Function::coolant_off, 0, ModalGroup::coolant, kMiscellaneous},
    {"M96", 960, Function::not_modelled, 0, ModalGroup::other, kMiscellaneous},  // a jump that an input decides
    {"M97", 970, Function::local_call, 0, ModalGroup::flow, kMiscellaneous},
});
// clang-format on

}  // namespace

std::span<const CodeRow> g_codes(ir::MachineKind kind, ir::GSystem) {
  static const macro_b::CodeLists kLists({.all = kAll, .mill = kMill, .lathe = kLathe, .mill_turn = {}});
  return kLists.of(kind, ir::GSystem::a);
}

std::span<const CodeRow> m_codes() {
  static const std::vector<CodeRow> kCodes = macro_b::join_codes({macro_b::m_codes(), kM});
  return kCodes;
}

}  // namespace dripfeed::haas
