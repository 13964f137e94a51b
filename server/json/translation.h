// A translated or rewritten text, and what was changed in one, as JSON.
#pragma once

#include <string>

#include "dialects/compile/render/optimized.h"
#include "dialects/compile/translate/convert.h"
#include "dialects/text/source.h"
#include "server/app/library/rewriting.h"
#include "server/app/library/translation.h"
#include "server/app/library/value_case.h"

namespace dripfeed::json {

// {"text","verified","not_verified","origins","diagnostics","folded"}: what the command prints.
std::string translation(const compile::ConvertResult& result, const text::Source& source);
// The same with both dialects and the mode: what the API answers.
std::string translation(const app::Translation& translation, compile::ConvertMode mode);

// {"text","numbers","references","assumptions","refused"}: for the API, and for `dripfeed renumber --json`.
std::string rewritten(const app::Rewritten& rewritten);

// {"explains_all","why_not","values","rest"}, and the same with the part that the values are of.
std::string value_changes(const app::ValueChanges& changes);
std::string received_values(std::string_view changes, const store::ProgramRevision& stored);

// What optimizing a text gave: for the API, and for `dripfeed optimize --json`.
// {"text","origins","passes":[{"rule","edits","saved"}],"changes":[{"line","rule","what"}],"left_because",
// "not_verified","proved_max_mm","not_merged","not_tabulated","not_inlined":[{"line","program","why"}],"saved","before",
// "after","cost","diagnostics"}: the two costs are null where the program was not run before and after, `left_because`
// is why it is unchanged. The text is null where it could not be read.
std::string optimized(const compile::OptimizeResult& result, const ir::CostModel& cost, const text::Source& source);

}  // namespace dripfeed::json
