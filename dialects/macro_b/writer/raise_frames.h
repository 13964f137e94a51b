// raise: TRANS, ROT, SCALE and MIRROR and what adds to them as G52 and the frames about a point (G68, G51, G51.1).
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// Changes `program`, which is still in the terms of its own control; what cannot be written is reported at its place.
std::vector<text::Diagnostic> raise_frames(ir::Program& program, const ir::Control& to);

}  // namespace dripfeed::macro_b
