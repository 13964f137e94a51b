// dialects/mazak: Mazak EIA/ISO, the text programs of Matrix and Smooth controls (machining centers VCN, VTC, HCN;
// lathes QT, QTN; Integrex). Only tables and limits are its own; the language is macro_b's, since the control is of the
// Mitsubishi family. MAZATROL programs are binary and unknown here.
#pragma once

#include "dialects/ir/control.h"
#include "dialects/macro_b/stages.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::mazak {

// The usual control of that kind. `system` is the G-code series of lathes (T series A, B, C); an Integrex has one of
// its own.
ir::Control control(ir::MachineKind kind, ir::GSystem system);
const macro_b::Grammar& grammar();

using Stages = macro_b::Stages<control, grammar>;

}  // namespace dripfeed::mazak
