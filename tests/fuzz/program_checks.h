// What must hold of every text that a dialect reads, whatever its bytes are.
#pragma once

#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "tests/fuzz/target.h"

namespace dripfeed::fuzz {

// Spans of diagnostics, of their notes and of their fixes lie in the text, and each can be shown to a person.
void require_places(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source);

// Tokens tile the text, the program prints back byte for byte, and what its statements point at is there.
void require_whole(const ir::Program& program, const text::Source& source);

}  // namespace dripfeed::fuzz
