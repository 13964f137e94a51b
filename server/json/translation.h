// A translated text as JSON.
#pragma once

#include <string>

#include "dialects/compile/translate/convert.h"
#include "dialects/text/source.h"
#include "server/app/library/translation.h"

namespace dripfeed::json {

// {"text","verified","not_verified","origins","diagnostics","folded"}: what the command prints.
std::string translation(const compile::ConvertResult& result, const text::Source& source);
// The same with both dialects and the mode: what the API answers.
std::string translation(const app::Translation& translation, compile::ConvertMode mode);

}  // namespace dripfeed::json
