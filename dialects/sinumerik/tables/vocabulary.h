// The words of the control besides those that the parser itself reads (keywords.h): what each is to the parser and what
// it may do when it runs. Every question whether an identifier is a word of the control goes through find_keyword and
// is_word_of_control.
#pragma once

#include <span>
#include <string_view>

#include "dialects/sinumerik/tables/keywords.h"

namespace dripfeed::sinumerik {

// Words of one kind with one effect.
struct WordList {
  Role role = Role::procedure;
  Effect effect = Effect::unknown;
  std::span<const std::string_view> names;
};

std::span<const WordList> vocabulary();

// A predefined word, a G function with a name, or a cycle that the control brings along.
bool is_word_of_control(std::string_view name);

}  // namespace dripfeed::sinumerik
