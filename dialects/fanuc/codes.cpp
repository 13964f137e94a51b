// G and M codes of Fanuc controls: the common ones are its own, since the others took them from there.
#include "dialects/macro_b/codes.h"

#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

std::span<const ir::CodeRow> g_codes(ir::MachineKind kind, ir::GSystem system) {
  static const macro_b::CodeLists kLists({});
  return kLists.of(kind, system);
}

std::span<const ir::CodeRow> m_codes() { return macro_b::m_codes(); }

}  // namespace dripfeed::fanuc
