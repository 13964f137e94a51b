// Code tables of the '#'-variable controls as far as they agree. A control joins them with a table of its own, whose
// rows replace those of the same number.
#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/function.h"

namespace dripfeed::macro_b {

std::span<const ir::CodeRow> shared_g_codes();  // mills and lathes
std::span<const ir::CodeRow> mill_g_codes();    // next to the shared ones
std::vector<ir::CodeRow> lathe_g_codes(ir::GSystem system);
std::span<const ir::CodeRow> m_codes();
// What Mazak's EIA and Mitsubishi's M800/M80 have besides these and Fanuc has not or has otherwise.
std::span<const ir::CodeRow> eia_g_codes();
std::span<const ir::CodeRow> eia_mill_g_codes();

// One table sorted by number. A later table's row replaces an earlier one's; a row with Function::none takes it away.
std::vector<ir::CodeRow> join_codes(std::initializer_list<std::span<const ir::CodeRow>> tables);

// The rows of one control that are not the common ones.
struct OwnCodes {
  std::span<const ir::CodeRow> all;  // mills and lathes
  std::span<const ir::CodeRow> mill;
  std::span<const ir::CodeRow> lathe;
  std::span<const ir::CodeRow> mill_turn;  // a list of machining centers; empty: it has the lathe's
};

// The G codes of one control by kind of machine.
class CodeLists {
 public:
  explicit CodeLists(const OwnCodes& own);
  [[nodiscard]] std::span<const ir::CodeRow> of(ir::MachineKind kind, ir::GSystem system) const;

 private:
  std::vector<ir::CodeRow> mill_;
  std::vector<ir::CodeRow> mill_turn_;
  std::array<std::vector<ir::CodeRow>, 3> lathe_;  // by G-code system
};

}  // namespace dripfeed::macro_b
