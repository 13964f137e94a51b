// Which machine a text was written for, when nobody says.
#pragma once

#include <cstdint>
#include <span>

#include "dialects/ir/control.h"
#include "dialects/macro_b/grammar.h"
#include "dialects/text/source.h"

namespace dripfeed::macro_b {

using UsualControl = ir::Control (*)(ir::MachineKind kind, ir::GSystem system);

// Mill or lathe and its G-code system, by the first line that only one of them would have (listed in infer.cpp);
// Control::because_line is that line, 0 for the default, a mill. `mill_turn_codes`: ten times the numbers of G codes
// that only the dialect's mill-turn centers have.
ir::Control infer_control(const text::Source& source, const Grammar& grammar, UsualControl control,
                          std::span<const std::int32_t> mill_turn_codes = {});

}  // namespace dripfeed::macro_b
