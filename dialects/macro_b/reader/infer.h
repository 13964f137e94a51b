// Which machine a text was written for, when no one says.
#pragma once

#include "dialects/ir/control.h"
#include "dialects/macro_b/tables/grammar.h"
#include "dialects/text/source.h"

namespace dripfeed::macro_b {

using UsualControl = ir::Control (*)(ir::MachineKind kind, ir::GSystem system);

// Mill or lathe and its G-code system, by the first line that only one of them would have (listed in infer.cpp);
// Control::because_line is that line, 0 for the default, a mill.
ir::Control infer_control(const text::Source& source, const Grammar& grammar, UsualControl control);

}  // namespace dripfeed::macro_b
