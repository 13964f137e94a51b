// The stages of a '#'-variable control from text to text, given its grammar and its ir::Control. A dialect whose tables
// say all that is its own needs nothing else.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/macro_b/grammar.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::macro_b {

// Lexes, parses and lowers. Never fails: what cannot be understood is a diagnostic and a Native statement. The tokens
// tile the text. Diagnostics are those of the syntax.
ir::ReadResult read(const text::Source& source, const ir::Control& control, const Grammar& grammar);
// All checks of check.h, in the order of the text.
std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery,
                                       const Grammar& grammar);
// A raised program: '%', O number, one block a line, '%'.
ir::PrintResult print(const ir::Program& program, const ir::Control& control, const Grammar& grammar);

}  // namespace dripfeed::macro_b
