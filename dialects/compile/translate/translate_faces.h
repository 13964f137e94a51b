// Polar and cylindrical interpolation (G12.1, G07.1) as TRANSMIT and TRACYL, and the reverse. The coordinate
// across is C there and Y here: on the face both in millimetres, on the circumference degrees there and millimetres
// here.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// What the other control would take otherwise is an error at its block.
std::vector<text::Diagnostic> translate_faces(ir::Program& program, const ir::Control& from, const ir::Control& to);

}  // namespace dripfeed::compile
