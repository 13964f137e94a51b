// The same numbers on every control with '#' variables.
#include "dialects/macro_b/reader/call_words.h"

#include <algorithm>
#include <array>

namespace dripfeed::macro_b {

namespace {

struct Row {
  char letter;
  std::int32_t number10;
  CallWord word;
};
constexpr auto kRows = std::to_array<Row>({
    {'G', 100, CallWord::data_input},
    {'G', 110, CallWord::data_end},
    {'G', 650, CallWord::macro},
    {'G', 660, CallWord::modal},
    {'G', 661, CallWord::modal_each_block},
    {'G', 670, CallWord::modal_end},
    {'M', 980, CallWord::subprogram},
    {'M', 1980, CallWord::external},
});

}  // namespace

CallWord call_word(const ir::Control& control, char letter, std::int32_t number10) {
  if (code_call(control, letter, number10) != nullptr) return CallWord::by_code;
  if (letter == 'M') {
    const ir::CodeRow* const own = ir::find_code(control.m_codes, number10);
    if (own != nullptr && own->function == ir::Function::local_call) return CallWord::local;
  }
  const auto row =
      std::ranges::find_if(kRows, [&](const Row& r) { return r.letter == letter && r.number10 == number10; });
  return row == kRows.end() ? CallWord::none : row->word;
}

const ir::CodeCall* code_call(const ir::Control& control, char letter, std::int32_t number10) {
  const auto found = std::ranges::find_if(
      control.code_calls, [&](const ir::CodeCall& c) { return c.letter == letter && c.number10 == number10; });
  return found == control.code_calls.end() ? nullptr : &*found;
}

}  // namespace dripfeed::macro_b
