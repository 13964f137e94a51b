// Gives variables that the target control does not know a number that it has: names (DEF, the family language) and
// numbers of another bank (R5 on a '#' control). Numbers that the program uses already are never given again.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

// One variable, or an array of `count` consecutive ones, and where it went.
struct AllocatedVariable {
  ir::Bank from_bank = ir::Bank::named;
  ir::SymbolId symbol = ir::SymbolId::none;  // bank named
  std::uint32_t from_number = 0;             // banks hash and r
  std::uint32_t number = 0;                  // the first, in the bank that was asked for
  std::uint32_t count = 1;
};

struct AllocationReport {
  std::vector<AllocatedVariable> variables;
  std::vector<text::Diagnostic> diagnostics;  // not_enough_variables, refusals (strings, frames)
};

// What the program's surroundings ask for.
struct AllocationRules {
  // Numbers that symbols must get: those of parameters.
  std::map<ir::SymbolId, std::uint32_t> fixed;
  // Numbers that hold what other programs know as well: never given away.
  std::set<std::uint32_t> reserved = {};
  // Symbols that stay names.
  std::set<ir::SymbolId> kept;
  // The program calls others or is called. Names get local variables only, and a number of another bank is the same in
  // each program: counted through the common and permanent variables (R0 is #100, R100 is #500) that are not reserved.
  bool shares = false;
};

// Where a number of another bank lies in all programs that call each other; 0 where there is no room for it.
std::uint32_t shared_number(const ir::Control& to, ir::Bank bank, std::uint32_t number,
                            const std::set<std::uint32_t>& reserved);

// Rewrites every variable that is not of `bank` (system ones excepted) to a number of `bank` that `to` has and may
// write, common ones before permanent ones before local ones. Each gets a number of its own; only when there are too
// few, scalars whose live ranges do not meet share one. A number of another bank keeps its own, or one as far from the
// first common one, where that is free. With a computed number of another bank (R[R1]) all of that bank's user
// variables in `from` move as one range. DEF statements become assignments of their initial values (0 without one); the
// symbols stay for messages.
AllocationReport allocate_variables(ir::Program& program, const ir::Control& from, const ir::Control& to, ir::Bank bank,
                                    const AllocationRules& rules = {});

// Those of them that had a name, with numbers of `bank` now.
std::vector<ir::PlacedName> placed_names(const AllocationReport& report, ir::Bank bank);

}  // namespace dripfeed::passes
