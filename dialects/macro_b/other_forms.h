// What a Haas writes in another form than its relatives, with the same meaning: the count of holes by L, a dwell in
// seconds by its decimal point, G28 for all axes. Readers bring it to the common form, writers back.
//
//   G04 P1.5             G04 P1500            a dwell
//   G70 I5. J15. L12     G34 I5. J15. K12     holes on a circle; G71 on an arc, G72 on a line
//   G81 Z-1. R.1 L0      G81 Z-1. R.1 K0      no hole yet
//   G28                  G28 X, Y and Z by increments of 0
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/macro_b/grammar.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// Whether a block with such a code is to be read with all its words before it is known what it says.
bool has_other_form(const Grammar& grammar, ir::Function function);

// Writes the common forms as the control has them; `program` is otherwise raised. Reports what it has no form for.
void write_other_forms(ir::Program& program, const ir::Control& control, const Grammar& grammar,
                       std::vector<text::Diagnostic>& diagnostics);

}  // namespace dripfeed::macro_b
