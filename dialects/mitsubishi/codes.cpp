// G codes in which Mitsubishi differs from the common lists.
#include "dialects/macro_b/tables/codes.h"

#include <array>

#include "dialects/mitsubishi/tables.h"

namespace dripfeed::mitsubishi {

namespace {

using ir::CodeRow;
using ir::Function;
using ir::ModalGroup;

constexpr std::string_view kList = "M800/M80 series programming manual, G code list";

// clang-format off
constexpr auto kOwn = std::to_array<CodeRow>({
    {"G06.2", 62, Function::nurbs, 0, ModalGroup::motion, kList},  // lathes, too
    {"G31.1", 311, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G31.2", 312, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G31.3", 313, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G110", 1100, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G111", 1110, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G113.1", 1131, Function::no_effect, 0, ModalGroup::other, kList},
    {"G114.1", 1141, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G114.2", 1142, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G114.3", 1143, Function::not_modelled, 0, ModalGroup::other, kList},
    {"G120.1", 1201, Function::no_effect, 0, ModalGroup::other, kList},
    {"G121", 1210, Function::no_effect, 0, ModalGroup::other, kList},
    {"G200", 2000, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G201", 2010, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G202", 2020, Function::not_modelled, 0, ModalGroup::non_modal, kList},
});
constexpr auto kMill = std::to_array<CodeRow>({
    {"G12", 120, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G13", 130, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G38", 380, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G39", 390, Function::not_modelled, 0, ModalGroup::non_modal, kList},
});
// clang-format on

}  // namespace

std::span<const CodeRow> g_codes(ir::MachineKind kind, ir::GSystem system) {
  static const std::vector<CodeRow> kAll = macro_b::join_codes({macro_b::eia_g_codes(), kOwn});
  static const std::vector<CodeRow> kOfMills = macro_b::join_codes({macro_b::eia_mill_g_codes(), kMill});
  static const macro_b::CodeLists kLists({.all = kAll, .mill = kOfMills, .lathe = {}, .mill_turn = {}});
  return kLists.of(kind, system);
}

std::span<const CodeRow> m_codes() { return macro_b::m_codes(); }

}  // namespace dripfeed::mitsubishi
