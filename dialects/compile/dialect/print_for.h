// Printing for a machine: a named one counts positions in increments that its profile states.
#pragma once

#include "dialects/compile/dialect/dialect.h"
#include "dialects/passes/round_positions.h"

namespace dripfeed::compile {

inline ir::PrintResult print_for(const Dialect& dialect, ir::Program& raised, const ir::Control& control) {
  if (control.from_profile) passes::round_positions(raised, control);
  return dialect.print(raised, control);
}

}  // namespace dripfeed::compile
