// lex: the bytes of a program to tokens that tile them, for any bytes. It finds no faults: an invalid byte, a comment
// without its end and a % in the wrong place are tokens like others, and parsing names them.
#pragma once

#include <string_view>
#include <vector>

#include "dialects/ir/token.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::macro_b {

// Appends the tokens of `text`, which must be shorter than 4 GiB. Kinds as in ir/token.h; beyond that:
// - eob also for ';'; - tape_mark: '%' and the rest of its line; - skip: '/' with its digit at the start of a block;
// - variable: '#' alone, a name after it is a `name`; - name: a keyword; - address: one letter;
// - string: <NAME>, and the bracket of DPRNT, BPRNT and SETVN with all that is in it;
// - invalid: one character (all its UTF-8 bytes) that the control does not read.
void lex(std::string_view text, const Grammar& grammar, std::vector<ir::Token>& tokens);

}  // namespace dripfeed::macro_b
