// Codes that Mazak's EIA and Mitsubishi's M800/M80, which are of one family, have alike and Fanuc has not.
#include <array>

#include "dialects/macro_b/codes.h"

namespace dripfeed::macro_b {

namespace {

using ir::CodeRow;
using ir::Function;
using ir::ModalGroup;

constexpr std::string_view kList = "Mazak EIA/ISO and M800/M80 programming manuals, G code lists";

// clang-format off
constexpr auto kAll = std::to_array<CodeRow>({
    {"G02.1", 21, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G03.1", 31, Function::not_modelled, 0, ModalGroup::motion, kList},
    {"G05", 50, Function::no_effect, 0, ModalGroup::non_modal, kList},
    {"G61.1", 611, Function::continuous_path, 0, ModalGroup::exact_stop, kList},
    {"G61.2", 612, Function::continuous_path, 0, ModalGroup::exact_stop, kList},
});
// Hole patterns.
constexpr auto kMill = std::to_array<CodeRow>({
    {"G34", 340, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G35", 350, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G36", 360, Function::not_modelled, 0, ModalGroup::non_modal, kList},
    {"G37", 370, Function::measure_tool, 0, ModalGroup::non_modal, kList},
    {"G37.1", 371, Function::not_modelled, 0, ModalGroup::non_modal, kList},
});
// clang-format on

}  // namespace

std::span<const CodeRow> eia_g_codes() { return kAll; }
std::span<const CodeRow> eia_mill_g_codes() { return kMill; }

}  // namespace dripfeed::macro_b
