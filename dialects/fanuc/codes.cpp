// G and M codes of Fanuc controls: the common ones are its own, since the others took them from there. Besides them
// stand options of the larger series (16i, 18i, 30i, 31i, 32i), which a 0i may lack.
#include "dialects/macro_b/tables/codes.h"

#include <array>

#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

namespace {

using ir::CodeRow;
using ir::Function;
using ir::ModalGroup;

constexpr std::string_view kList = "Series 30i operator's manual, G code list (options)";

// clang-format off
constexpr auto kOptions = std::to_array<CodeRow>({
    {"G02.1", 21, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G03.1", 31, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G12.4", 124, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G13.4", 134, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G17.1", 171, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G18.1", 181, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G19.1", 191, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G31.8", 318, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G31.9", 319, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G37.3", 373, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G41.3", 413, Function::not_modelled, 0, ModalGroup::comp, kList},
    {"G41.4", 414, Function::not_modelled, 0, ModalGroup::comp, kList},
    {"G41.5", 415, Function::not_modelled, 0, ModalGroup::comp, kList},
    {"G41.6", 416, Function::not_modelled, 0, ModalGroup::comp, kList},
    {"G42.4", 424, Function::not_modelled, 0, ModalGroup::comp, kList},
    {"G42.5", 425, Function::not_modelled, 0, ModalGroup::comp, kList},
    {"G42.6", 426, Function::not_modelled, 0, ModalGroup::comp, kList},
    {"G43.2", 432, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G43.3", 433, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G43.8", 438, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G43.9", 439, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G44.1", 441, Function::not_modelled, 0, ModalGroup::length_offset, kList},
    {"G44.9", 449, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G49.9", 499, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G50.4", 504, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G50.5", 505, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G50.6", 506, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G50.9", 509, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G51.3", 513, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G51.4", 514, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G51.5", 515, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G51.6", 516, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G51.9", 519, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G53.2", 532, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G53.3", 533, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G53.6", 536, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G54.3", 543, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G68.3", 683, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G68.4", 684, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G72.1", 721, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G72.2", 722, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G80.4", 804, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G80.5", 805, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G81.1", 811, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G81.4", 814, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G81.5", 815, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G91.1", 911, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G93.1", 931, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G93.2", 932, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G96.1", 961, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G96.2", 962, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G96.3", 963, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G96.4", 964, Function::not_modelled, 0, ModalGroup::non_modal, kList},
});
constexpr auto kLathe = std::to_array<CodeRow>({
    {"G35", 350, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G70.7", 707, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G71.7", 717, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G72.7", 727, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G73.7", 737, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G74.7", 747, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G75.7", 757, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G76.7", 767, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    // Drilling in the format of Series 15.
    {"G81", 810, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G82", 820, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G83.1", 831, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G83.5", 835, Function::not_modelled, 0, ModalGroup::cycle, kList},
    {"G83.6", 836, Function::not_modelled, 0, ModalGroup::cycle, kList},
});
// clang-format on

}  // namespace

std::span<const ir::CodeRow> g_codes(ir::MachineKind kind, ir::GSystem system) {
  static const macro_b::CodeLists kLists({.all = kOptions, .mill = {}, .lathe = kLathe, .mill_turn = {}});
  return kLists.of(kind, system);
}

std::span<const ir::CodeRow> m_codes() { return macro_b::m_codes(); }

}  // namespace dripfeed::fanuc
