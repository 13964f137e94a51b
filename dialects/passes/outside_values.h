// Variables whose values a main program takes from outside: the operator, or what ran before it. Another control has
// them elsewhere, and there no one has set them.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::passes {

struct OutsideValue {
  std::uint32_t number = 0;
  text::Span span;  // of its first read
};

// Numbered variables of `bank` that are read before they are set on some path, without those that each call gets again.
// Nothing for subprograms, whose callers set some of them, and nothing after the first call, which may have.
std::vector<OutsideValue> outside_values(const ir::Program& program, const ir::Control& control, ir::Bank bank);

}  // namespace dripfeed::passes
