// Code tables of the '#'-variable controls as far as they agree. A control joins them with a table of its own, whose
// rows replace those of the same number.
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/function.h"

namespace dripfeed::macro_b {

std::span<const ir::CodeRow> shared_g_codes();  // mills and lathes
std::span<const ir::CodeRow> mill_g_codes();    // beside the shared ones
std::vector<ir::CodeRow> lathe_g_codes(ir::GSystem system);
std::span<const ir::CodeRow> m_codes();

// One table sorted by number. A later table's row replaces an earlier one's; a row with Function::none takes it away.
std::vector<ir::CodeRow> join_codes(std::initializer_list<std::span<const ir::CodeRow>> tables);

}  // namespace dripfeed::macro_b
