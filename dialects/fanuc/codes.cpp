// G and M codes of Fanuc controls: the common ones are its own, since the others took them from there.
#include "dialects/macro_b/codes.h"

#include <array>

#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

std::span<const ir::CodeRow> mill_g_codes() {
  static const std::vector<ir::CodeRow> kMill =
      macro_b::join_codes({macro_b::shared_g_codes(), macro_b::mill_g_codes()});
  return kMill;
}

std::span<const ir::CodeRow> lathe_g_codes(ir::GSystem system) {
  static const auto table = [](ir::GSystem of) {
    return macro_b::join_codes({macro_b::shared_g_codes(), macro_b::lathe_g_codes(of)});
  };
  static const std::array<std::vector<ir::CodeRow>, 3> kLathe = {table(ir::GSystem::a), table(ir::GSystem::b),
                                                                 table(ir::GSystem::c)};
  return kLathe[static_cast<std::size_t>(system)];
}

std::span<const ir::CodeRow> m_codes() { return macro_b::m_codes(); }

}  // namespace dripfeed::fanuc
