// Diagnostics of a text as JSON: id, severity, line, columns, sentence, the control's alarm. And what an editor asks
// for while the text is written: them with help and cure, the outline, the words of the language.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"
#include "server/app/base/error.h"
#include "server/app/checks/diagnose.h"
#include "server/app/jobs/restarting.h"
#include "server/app/library/split_text.h"

namespace dripfeed::json {

// As many of each kind as text::DiagnosticFold shows.
std::string diagnostics(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source);
// [{id, severity, more}]: how many more there are of a kind.
std::string folded_diagnostics(const std::vector<text::Diagnostic>& diagnostics);

// Places are lines and columns in characters, as an editor counts them.
std::string diagnosed(const app::Diagnosed& diagnosed);

// The document SplitText.
std::string split_text(const std::vector<app::SplitProgram>& programs);

// The document RestartPreview.
std::string restart_preview(const app::RestartMade& made);
// Of the dialect's usual control of that kind; `kind` and `g_system` may be empty. Errors: not_found: the dialect;
// invalid: the kind or the G code system.
app::Result<std::string> dialect_words(std::string_view dialect, std::string_view kind, std::string_view g_system);

}  // namespace dripfeed::json
