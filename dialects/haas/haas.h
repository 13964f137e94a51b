// dialects/haas: Haas NGC controls (mills and lathes). Tables, limits and the few words that a Haas reads differently
// from its relatives are its own; the language is macro_b's.
#pragma once

#include "dialects/ir/control.h"
#include "dialects/macro_b/stages.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::haas {

// The usual control of that kind. A Haas lathe has one list of codes, which is G-code system A's; `system` is not
// asked.
ir::Control control(ir::MachineKind kind, ir::GSystem system);
const macro_b::Grammar& grammar();

using Stages = macro_b::Stages<control, grammar>;

}  // namespace dripfeed::haas
