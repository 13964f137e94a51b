// G codes of lathes: those that the three G-code systems share, and for each system (parameter 3401) the rest. Single
// cycles (G90 of system A) are modal like motions, multiple repetitive cycles (G71) are not.
#include <algorithm>
#include <array>

#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

namespace {

using ir::CodeRow;
using ir::Function;
using ir::ModalGroup;

constexpr std::string_view kList = "0i-F B-64604EN-1, G code list";

// clang-format off
constexpr auto kCommon = std::to_array<CodeRow>({
    {"G00", 0, Function::rapid, 0, ModalGroup::motion, kList},
    {"G01", 10, Function::linear, 0, ModalGroup::motion, kList},
    {"G02", 20, Function::arc_cw, 0, ModalGroup::motion, kList},
    {"G03", 30, Function::arc_ccw, 0, ModalGroup::motion, kList},
    {"G04", 40, Function::dwell, 0, ModalGroup::non_modal, kList},
    {"G04.1", 41, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G05", 50, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G05.1", 51, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G05.4", 54, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G07.1", 71, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G08", 80, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G09", 90, Function::exact_stop_once, 0, ModalGroup::non_modal, kList},
    {"G10", 100, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G10.6", 106, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G10.9", 109, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G11", 110, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G12.1", 121, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G13.1", 131, Function::no_effect, 0, ModalGroup::other, kList},
    {"G17", 170, Function::plane_xy, 0, ModalGroup::plane, kList},
    {"G18", 180, Function::plane_zx, 0, ModalGroup::plane, kList},
    {"G19", 190, Function::plane_yz, 0, ModalGroup::plane, kList},
    {"G22", 220, Function::no_effect, 0, ModalGroup::other, kList},
    {"G23", 230, Function::no_effect, 0, ModalGroup::other, kList},
    {"G25", 250, Function::no_effect, 0, ModalGroup::other, kList},
    {"G26", 260, Function::no_effect, 0, ModalGroup::other, kList},
    {"G27", 270, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G28", 280, Function::reference_return, 1, ModalGroup::non_modal, kList},
    {"G29", 290, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G30", 300, Function::reference_return, 2, ModalGroup::non_modal, kList},
    {"G30.1", 301, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G31", 310, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G34", 340, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G36", 360, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G37", 370, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G37.1", 371, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G37.2", 372, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G40", 400, Function::comp_off, 0, ModalGroup::comp, kList},
    {"G41", 410, Function::comp_left, 0, ModalGroup::comp, kList},
    {"G42", 420, Function::comp_right, 0, ModalGroup::comp, kList},
    {"G43", 430, Function::length_offset_plus, 0, ModalGroup::length_offset, kList},
    {"G43.1", 431, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G43.4", 434, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G43.5", 435, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G43.7", 437, Function::length_offset_plus, 0, ModalGroup::length_offset, kList},
    {"G44", 440, Function::length_offset_minus, 0, ModalGroup::length_offset, kList},
    {"G49", 490, Function::length_offset_off, 0, ModalGroup::length_offset, kList},
    {"G50.1", 501, Function::no_effect, 0, ModalGroup::frame, kList},
    {"G50.2", 502, Function::no_effect, 0, ModalGroup::other, kList},
    {"G50.3", 503, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G51.1", 511, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G51.2", 512, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G52", 520, Function::local_shift, 0, ModalGroup::non_modal, kList},
    {"G53", 530, Function::machine_coordinates, 0, ModalGroup::non_modal, kList},
    {"G53.1", 531, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G54", 540, Function::work_offset, 1, ModalGroup::work_offset, kList},
    {"G54.1", 541, Function::not_modelled, 0, ModalGroup::work_offset, kList},
    {"G54.2", 542, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G54.4", 544, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G55", 550, Function::work_offset, 2, ModalGroup::work_offset, kList},
    {"G56", 560, Function::work_offset, 3, ModalGroup::work_offset, kList},
    {"G57", 570, Function::work_offset, 4, ModalGroup::work_offset, kList},
    {"G58", 580, Function::work_offset, 5, ModalGroup::work_offset, kList},
    {"G59", 590, Function::work_offset, 6, ModalGroup::work_offset, kList},
    {"G61", 610, Function::exact_stop_mode, 0, ModalGroup::exact_stop, kList},
    {"G63", 630, Function::continuous_path, 0, ModalGroup::exact_stop, kList},
    {"G64", 640, Function::continuous_path, 0, ModalGroup::exact_stop, kList},
    {"G65", 650, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G66", 660, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G66.1", 661, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G67", 670, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G68", 680, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G68.1", 681, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G68.2", 682, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G69", 690, Function::no_effect, 0, ModalGroup::frame, kList},
    {"G69.1", 691, Function::no_effect, 0, ModalGroup::frame, kList},
    {"G80", 800, Function::cycle_off, 0, ModalGroup::cycle, kList},
    {"G83", 830, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G84", 840, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G84.2", 842, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G85", 850, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G87", 870, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G87.5", 875, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G87.6", 876, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G88", 880, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G88.2", 882, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G89", 890, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G92.1", 921, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G96", 960, Function::surface_speed_on, 0, ModalGroup::surface_speed, kList},
    {"G97", 970, Function::surface_speed_off, 0, ModalGroup::surface_speed, kList},
    {"G107", 1070, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G112", 1120, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G113", 1130, Function::no_effect, 0, ModalGroup::other, kList},
    {"G250", 2500, Function::no_effect, 0, ModalGroup::other, kList},
    {"G251", 2510, Function::not_modelled, 0, ModalGroup::other, kList},
});
constexpr auto kSystemA = std::to_array<CodeRow>({
    {"G20", 200, Function::unit_inch, 0, ModalGroup::unit, kList},
    {"G21", 210, Function::unit_mm, 0, ModalGroup::unit, kList},
    {"G32", 320, Function::thread, 0, ModalGroup::motion, kList},
    {"G50", 500, Function::set_coordinates, 0, ModalGroup::non_modal, kList},
    {"G70", 700, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G71", 710, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G72", 720, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G73", 730, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G74", 740, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G75", 750, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G76", 760, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G90", 900, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G92", 920, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G94", 940, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G98", 980, Function::feed_per_min, 0, ModalGroup::feed, kList},
    {"G99", 990, Function::feed_per_rev, 0, ModalGroup::feed, kList},
});
constexpr auto kSystemB = std::to_array<CodeRow>({
    {"G20", 200, Function::unit_inch, 0, ModalGroup::unit, kList},
    {"G21", 210, Function::unit_mm, 0, ModalGroup::unit, kList},
    {"G33", 330, Function::thread, 0, ModalGroup::motion, kList},
    {"G50", 500, Function::no_effect, 0, ModalGroup::frame, kList},
    {"G51", 510, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G70", 700, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G71", 710, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G72", 720, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G73", 730, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G74", 740, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G75", 750, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G76", 760, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G77", 770, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G78", 780, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G79", 790, Function::not_modelled, 0, ModalGroup::motion, kList},
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
    {"G20", 200, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G21", 210, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G24", 240, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G33", 330, Function::thread, 0, ModalGroup::motion, kList},
    {"G50", 500, Function::no_effect, 0, ModalGroup::frame, kList},
    {"G51", 510, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G70", 700, Function::unit_inch, 0, ModalGroup::unit, kList},
    {"G71", 710, Function::unit_mm, 0, ModalGroup::unit, kList},
    {"G72", 720, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G73", 730, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G74", 740, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G75", 750, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G76", 760, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G77", 770, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G78", 780, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G90", 900, Function::absolute, 0, ModalGroup::distance, kList},
    {"G91", 910, Function::incremental, 0, ModalGroup::distance, kList},
    {"G92", 920, Function::set_coordinates, 0, ModalGroup::non_modal, kList},
    {"G93", 930, Function::feed_inverse_time, 0, ModalGroup::feed, kList},
    {"G94", 940, Function::feed_per_min, 0, ModalGroup::feed, kList},
    {"G95", 950, Function::feed_per_rev, 0, ModalGroup::feed, kList},
    {"G98", 980, Function::return_to_initial, 0, ModalGroup::return_level, kList},
    {"G99", 990, Function::return_to_r, 0, ModalGroup::return_level, kList},
});
// clang-format on

template <std::size_t n>
constexpr auto joined(const std::array<CodeRow, n>& own) {
  std::array<CodeRow, kCommon.size() + n> all{};
  std::ranges::merge(kCommon, own, all.begin(), {}, &CodeRow::number10, &CodeRow::number10);
  return all;
}
constexpr auto kLatheA = joined(kSystemA);
constexpr auto kLatheB = joined(kSystemB);
constexpr auto kLatheC = joined(kSystemC);
static_assert(std::ranges::is_sorted(kLatheA, {}, &CodeRow::number10));
static_assert(std::ranges::is_sorted(kLatheB, {}, &CodeRow::number10));
static_assert(std::ranges::is_sorted(kLatheC, {}, &CodeRow::number10));

}  // namespace

std::span<const CodeRow> lathe_g_codes(ir::GSystem system) {
  switch (system) {
    case ir::GSystem::a: return kLatheA;
    case ir::GSystem::b: return kLatheB;
    case ir::GSystem::c: return kLatheC;
  }
  return {};
}

}  // namespace dripfeed::fanuc
