// A control's language as a list of words, each with a line for people: its codes, keywords, functions, cycles and the
// system variables that it knows. Editors color and explain a text by it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/ir/control.h"
#include "dialects/ir/language_word.h"

namespace dripfeed::compile {

struct DialectWord {
  std::string spelling;  // as the control's manual writes it: "G02", "GOTOF", "#5041", "$P_EP"
  ir::WordSort sort = ir::WordSort::code;
  std::string about;                // a few words
  std::string_view reference = {};  // manual and section; "" where the table has none
  std::uint32_t last = 0;           // of numbered variables: the last of the range; 0: no range
  ir::WordState state = ir::WordState::interpreted;
};

// Each spelling once: codes first, then the words of the language, then variables.
std::vector<DialectWord> language_of(const Dialect& dialect, const ir::Control& control);

}  // namespace dripfeed::compile
