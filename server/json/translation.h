// A translated or rewritten text as JSON.
#pragma once

#include <string>

#include "dialects/compile/translate/convert.h"
#include "dialects/text/source.h"
#include "server/app/library/rewriting.h"
#include "server/app/library/translation.h"

namespace dripfeed::json {

// {"text","verified","not_verified","origins","diagnostics","folded"}: what the command prints.
std::string translation(const compile::ConvertResult& result, const text::Source& source);
// The same with both dialects and the mode: what the API answers.
std::string translation(const app::Translation& translation, compile::ConvertMode mode);

// {"text","numbers","references","assumptions","refused"}: for the API, and for `dripfeed renumber --json`.
std::string rewritten(const app::Rewritten& rewritten);

}  // namespace dripfeed::json
