// Codes that Mazak's EIA and Mitsubishi's M800/M80, which are of one family, have alike and Fanuc has not.
#include <array>

#include "dialects/ir/hole_pattern.h"
#include "dialects/macro_b/tables/codes.h"

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
constexpr std::string_view kPatterns =
    "M700V/M70V programming manual 13.2 (G34); the others from memory of the M800/M80 manual, special fixed cycles";
constexpr auto kMill = std::to_array<CodeRow>({
    {"G34", 340, Function::hole_pattern, ir::kHolesOnCircle, ModalGroup::non_modal, kPatterns},
    {"G35", 350, Function::hole_pattern, ir::kHolesOnLine, ModalGroup::non_modal, kPatterns},
    {"G36", 360, Function::hole_pattern, ir::kHolesOnArc, ModalGroup::non_modal, kPatterns},
    {"G37", 370, Function::measure_tool, 0, ModalGroup::non_modal, kList},
    {"G37.1", 371, Function::hole_pattern, ir::kHolesOnGrid, ModalGroup::non_modal, kPatterns},
});
// clang-format on

}  // namespace

std::span<const CodeRow> eia_g_codes() { return kAll; }
std::span<const CodeRow> eia_mill_g_codes() { return kMill; }

}  // namespace dripfeed::macro_b
