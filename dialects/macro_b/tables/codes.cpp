// Joining of tables.
#include "dialects/macro_b/tables/codes.h"

#include <algorithm>

namespace dripfeed::macro_b {

using ir::CodeRow;
using ir::Function;

std::vector<CodeRow> join_codes(std::initializer_list<std::span<const CodeRow>> tables) {
  std::vector<CodeRow> all;
  for (const std::span<const CodeRow> table : tables) all.insert(all.end(), table.begin(), table.end());
  std::ranges::stable_sort(all, {}, &CodeRow::number10);
  std::vector<CodeRow> joined;
  for (const CodeRow& row : all) {
    if (!joined.empty() && joined.back().number10 == row.number10) joined.pop_back();
    joined.push_back(row);
  }
  std::erase_if(joined, [](const CodeRow& row) { return row.function == Function::none; });
  return joined;
}

CodeLists::CodeLists(const OwnCodes& own) : mill_(join_codes({shared_g_codes(), mill_g_codes(), own.all, own.mill})) {
  if (!own.mill_turn.empty()) mill_turn_ = join_codes({shared_g_codes(), mill_g_codes(), own.all, own.mill_turn});
  for (const ir::GSystem system : {ir::GSystem::a, ir::GSystem::b, ir::GSystem::c})
    lathe_[static_cast<std::size_t>(system)] =
        join_codes({shared_g_codes(), lathe_g_codes(system), own.all, own.lathe});
}

std::span<const CodeRow> CodeLists::of(ir::MachineKind kind, ir::GSystem system) const {
  if (kind == ir::MachineKind::mill) return mill_;
  if (kind == ir::MachineKind::mill_turn && !mill_turn_.empty()) return mill_turn_;
  return lathe_[static_cast<std::size_t>(system)];
}

}  // namespace dripfeed::macro_b
