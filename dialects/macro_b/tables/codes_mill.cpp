// Codes that machining centers have and lathes have not, or have otherwise.
#include <array>

#include "dialects/ir/cycle.h"
#include "dialects/ir/frame_use.h"
#include "dialects/macro_b/tables/codes.h"

namespace dripfeed::macro_b {

namespace {

using ir::CodeRow;
using ir::drill_argument;
using ir::DrillCycle;
using ir::Function;
using ir::ModalGroup;

constexpr std::string_view kList = "0i-F B-64604EN-2, G code list; Mazak and Mitsubishi machining centers alike";

// clang-format off
constexpr auto kMill = std::to_array<CodeRow>({
    {"G02.2", 22, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G02.3", 23, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G02.4", 24, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G03.2", 32, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G03.3", 33, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G03.4", 34, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G06.2", 62, Function::nurbs, 0, ModalGroup::motion, kList},
    {"G07", 70, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G15", 150, Function::polar_words_off, 0, ModalGroup::other, kList},
    {"G16", 160, Function::polar_words_on, 0, ModalGroup::other, kList},
    {"G20", 200, Function::unit_inch, 0, ModalGroup::unit, kList},
    {"G21", 210, Function::unit_mm, 0, ModalGroup::unit, kList},
    {"G33", 330, Function::thread, 0, ModalGroup::motion, kList},
    {"G39", 390, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G40.1", 401, Function::no_effect, 0, ModalGroup::other, kList},
    {"G41.1", 411, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G41.2", 412, Function::not_modelled, 0, ModalGroup::comp, kList},
    {"G42.1", 421, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G42.2", 422, Function::not_modelled, 0, ModalGroup::comp, kList},
    {"G45", 450, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G46", 460, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G47", 470, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G48", 480, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G49.1", 491, Function::length_offset_off, 0, ModalGroup::length_offset, kList},
    {"G50", 500, Function::scale, ir::kFrameEnds, ModalGroup::frame, kList},
    {"G51", 510, Function::scale, ir::kFrameAboutPoint, ModalGroup::frame, kList},
    {"G60", 600, Function::approach, 0, ModalGroup::non_modal, kList},
    {"G62", 620, Function::no_effect, 0, ModalGroup::exact_stop, kList},
    {"G68", 680, Function::rotate, ir::kFrameAboutPoint, ModalGroup::frame, kList},
    {"G69", 690, Function::rotate, ir::kFrameEnds, ModalGroup::frame, kList},
    {"G73", 730, Function::drill, drill_argument(DrillCycle::chip_break), ModalGroup::cycle, kList},
    {"G74", 740, Function::drill, drill_argument(DrillCycle::tap_left), ModalGroup::cycle, kList},
    {"G76", 760, Function::drill, drill_argument(DrillCycle::fine_bore), ModalGroup::cycle, kList},
    {"G81", 810, Function::drill, drill_argument(DrillCycle::drill), ModalGroup::cycle, kList},
    {"G82", 820, Function::drill, drill_argument(DrillCycle::drill_dwell), ModalGroup::cycle, kList},
    {"G83", 830, Function::drill, drill_argument(DrillCycle::deep_hole), ModalGroup::cycle, kList},
    {"G84", 840, Function::drill, drill_argument(DrillCycle::tap_right), ModalGroup::cycle, kList},
    {"G84.2", 842, Function::drill, drill_argument(DrillCycle::tap_right), ModalGroup::cycle, kList},
    {"G84.3", 843, Function::drill, drill_argument(DrillCycle::tap_left), ModalGroup::cycle, kList},
    {"G85", 850, Function::drill, drill_argument(DrillCycle::feed_out), ModalGroup::cycle, kList},
    {"G86", 860, Function::drill, drill_argument(DrillCycle::stop_out), ModalGroup::cycle, kList},
    {"G87", 870, Function::drill, drill_argument(DrillCycle::back_bore), ModalGroup::cycle, kList},
    {"G88", 880, Function::drill, drill_argument(DrillCycle::manual_out), ModalGroup::cycle, kList},
    {"G89", 890, Function::drill, drill_argument(DrillCycle::feed_out_dwell), ModalGroup::cycle, kList},
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

}  // namespace

std::span<const CodeRow> mill_g_codes() { return kMill; }

}  // namespace dripfeed::macro_b
