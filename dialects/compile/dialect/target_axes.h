// The axes of the control that a program is translated to.
#pragma once

#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// A control that no one described has the axes of its kind and those that the source's machine has.
std::string joint_axes(const ir::Control& to, const ir::Control& from);

// Errors: words that move an axis of `from` that `to` does not have.
std::vector<text::Diagnostic> foreign_axis_words(const ir::Program& program, const ir::Control& from,
                                                 const ir::Control& to);

}  // namespace dripfeed::compile
