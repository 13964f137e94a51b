// Blocks that no run comes to, as after the end of a program: the control reads a block when a run comes to it.
#pragma once

#include <vector>

#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// Errors in such blocks become warnings, with the reason.
void soften_unread(const ir::Program& program, std::vector<text::Diagnostic>& diagnostics);

}  // namespace dripfeed::macro_b
