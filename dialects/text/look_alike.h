// Characters that look like what a control reads and are not it: letters of other alphabets, dashes, blanks and marks
// that show nothing. Texts come as UTF-8; a byte that is not UTF-8 is a character of its own.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace dripfeed::text {

// The character at the start of `text`, which must not be empty: its code point and how many bytes it has. A byte that
// begins no valid sequence gives its value above 0xDC00 (as lone surrogate) and length 1.
struct Character {
  char32_t code_point = 0;
  std::uint32_t length = 1;
};
Character read_character(std::string_view text);

// What it looks like: 'M' for the Cyrillic Em, '-' for a dash, ' ' for a blank of another width; '\0' when it shows
// nothing (zero-width, byte order mark); nothing else is known: '?'.
char look_alike(char32_t code_point);

// As a message names it: the character itself with its code point, "М (U+041C)"; "byte 8F" for no UTF-8.
std::string describe_character(std::string_view bytes);

}  // namespace dripfeed::text
