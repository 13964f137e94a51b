// Carrying out the edits that diagnostics propose, where each is certain of what was meant.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dialects/text/diagnostic.h"

namespace dripfeed::app {

struct FixedText {
  std::string text;
  std::vector<const text::Diagnostic*> carried_out;  // in the order of the text; of the list that was given
  std::size_t left = 0;                              // edits that touch one that was carried out
};
// Edits of called programs are left out.
FixedText fix_text(const text::Source& source, const std::vector<text::Diagnostic>& diagnostics);

// "write `M` in the place of `М`", "add ` mm`", "remove `,`"
std::string describe_edit(const text::Edit& edit, const text::Source& source);

}  // namespace dripfeed::app
