// The words of the controls' languages, with what a check makes of each.
#pragma once

#include <string>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/language.h"

namespace dripfeed::cli {

// A line a word: its state, its spelling, what it does.
std::string list_of_words(const std::vector<compile::DialectWord>& words);
// docs/words.md: what the states mean, and how many words of each state the dialects have.
std::string words_in_markdown();
// docs/words-DIALECT.md: a line a word, with its state on each kind of machine.
std::string words_in_markdown(const compile::Dialect& dialect);

}  // namespace dripfeed::cli
