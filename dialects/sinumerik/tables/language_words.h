// The words of the SINUMERIK language besides its G functions, for people.
#pragma once

#include <vector>

#include "dialects/ir/language_word.h"

namespace dripfeed::sinumerik {

std::vector<ir::LanguageWord> language_words();

}  // namespace dripfeed::sinumerik
