// lex: the bytes of a part program to tokens that tile them, for any bytes. It finds no faults: an invalid byte and a
// string without its end are tokens like others, and parsing names them.
#pragma once

#include <string_view>
#include <vector>

#include "dialects/ir/token.h"

namespace dripfeed::sinumerik {

// Appends the tokens of `text`, which must be shorter than 4 GiB. Kinds as in ir/token.h; beyond that:
// - white: blanks, control characters and '&', which the control reads as blanks, and a byte order mark at the start;
// - tape_mark: '%' at the start of a line and the rest of the line (the head of a file on a serial line);
// - skip: '/' at the start of a block with its digits;
// - address: one letter; or a letter with a number that belongs to it (X1=, S2=, M1=, I1=): then it is longer;
// - variable: R with its digits, or R alone; $ and the name after it;
// - name: two letters or more, keyword or not; - number: digits, with their EX exponent, or 'H0F', 'B101';
// - string: from quote to quote, or to the end of the block when the second is missing;
// - invalid: a run of characters that the control does not read.
void lex(std::string_view text, std::vector<ir::Token>& tokens);

}  // namespace dripfeed::sinumerik
