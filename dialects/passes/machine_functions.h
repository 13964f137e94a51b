// M codes that the machine's builder gives a meaning: the same number may clamp here and open a chuck there.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

// A warning for each such number of the program, at its first place; an error where the other control itself has a
// function under that number.
std::vector<text::Diagnostic> foreign_machine_functions(const ir::Program& program, const ir::Control& from,
                                                        const ir::Control& to);

}  // namespace dripfeed::passes
