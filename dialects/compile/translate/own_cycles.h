// Programs of the shop's own that have the name of one of the control's cycles.
#pragma once

#include <vector>

#include "dialects/compile/dialect/library.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// An error at each call of one: it would be translated as the control's cycle. `library`: nullptr for none.
std::vector<text::Diagnostic> own_cycles(const ir::Program& program, const ir::Control& to, ProgramLibrary* library);

}  // namespace dripfeed::compile
