// Diagnostics of a text as JSON: id, severity, line, columns, sentence, the control's alarm.
#pragma once

#include <string>
#include <vector>

#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::json {

std::string diagnostics(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source);

}  // namespace dripfeed::json
