// ISO parts in a program that is to be translated: their statements take the place of the text that the program keeps
// for them, in the terms of Siemens mode, and the program is one of Siemens mode from there on.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// Parts between G291 and G290, or calls of programs that begin in ISO mode.
bool uses_iso_mode(const ir::Program& program);

// `from` is the SINUMERIK that `program` was read for, `to` the control that it is translated for and that the errors
// name: at what acts from one language into the other. Statements keep their lines and spans; what is called is called
// by its name. Program::foreign_parts are then the statements that came from the parts: leads of threads are still F
// there, and T, D and H those of `to`.
std::vector<text::Diagnostic> splice_iso_parts(ir::Program& program, const ir::Control& from, const ir::Control& to);

}  // namespace dripfeed::compile
