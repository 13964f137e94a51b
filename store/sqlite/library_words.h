// What a person looks for, as FTS5 wants it, and how near a name comes to it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::sqlite {

// Where words are looked for. In names, numbers, labels and comments a word stands for all that begin so. A text has so
// many different words that begin with a letter or two, or with a digit, that only longer ones do there.
enum class Reach : std::uint8_t { head, text };

// A term that a person looks for, as expressions of FTS5 in which nothing is an operator.
struct SearchTerm {
  std::string word{};  // in lower case (ASCII); "" for a phrase
  std::string in_head{};
  std::string in_text{};
};
std::vector<SearchTerm> terms_of(std::string_view words);
// All of them; "" where there are none.
std::string match_of(const std::vector<SearchTerm>& terms, Reach reach);

// The words of a name, in lower case (ASCII).
std::vector<std::string> name_words(std::string_view text);
// Short words and numbers are right or they are others.
bool may_have_a_fault(std::string_view word);
// Between marks, so that its first and last letters make pieces of three, too: "^^pump$".
std::string marked_word(std::string_view word);
// Any piece of three of it.
std::string pieces_of(std::string_view word);
// Whether one letter of four at most is wrong, missing, too many, or exchanged with the next one. A word that goes on
// where the one that is looked for ends is as near.
bool is_near(std::string_view wanted, std::string_view word);

}  // namespace dripfeed::sqlite
