// Numbers without a point of ISO mode, where they count least increments (MD10884): said in millimetres or inches and
// their feeds, as Siemens mode takes them.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// Of the statements of Program::foreign_parts. `from` is the control in Siemens mode, `iso` the same in ISO mode, `to`
// the one that errors name: where the unit or the kind of feed is not the same on all paths, or what a number counts is
// not known here.
std::vector<text::Diagnostic> translate_iso_increments(ir::Program& program, const ir::Control& from,
                                                       const ir::Control& iso, const ir::Control& to);

}  // namespace dripfeed::compile
