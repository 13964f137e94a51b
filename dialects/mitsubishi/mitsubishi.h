// dialects/mitsubishi: Mitsubishi M70/M700V, M80 and M800. Only tables and limits are its own; the language is
// macro_b's.
#pragma once

#include "dialects/ir/control.h"
#include "dialects/macro_b/stages.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::mitsubishi {

// The usual control of that kind. `system` is the G-code series of lathes (#1037 cmdtyp: lists 2, 3 and 4 of lathes).
ir::Control control(ir::MachineKind kind, ir::GSystem system);
const macro_b::Grammar& grammar();

using Stages = macro_b::Stages<control, grammar>;

}  // namespace dripfeed::mitsubishi
