// Whether a called deep hole has strokes that a modal cycle of another control does not make: those grow less, dwell,
// have a feed of their own, count from the surface and not from the level above it, or are entered again at another
// distance than that control's parameters state.
#pragma once

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

bool has_own_pecks(const ir::Program& program, const ir::Call& call, const ir::Control& to);

}  // namespace dripfeed::compile
