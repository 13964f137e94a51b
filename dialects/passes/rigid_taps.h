// Tapping with the spindle turned by position: M29 before the cycle (Fanuc), ,R1 in it (Mitsubishi), a cycle of its own
// (Mazak G84.2, G84.3), the usual one of SINUMERIK (CYCLE84).
#pragma once

#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/passes/rewrite.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

// Says rigid taps as `to` says them. Between controls of one dialect nothing changes.
std::vector<text::Diagnostic> translate_taps(ir::Program& program, const ir::Control& from, const ir::Control& to);

// G84 or G74, of a lathe along either axis.
bool is_tap(const ir::Code& code);
// G63: one move of a tap in a compensating chuck.
bool is_floating_tap(const ir::Code& code);
// M29, where the control begins rigid taps so.
bool announces_rigid_tap(const ir::Code& code, const ir::Control& control);
// Whether a tapping cycle that is written so is a rigid one (G84.2, G88.2).
bool is_written_rigid(std::string_view written);

// Whether F of a rigid tap is its lead, whatever the feed mode is (,R1).
bool feeds_taps_by_lead(const ir::Control& control);

// A tapping cycle's code and words as `to` says that it is rigid; a block that must come before it goes to `out`.
void add_rigid(ir::Program& program, const ir::Control& to, ir::Code& tap, std::vector<ir::Word>& words, Rewrite& out);

}  // namespace dripfeed::passes
