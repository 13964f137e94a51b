// The words of the controls' languages, with what a check makes of each.
#pragma once

#include <string>
#include <vector>

#include "dialects/compile/dialect/language.h"

namespace dripfeed::cli {

// A line a word: its state, its spelling, what it does.
std::string list_of_words(const std::vector<compile::DialectWord>& words);
// docs/words.md: every dialect for each kind of machine that it has, its words by state.
std::string words_in_markdown();

}  // namespace dripfeed::cli
