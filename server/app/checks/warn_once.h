// What one thing outside the program decides in many places is a warning once.
#pragma once

#include <vector>

#include "dialects/text/diagnostic.h"

namespace dripfeed::app {

// Of the names that a definition file would settle, of the numbers that one setting of the machine reads, of both tape
// marks and of what is known to the control and not carried out, the first keeps its warning; the others stay as notes.
// Errors stay what they are, and so does a name that another one nearly spells.
void warn_once(std::vector<text::Diagnostic>& diagnostics);

}  // namespace dripfeed::app
