// The writing half of other_forms.h: from the common forms to those of a Haas.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/macro_b/tables/grammar.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// Writes the common forms as the control has them; `program` is otherwise raised. Reports what it has no form for.
void write_other_forms(ir::Program& program, const ir::Control& control, const Grammar& grammar,
                       std::vector<text::Diagnostic>& diagnostics);

}  // namespace dripfeed::macro_b
