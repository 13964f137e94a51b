// What the '#'-variable controls have in common beside tables: the usual semantics by kind of machine.
#pragma once

#include "dialects/ir/control.h"

namespace dripfeed::macro_b {

// Kind, G-code system, axes and semantics; tables, limits and names are the dialect's to add.
ir::Control usual_control(ir::MachineKind kind, ir::GSystem system);

}  // namespace dripfeed::macro_b
