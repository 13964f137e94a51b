// A text translated to another control's language. It is not stored: who wants to keep it adds it as a program.
#pragma once

#include <optional>
#include <string>

#include "dialects/compile/translate/convert.h"
#include "server/app/base/documents.h"
#include "server/app/base/error.h"
#include "server/app/shop/called_programs.h"

namespace dripfeed::app {

struct TranslationOrder {
  // A control by its machine's document, or by its dialect alone.
  struct Side {
    std::string dialect;
    std::string profile;
  };
  std::string name;  // of the program, for what is found in it
  std::string text;
  Side from;      // neither: the control that the text looks like
  Side to;        // one of them
  Caller caller;  // whose programs are called
  compile::ConvertMode mode = compile::ConvertMode::macro;
};

struct Translation {
  text::Source source;
  std::string from;  // dialects
  std::string to;
  compile::ConvertResult result;
};

// Errors: invalid: a dialect that is not known, or another one than the machine's; a lathe's text whose G-code system
// it does not show for certain.
Result<Translation> translate_text(const TranslationOrder& order, const Documents& documents, CalledBy& called);

// Whether the text shows which G-code system of a lathe it has: a translation by the wrong one cuts wrong. Errors:
// invalid, with the two lines that contradict each other.
Result<void> refuse_contradiction(const text::Source& source, const ir::Control& control);

}  // namespace dripfeed::app
