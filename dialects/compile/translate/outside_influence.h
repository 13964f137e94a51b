// What of a program is decided outside of it: variables that others set, values that only the control knows, frames
// that an operator may have left. Where nothing is, each run of the program makes the same moves.
#pragma once

#include <optional>
#include <string>

#include "dialects/ir/program.h"
#include "dialects/text/span.h"

namespace dripfeed::compile {

struct OutsideInfluence {
  std::string what;  // "the variable #100, which nothing here sets before it is read,"
  text::Span span;
};

// The first one in the order of the text. Calls of the control's own cycles are none, those of other programs are.
std::optional<OutsideInfluence> outside_influence(const ir::Program& program);

}  // namespace dripfeed::compile
