// dialects/fanuc: Fanuc Custom Macro B as on 0i, 16i and 30i: the code and variable tables, the alarms, and the limits.
// What the '#'-variable controls share is macro_b's; what a program does when it runs is the interpreter's; nothing
// here knows a machine, a file or another dialect.
#pragma once

#include "dialects/ir/control.h"
#include "dialects/macro_b/stages.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::fanuc {

// The usual control of that kind: tables, variable ranges, limits and semantics of the 0i-F/30i generation. `system` is
// the G-code system of lathes (parameter 3401) and is ignored for mills.
ir::Control control(ir::MachineKind kind, ir::GSystem system);
const macro_b::Grammar& grammar();

using Stages = macro_b::Stages<control, grammar>;

}  // namespace dripfeed::fanuc
