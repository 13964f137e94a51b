// What is shown of a line, or of a word that a program wrote: never more than a screen's width, however long it is. So
// the output of a check is linear in its input.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace dripfeed::text {

// Without the "..." where something is cut.
inline constexpr std::size_t kExcerptBytes = 160;

// The part of a line around a place. Cut between characters of UTF-8, marked with "..." at each cut.
struct Excerpt {
  std::string text;
  std::size_t place = 0;  // in `text`: the byte that `at` is in the line
};
Excerpt excerpt_of(std::string_view line, std::size_t at);

// The beginning of a word that is quoted in a sentence.
std::string shortened(std::string_view word);

}  // namespace dripfeed::text
