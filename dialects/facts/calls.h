// Statements that call, and those that leave everything in effect as it is.
#pragma once

#include "dialects/ir/program.h"

namespace dripfeed::facts {

bool is_call(ir::StatementKind kind);
// Statements that neither move nor change a mode.
bool keeps_modes(ir::StatementKind kind);
// A call of a cycle of the control: it moves and leaves the modes as they were.
bool is_standard_cycle(const ir::Program& program, const ir::Statement& call);

}  // namespace dripfeed::facts
