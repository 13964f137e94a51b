// Faults in blocks that the control never reads.
#pragma once

#include <vector>

#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::facts {

// Errors in statements that are not `read` become warnings, with the reason: the control reads a block when a run comes
// to it. Structures that do not match are the whole program's.
void soften_unread(const ir::Program& program, const std::vector<bool>& read,
                   std::vector<text::Diagnostic>& diagnostics);

}  // namespace dripfeed::facts
