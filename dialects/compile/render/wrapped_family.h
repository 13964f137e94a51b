// A family that keeps a native program: its values go into constants of the program, and every other byte stays.
#pragma once

#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/render/render.h"
#include "dialects/family/bind.h"

namespace dripfeed::compile {

// What can be known of the targets without a machine: the program is read for the usual control of its language. Spans
// are in the family's source, as in all that follows.
std::vector<text::Diagnostic> target_faults(const family::Family& family);

// Renders for request.target, which speaks `dialect`. `out` holds what was found so far. As macro the program is kept;
// as explicit blocks it is run, and what cannot be verified is refused.
RenderResult render_wrapped(const RenderRequest& request, const Dialect& dialect, const family::BoundFamily& bound,
                            RenderResult out);

}  // namespace dripfeed::compile
