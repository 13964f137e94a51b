// Native blocks of a family: whether the target has them, and their text in what was printed.
#pragma once

#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/family/model.h"
#include "dialects/ir/control.h"
#include "dialects/ir/stage.h"

namespace dripfeed::compile {

// Errors at the family's places: no text for the target's language, text that is no block of it, and text that moves an
// axis, jumps or calls: where the axes are after that is not known here.
std::vector<text::Diagnostic> faults_of_natives(const family::Family& family, const Dialect& dialect,
                                                const ir::Control& target);
// The numbers of the M functions that stand for them: known to the control that the family is built for.
void admit_natives(const family::Family& family, ir::Control& control);
// In place of those functions: the texts.
void put_natives(const family::Family& family, const Dialect& dialect, ir::PrintResult& printed);

}  // namespace dripfeed::compile
