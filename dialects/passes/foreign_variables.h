// Variables by number that mean something of their own on the control that a program was written for: signals, offsets,
// clocks. Another control has other ones under these numbers, or none.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

// Between controls of '#' variables: numbers that the manuals of both give the same meaning stay, work offsets of
// G54.1 get the number of the same offset there, everything else is an error at its place.
std::vector<text::Diagnostic> translate_variables(ir::Program& program, const ir::Control& from, const ir::Control& to);

// Whether a number is not the program's own to use: a system variable, or one that the control has not.
bool is_foreign_variable(const ir::Variable& variable, const ir::Control& from);

}  // namespace dripfeed::passes
