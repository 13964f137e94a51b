// Where a program switches an output of the machine or writes to its PLC: what that does only the machine says.
#pragma once

#include "checks/finding.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::app {

// Adds each such variable once, with the first line that writes it. False when none is written.
bool list_outputs(const ir::Program& program, const ir::Control& control, checks::NotCheckedList& not_checked);

}  // namespace dripfeed::app
