// Tokens of a family text: words, numbers, strings, symbols and line ends. Blanks and comments are left out; what a
// word means is the parser's.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "dialects/text/span.h"

namespace dripfeed::family {

enum class LexemeKind : std::uint8_t { word, number, string, symbol, end_of_line, invalid };

struct Lexeme {
  LexemeKind kind = LexemeKind::invalid;
  text::Span span;         // strings with their quotes
  std::uint32_t line = 1;  // 1-based
};

// Ends with an end_of_line, even when the text does not. A line that ends in + - * / ^ ( or ',' goes on in the
// next: its end is left out. Bytes that belong to nothing come as `invalid`, one lexeme a run; a string without its
// closing quote is invalid up to the line's end.
std::vector<Lexeme> lex(std::string_view text);

// Words that have a meaning of their own and so name nothing.
bool is_keyword(std::string_view word);

}  // namespace dripfeed::family
