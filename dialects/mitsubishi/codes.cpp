// G codes in which Mitsubishi differs from the common lists.
#include "dialects/macro_b/codes.h"

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
    {"G02.1", 21, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G03.1", 31, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G05", 50, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G06.2", 62, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G31.1", 311, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G31.2", 312, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G31.3", 313, Function::skip_move, 0, ModalGroup::non_modal, kList},
    {"G54.4", 544, Function::not_modelled, 0, ModalGroup::frame, kList},
    {"G61.1", 611, Function::continuous_path, 0, ModalGroup::exact_stop, kList},
    {"G61.2", 612, Function::continuous_path, 0, ModalGroup::exact_stop, kList},
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
    {"G34", 340, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G35", 350, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G36", 360, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G37", 370, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G37.1", 371, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G38", 380, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G39", 390, Function::no_effect, 0, ModalGroup::non_modal, kList},
});
// clang-format on

}  // namespace

std::span<const CodeRow> g_codes(ir::MachineKind kind, ir::GSystem system) {
  using macro_b::join_codes;
  static const std::vector<CodeRow> kOfMills =
      join_codes({macro_b::shared_g_codes(), macro_b::mill_g_codes(), kOwn, kMill});
  static const auto lathe = [](ir::GSystem of) {
    return join_codes({macro_b::shared_g_codes(), macro_b::lathe_g_codes(of), kOwn});
  };
  static const std::array<std::vector<CodeRow>, 3> kOfLathes = {lathe(ir::GSystem::a), lathe(ir::GSystem::b),
                                                                lathe(ir::GSystem::c)};
  return kind == ir::MachineKind::mill ? kOfMills : kOfLathes[static_cast<std::size_t>(system)];
}

std::span<const CodeRow> m_codes() { return macro_b::m_codes(); }

}  // namespace dripfeed::mitsubishi
