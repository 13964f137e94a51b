// Values of a control's variables: as the control punched or printed them, or as a person wrote them down.
#pragma once

#include <cstdint>
#include <map>
#include <string_view>

#include "dialects/compile/dialect/dialect.h"
#include "server/app/base/error.h"

namespace dripfeed::app {

// Of `#` variables, of R parameters on a SINUMERIK. A line counts when it is
// - an assignment as the control punches it, which is run here: "#500=[25283*65536]/134217728", "N10 R20=0.412",
// "R[20]=0.412";
// - a number and a value, with or without a letter, = or blanks between: "500 412.", "V500 412.000" (what DPRNT
// prints). Other lines (heads, comments, %) are left out. Errors, with their line: an assignment that cannot be run, a
// variable that is given twice; no line that counts.
Result<std::map<std::uint32_t, double>> read_variables(std::string_view text, const compile::Dialect& dialect,
                                                       const ir::Control& control);

}  // namespace dripfeed::app
