// Tools that a family calls by name: which numbers they are, and where a control calls them by name itself.
#pragma once

#include <vector>

#include "dialects/family/model.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// Gives the steps the numbers of the machine's profile. A name that it does not have is an error, at its step.
std::vector<text::Diagnostic> number_tools(family::Family& family, const ir::Control& control);

// In a program for that control, whose language knows names: T="NAME" in place of the number.
void name_tools(const family::Family& family, const ir::Control& control, ir::Program& program);

}  // namespace dripfeed::compile
