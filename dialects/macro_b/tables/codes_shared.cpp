// Codes that mills and lathes have alike, and the M codes that the controls know themselves.
#include <algorithm>
#include <array>

#include "dialects/ir/frame_use.h"
#include "dialects/ir/transformation_use.h"
#include "dialects/macro_b/tables/codes.h"

namespace dripfeed::macro_b {

namespace {

using ir::CodeRow;
using ir::Function;
using ir::ModalGroup;

constexpr std::string_view kList = "0i-F B-64604EN, G code list; Mazak and Mitsubishi alike";
constexpr std::string_view kMiscellaneous = "0i-F B-64604EN, auxiliary function (M function)";
constexpr std::string_view kInterrupt = "0i-F B-64604EN, interruption type custom macro";

// clang-format off
constexpr auto kShared = std::to_array<CodeRow>({
    {"G00", 0, Function::rapid, 0, ModalGroup::motion, kList},
    {"G01", 10, Function::linear, 0, ModalGroup::motion, kList},
    {"G02", 20, Function::arc_cw, 0, ModalGroup::motion, kList},
    {"G03", 30, Function::arc_ccw, 0, ModalGroup::motion, kList},
    {"G04", 40, Function::dwell, 0, ModalGroup::non_modal, kList},
    {"G04.1", 41, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G05", 50, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G05.1", 51, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G05.4", 54, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G07.1", 71, Function::transformation, ir::kCylinderByRotary, ModalGroup::other, kList},
    {"G08", 80, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G09", 90, Function::exact_stop_once, 0, ModalGroup::non_modal, kList},
    {"G10", 100, Function::data_input, 0, ModalGroup::non_modal, kList},
    {"G10.6", 106, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G10.9", 109, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G11", 110, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G12.1", 121, Function::transformation, ir::kFaceByRotary, ModalGroup::other, kList},
    {"G13.1", 131, Function::transformation, ir::kTransformationEnds, ModalGroup::other, kList},
    {"G17", 170, Function::plane_xy, 0, ModalGroup::plane, kList},
    {"G18", 180, Function::plane_zx, 0, ModalGroup::plane, kList},
    {"G19", 190, Function::plane_yz, 0, ModalGroup::plane, kList},
    {"G22", 220, Function::stroke_check, 0, ModalGroup::other, kList},
    {"G23", 230, Function::no_effect, 0, ModalGroup::other, kList},
    {"G25", 250, Function::no_effect, 0, ModalGroup::other, kList},
    {"G26", 260, Function::no_effect, 0, ModalGroup::other, kList},
    {"G27", 270, Function::approach, 0, ModalGroup::non_modal, kList},
    {"G28", 280, Function::reference_return, 1, ModalGroup::non_modal, kList},
    {"G29", 290, Function::leave_reference, 0, ModalGroup::non_modal, kList},
    {"G30", 300, Function::reference_return, 2, ModalGroup::non_modal, kList},
    {"G30.1", 301, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G31", 310, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G37", 370, Function::measure_tool, 0, ModalGroup::non_modal, kList},
    {"G40", 400, Function::comp_off, 0, ModalGroup::comp, kList},
    {"G41", 410, Function::comp_left, 0, ModalGroup::comp, kList},
    {"G42", 420, Function::comp_right, 0, ModalGroup::comp, kList},
    {"G43", 430, Function::length_offset_plus, 0, ModalGroup::length_offset, kList},
    {"G43.1", 431, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G43.4", 434, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G43.5", 435, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G44", 440, Function::length_offset_minus, 0, ModalGroup::length_offset, kList},
    {"G49", 490, Function::length_offset_off, 0, ModalGroup::length_offset, kList},
    {"G50.1", 501, Function::mirror, ir::kFrameEnds, ModalGroup::frame, kList},
    {"G51.1", 511, Function::mirror, ir::kFrameAboutPoint, ModalGroup::frame, kList},
    {"G52", 520, Function::local_shift, 0, ModalGroup::non_modal, kList},
    {"G53", 530, Function::machine_coordinates, 0, ModalGroup::non_modal, kList},
    {"G53.1", 531, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G54", 540, Function::work_offset, 1, ModalGroup::work_offset, kList},
    {"G54.1", 541, Function::extended_offset, 0, ModalGroup::work_offset, kList},
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
    {"G68.2", 682, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G69", 690, Function::no_effect, 0, ModalGroup::frame, kList},
    {"G80", 800, Function::cycle_off, 0, ModalGroup::cycle, kList},
    {"G92.1", 921, Function::set_coordinates, 1, ModalGroup::non_modal, kList},
    {"G96", 960, Function::surface_speed_on, 0, ModalGroup::surface_speed, kList},
    {"G97", 970, Function::surface_speed_off, 0, ModalGroup::surface_speed, kList},
    {"G107", 1070, Function::transformation, ir::kCylinderByRotary, ModalGroup::other, kList},
    {"G112", 1120, Function::transformation, ir::kFaceByRotary, ModalGroup::other, kList},
    {"G113", 1130, Function::transformation, ir::kTransformationEnds, ModalGroup::other, kList},
});
constexpr auto kM = std::to_array<CodeRow>({
    {"M00", 0, Function::program_stop, 0, ModalGroup::flow, kMiscellaneous},
    {"M01", 10, Function::optional_stop, 0, ModalGroup::flow, kMiscellaneous},
    {"M02", 20, Function::program_end, 0, ModalGroup::flow, kMiscellaneous},
    {"M03", 30, Function::spindle_cw, 0, ModalGroup::spindle, kMiscellaneous},
    {"M04", 40, Function::spindle_ccw, 0, ModalGroup::spindle, kMiscellaneous},
    {"M05", 50, Function::spindle_stop, 0, ModalGroup::spindle, kMiscellaneous},
    {"M06", 60, Function::tool_change, 0, ModalGroup::other, kMiscellaneous},
    {"M07", 70, Function::coolant_mist, 0, ModalGroup::coolant, kMiscellaneous},
    {"M08", 80, Function::coolant_flood, 0, ModalGroup::coolant, kMiscellaneous},
    {"M09", 90, Function::coolant_off, 0, ModalGroup::coolant, kMiscellaneous},
    {"M19", 190, Function::spindle_orient, 0, ModalGroup::spindle, kMiscellaneous},
    {"M30", 300, Function::program_end_rewind, 0, ModalGroup::flow, kMiscellaneous},
    {"M96", 960, Function::not_modelled, 0, ModalGroup::other, kInterrupt},
    {"M97", 970, Function::no_effect, 0, ModalGroup::other, kInterrupt},
    {"M99", 990, Function::subprogram_end, 0, ModalGroup::flow, kMiscellaneous},
});
// clang-format on
static_assert(std::ranges::is_sorted(kM, {}, &CodeRow::number10));

}  // namespace

std::span<const CodeRow> shared_g_codes() { return kShared; }
std::span<const CodeRow> m_codes() { return kM; }

}  // namespace dripfeed::macro_b
