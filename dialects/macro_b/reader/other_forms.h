// What a Haas writes in another form than its relatives, with the same meaning: the count of holes by L, a dwell in
// seconds by its decimal point, G28 for all axes. Readers bring it to the common form, write_other_forms.h back.
//
//   G04 P1.5             G04 P1500            a dwell
//   G70 I5. J15. L12     G34 I5. J15. K12     holes on a circle; G71 on an arc, G72 on a line
//   G81 Z-1. R.1 L0      G81 Z-1. R.1 K0      no hole yet
//   G28                  G28 X, Y and Z by increments of 0
#pragma once

#include <span>

#include "dialects/ir/program.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::macro_b {

inline constexpr double kMillisecondsPerSecond = 1000.0;

bool is_hole_pattern(const ir::Code& code);
// Whether P of a block with the code is a time.
bool takes_time(const ir::Code& code);
void rename_words(std::span<ir::Word> words, ir::Address from, ir::Address to);
bool is_constant(const ir::Program& program, ir::ExpressionId id);
// Whether a block with such a code is to be read with all its words before it is known what it says.
bool has_other_form(const Grammar& grammar, ir::Function function);

}  // namespace dripfeed::macro_b
