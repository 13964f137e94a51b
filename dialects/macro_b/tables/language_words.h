// The words of a '#'-variable control's language besides its codes, from its grammar's table, for people.
#pragma once

#include <vector>

#include "dialects/ir/language_word.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::macro_b {

std::vector<ir::LanguageWord> language_words(const Grammar& grammar);

}  // namespace dripfeed::macro_b
