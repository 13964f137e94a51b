// Translating a long program without its stretches of plain moves, which are then written line by line: in constant
// memory but for the two texts, and in a fraction of the time.
#pragma once

#include <optional>

#include "dialects/compile/translate/convert.h"
#include "dialects/compile/translate/thin_program.h"

namespace dripfeed::compile {

// As convert_whole(), which translates the lines around the stretches. Nothing where the program must be translated as
// a whole: no stretch is long enough, or a line of one is not the line that the other control writes for the same
// words.
std::optional<ConvertResult> convert_thin(const ConvertRequest& request, const ThinOptions& options = {});

}  // namespace dripfeed::compile
