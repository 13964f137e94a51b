// Tapping with the spindle turned by position: M29 before the cycle (Fanuc), ,R1 in it (Mitsubishi), a cycle of its own
// (Mazak G84.2, G84.3), the usual one of SINUMERIK (CYCLE84).
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

// Says rigid taps as `to` says them. Between controls of one dialect nothing changes.
std::vector<text::Diagnostic> settle_taps(ir::Program& program, const ir::Control& from, const ir::Control& to);

}  // namespace dripfeed::passes
