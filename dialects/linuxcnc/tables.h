// The tables of this control. One row a fact; all spans live as long as the program.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/expression.h"
#include "dialects/ir/statement.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::linuxcnc {

std::span<const ir::CodeRow> g_codes();
std::span<const ir::CodeRow> m_codes();
std::span<const ir::SystemVariableRow> system_variables();
std::vector<ir::VariableRange> variable_ranges();
const macro_b::Grammar& grammar();

// No row of the control's table: what only the control knows is read by its name.
inline constexpr std::uint32_t kOnlyTheControlKnows = ir::kNoIndex;
// The number of the parameter that a name of the control's own stands for (#<_x> is #5420); 0: the name is the
// program's.
std::uint32_t predefined(std::string_view name);

}  // namespace dripfeed::linuxcnc
