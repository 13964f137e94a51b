// The lexer's output: kinds of tokens, which together tile the bytes of the text.
#pragma once

#include <cstdint>

#include "dialects/text/span.h"

namespace dripfeed::ir {

enum class TokenKind : std::uint8_t {
  white,      // blanks, tabs, NULs, and what the control treats as such
  eob,        // end of block: LF, CR LF, CR, LF CR CR, or the dialect's own
  comment,    // with its delimiters
  tape_mark,  // '%' and what follows it on its line where the dialect says so
  skip,       // block skip: '/', '/2'
  address,    // a letter or name that takes a value: X, G, CR, LIMS
  number,     // a decimal without sign
  variable,   // '#' or 'R' as the head of a variable
  name,       // identifier: keyword, function, user name, label
  string,     // with its quotes
  symbol,     // operator, bracket, comma, equals, colon
  invalid,    // a byte that the control would not take
};

struct Token {
  TokenKind kind = TokenKind::invalid;
  text::Span span;
};

// Tokens [first, last) of Program::tokens.
struct TokenRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

}  // namespace dripfeed::ir
