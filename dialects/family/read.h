// From text to family: lex, parse, and check of names, units and structure in one pass over the lines.
#pragma once

#include <vector>

#include "dialects/family/model.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::family {

struct ReadFamilyResult {
  Family family;  // to be bound only when no diagnostic is an error
  std::vector<text::Diagnostic> diagnostics;
};

// Never fails: a wrong line is reported and left out, and reading goes on with the next one. Spans are in `source`.
ReadFamilyResult read_family(const text::Source& source);

}  // namespace dripfeed::family
