// Diagnostics of a text as JSON: id, severity, line, columns, sentence, the control's alarm.
#pragma once

#include <string>
#include <vector>

#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::json {

// As many of each kind as text::DiagnosticFold shows.
std::string diagnostics(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source);
// [{id, severity, more}]: how many more there are of a kind.
std::string folded_diagnostics(const std::vector<text::Diagnostic>& diagnostics);

}  // namespace dripfeed::json
