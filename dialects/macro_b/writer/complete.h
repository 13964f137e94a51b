// raise: a program that was read with faults has expressions without operands and assignments without values. They are
// reported and filled in, so that the steps that follow need not ask.
#pragma once

#include <vector>

#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// One refusal a statement that is not whole.
std::vector<text::Diagnostic> complete_statements(ir::Program& program, const std::string& target);

}  // namespace dripfeed::macro_b
