// Codes. What measures, threads or turns by cycles is known by name and not interpreted.
#include <array>

#include "dialects/ir/clear_cycle.h"
#include "dialects/linuxcnc/tables.h"

namespace dripfeed::linuxcnc {

namespace {

using ir::CodeRow;
using ir::drill_argument;
using ir::DrillCycle;
using ir::Function;
using ir::ModalGroup;

constexpr std::string_view kList = "LinuxCNC user manual, G-codes";
constexpr std::string_view kMiscellaneous = "LinuxCNC user manual, M-codes";

constexpr std::int16_t cycle(DrillCycle form) { return drill_argument(form, ir::kDrillKeepsClear); }

// clang-format off
constexpr auto kG = std::to_array<CodeRow>({
    {"G0", 0, Function::rapid, 0, ModalGroup::motion, kList},
    {"G1", 10, Function::linear, 0, ModalGroup::motion, kList},
    {"G2", 20, Function::arc_cw, 0, ModalGroup::motion, kList},
    {"G3", 30, Function::arc_ccw, 0, ModalGroup::motion, kList},
    {"G4", 40, Function::dwell, 0, ModalGroup::non_modal, kList},
    {"G5", 50, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G5.1", 51, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G5.2", 52, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G5.3", 53, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G7", 70, Function::diameter_on, 0, ModalGroup::diameter, kList},
    {"G8", 80, Function::diameter_off, 0, ModalGroup::diameter, kList},
    {"G10", 100, Function::data_input, 0, ModalGroup::non_modal, kList},
    {"G17", 170, Function::plane_xy, 0, ModalGroup::plane, kList},
    {"G17.1", 171, Function::not_modelled, 0, ModalGroup::plane, kList},
    {"G18", 180, Function::plane_zx, 0, ModalGroup::plane, kList},
    {"G18.1", 181, Function::not_modelled, 0, ModalGroup::plane, kList},
    {"G19", 190, Function::plane_yz, 0, ModalGroup::plane, kList},
    {"G19.1", 191, Function::not_modelled, 0, ModalGroup::plane, kList},
    {"G20", 200, Function::unit_inch, 0, ModalGroup::unit, kList},
    {"G21", 210, Function::unit_mm, 0, ModalGroup::unit, kList},
    {"G28", 280, Function::reference_return, 1, ModalGroup::non_modal, kList},
    {"G28.1", 281, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G30", 300, Function::reference_return, 2, ModalGroup::non_modal, kList},
    {"G30.1", 301, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G33", 330, Function::thread, 0, ModalGroup::motion, kList},
    {"G33.1", 331, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G38.2", 382, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G38.3", 383, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G38.4", 384, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G38.5", 385, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G38.6", 386, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G40", 400, Function::comp_off, 0, ModalGroup::comp, kList},
    {"G41", 410, Function::comp_left, 0, ModalGroup::comp, kList},
    {"G41.1", 411, Function::comp_left, 0, ModalGroup::comp, kList},
    {"G42", 420, Function::comp_right, 0, ModalGroup::comp, kList},
    {"G42.1", 421, Function::comp_right, 0, ModalGroup::comp, kList},
    {"G43", 430, Function::length_offset_plus, 0, ModalGroup::length_offset, kList},
    {"G43.1", 431, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G43.2", 432, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G49", 490, Function::length_offset_off, 0, ModalGroup::length_offset, kList},
    {"G52", 520, Function::local_shift, 0, ModalGroup::non_modal, kList},
    {"G53", 530, Function::machine_coordinates, 0, ModalGroup::non_modal, kList},
    {"G54", 540, Function::work_offset, 1, ModalGroup::work_offset, kList},
    {"G55", 550, Function::work_offset, 2, ModalGroup::work_offset, kList},
    {"G56", 560, Function::work_offset, 3, ModalGroup::work_offset, kList},
    {"G57", 570, Function::work_offset, 4, ModalGroup::work_offset, kList},
    {"G58", 580, Function::work_offset, 5, ModalGroup::work_offset, kList},
    {"G59", 590, Function::work_offset, 6, ModalGroup::work_offset, kList},
    {"G59.1", 591, Function::work_offset, 7, ModalGroup::work_offset, kList},
    {"G59.2", 592, Function::work_offset, 8, ModalGroup::work_offset, kList},
    {"G59.3", 593, Function::work_offset, 9, ModalGroup::work_offset, kList},
    {"G61", 610, Function::exact_stop_mode, 0, ModalGroup::exact_stop, kList},
    {"G61.1", 611, Function::exact_stop_mode, 0, ModalGroup::exact_stop, kList},
    {"G64", 640, Function::continuous_path, 0, ModalGroup::exact_stop, kList},
    {"G70", 700, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G71", 710, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G71.1", 711, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G71.2", 712, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G72", 720, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G72.1", 721, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G72.2", 722, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G73", 730, Function::drill, cycle(DrillCycle::chip_break), ModalGroup::cycle, kList},
    {"G74", 740, Function::drill, cycle(DrillCycle::tap_left), ModalGroup::cycle, kList},
    {"G76", 760, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G80", 800, Function::cycle_off, 0, ModalGroup::cycle, kList},
    {"G81", 810, Function::drill, cycle(DrillCycle::drill), ModalGroup::cycle, kList},
    {"G82", 820, Function::drill, cycle(DrillCycle::drill_dwell), ModalGroup::cycle, kList},
    {"G83", 830, Function::drill, cycle(DrillCycle::deep_hole), ModalGroup::cycle, kList},
    {"G84", 840, Function::drill, cycle(DrillCycle::tap_right), ModalGroup::cycle, kList},
    {"G85", 850, Function::drill, cycle(DrillCycle::feed_out), ModalGroup::cycle, kList},
    {"G86", 860, Function::drill, cycle(DrillCycle::stop_out), ModalGroup::cycle, kList},
    {"G87", 870, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G88", 880, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G89", 890, Function::drill, cycle(DrillCycle::feed_out_dwell), ModalGroup::cycle, kList},
    {"G90", 900, Function::absolute, 0, ModalGroup::distance, kList},
    {"G90.1", 901, Function::no_effect, 0, ModalGroup::other, kList},
    {"G91", 910, Function::incremental, 0, ModalGroup::distance, kList},
    {"G91.1", 911, Function::no_effect, 0, ModalGroup::other, kList},
    {"G92", 920, Function::set_coordinates, 0, ModalGroup::non_modal, kList},
    {"G92.1", 921, Function::set_coordinates, 1, ModalGroup::non_modal, kList},
    {"G92.2", 922, Function::set_coordinates, 1, ModalGroup::non_modal, kList},
    {"G92.3", 923, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G93", 930, Function::feed_inverse_time, 0, ModalGroup::feed, kList},
    {"G94", 940, Function::feed_per_min, 0, ModalGroup::feed, kList},
    {"G95", 950, Function::feed_per_rev, 0, ModalGroup::feed, kList},
    {"G96", 960, Function::surface_speed_on, 0, ModalGroup::surface_speed, kList},
    {"G97", 970, Function::surface_speed_off, 0, ModalGroup::surface_speed, kList},
    {"G98", 980, Function::return_to_initial, 0, ModalGroup::return_level, kList},
    {"G99", 990, Function::return_to_r, 0, ModalGroup::return_level, kList},
});
constexpr auto kM = std::to_array<CodeRow>({
    {"M0", 0, Function::program_stop, 0, ModalGroup::flow, kMiscellaneous},
    {"M1", 10, Function::optional_stop, 0, ModalGroup::flow, kMiscellaneous},
    {"M2", 20, Function::program_end, 0, ModalGroup::flow, kMiscellaneous},
    {"M3", 30, Function::spindle_cw, 0, ModalGroup::spindle, kMiscellaneous},
    {"M4", 40, Function::spindle_ccw, 0, ModalGroup::spindle, kMiscellaneous},
    {"M5", 50, Function::spindle_stop, 0, ModalGroup::spindle, kMiscellaneous},
    {"M6", 60, Function::tool_change, 0, ModalGroup::other, kMiscellaneous},
    {"M7", 70, Function::coolant_mist, 0, ModalGroup::coolant, kMiscellaneous},
    {"M8", 80, Function::coolant_flood, 0, ModalGroup::coolant, kMiscellaneous},
    {"M9", 90, Function::coolant_off, 0, ModalGroup::coolant, kMiscellaneous},
    {"M19", 190, Function::spindle_orient, 0, ModalGroup::spindle, kMiscellaneous},
    {"M30", 300, Function::program_end_rewind, 0, ModalGroup::flow, kMiscellaneous},
    {"M48", 480, Function::no_effect, 0, ModalGroup::other, kMiscellaneous},
    {"M49", 490, Function::no_effect, 0, ModalGroup::other, kMiscellaneous},
    {"M50", 500, Function::no_effect, 0, ModalGroup::other, kMiscellaneous},
    {"M51", 510, Function::no_effect, 0, ModalGroup::other, kMiscellaneous},
    {"M52", 520, Function::no_effect, 0, ModalGroup::other, kMiscellaneous},
    {"M53", 530, Function::no_effect, 0, ModalGroup::other, kMiscellaneous},
    {"M60", 600, Function::program_stop, 0, ModalGroup::flow, kMiscellaneous},
    {"M61", 610, Function::not_modelled, 0, ModalGroup::other, kMiscellaneous},
    {"M62", 620, Function::not_modelled, 0, ModalGroup::other, kMiscellaneous},
    {"M63", 630, Function::not_modelled, 0, ModalGroup::other, kMiscellaneous},
    {"M64", 640, Function::not_modelled, 0, ModalGroup::other, kMiscellaneous},
    {"M65", 650, Function::not_modelled, 0, ModalGroup::other, kMiscellaneous},
    {"M66", 660, Function::not_modelled, 0, ModalGroup::other, kMiscellaneous},
    {"M67", 670, Function::not_modelled, 0, ModalGroup::other, kMiscellaneous},
    {"M68", 680, Function::not_modelled, 0, ModalGroup::other, kMiscellaneous},
    {"M70", 700, Function::no_effect, 0, ModalGroup::other, kMiscellaneous},
    {"M71", 710, Function::no_effect, 0, ModalGroup::other, kMiscellaneous},
    {"M72", 720, Function::not_modelled, 0, ModalGroup::other, kMiscellaneous},
    {"M73", 730, Function::not_modelled, 0, ModalGroup::other, kMiscellaneous},
    {"M99", 990, Function::subprogram_end, 0, ModalGroup::flow, kMiscellaneous},
});
// clang-format on

}  // namespace

std::span<const CodeRow> g_codes() { return kG; }
std::span<const CodeRow> m_codes() { return kM; }

}  // namespace dripfeed::linuxcnc
