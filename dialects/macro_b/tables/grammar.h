// What is spelled differently on the controls with '#' variables, as data: keywords and functions, and the few limits
// that ir::Control has no field for. The words' meanings are in the control's code tables.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "dialects/ir/expression.h"

namespace dripfeed::macro_b {

// What a keyword does in the grammar.
enum class KeywordRole : std::uint8_t {
  if_word,
  then_word,
  else_word,
  end_if,
  go_to,
  while_word,
  do_word,
  end_word,
  function,             // Keyword::op, with brackets
  infix,                // Keyword::op, between operands
  unmodelled_function,  // known to the control, without a counterpart here: PRM, ADP
  output,               // POPEN, PCLOS, DPRNT, BPRNT: neither moves nor changes state
  set_name,             // SETVN
};

struct Keyword {
  std::string_view spelling;
  KeywordRole role = KeywordRole::function;
  ir::Operator op = ir::Operator::constant;
};

// Keywords found by their first letter. Built once a reader from a static table, which must outlive it.
class KeywordIndex {
 public:
  explicit KeywordIndex(std::span<const Keyword> table);
  struct Match {
    const Keyword* keyword = nullptr;
    std::uint32_t length = 0;  // bytes of the text that it takes
  };
  // The longest keyword at the start of `text`; then one shortened to its first two letters, when what follows could
  // stand after it. `text` starts with a letter.
  [[nodiscard]] Match match(std::string_view text) const;

 private:
  [[nodiscard]] std::span<const Keyword> starting_with(char letter) const;
  std::span<const Keyword> table_;               // sorted by spelling
  std::array<std::uint16_t, 27> first_of_ = {};  // by letter
};

// A system variable by its name: [#_ALM], or by name and number: [#_ABSIO[1]].
struct NamedVariable {
  std::string_view name;
  std::uint32_t first = 0;
  bool numbered = false;
};

struct Grammar {
  std::span<const Keyword> keywords;  // sorted by spelling
  std::span<const NamedVariable> named_variables = {};
  // Ten times the numbers of the G codes that only the dialect's mill-turn centers have.
  std::span<const std::int32_t> mill_turn_codes = {};
  std::uint32_t highest_loop_number = 3;
  std::uint32_t highest_block_number = 99'999'999;
  std::uint32_t macro_digits = 12;           // of a constant in a macro statement
  bool condition_blocks = false;             // IF … THEN, ELSE, ENDIF over several blocks
  bool drip_forbids_conditions = false;      // IF … THEN as well as IF … GOTO while the program is fed
  bool drip_forbids_output = false;          // DPRNT and the like
  bool bare_expressions = false;             // X#1+10 without brackets
  bool packed_calls = true;                  // M98 P51234: five times O1234
  char start_letter = 'Q';                   // of M98: the block in the called program where it begins
  bool logic_in_conditions = true;           // [a GT b] AND [c LT d]
  bool long_tool_words = false;              // T001001 of a lathe: three digits each for the tool and its offset
  bool second_tool_is_next = false;          // T2 T3 M6: T3 is made ready for the next change
  bool dwell_point_is_seconds = false;       // P1. of a dwell is a second, P1000 the same in milliseconds
  bool then_may_lack = false;                // IF [a EQ b] G65 P1
  bool variables_have_parts = false;         // #30003.078: an element or a bit of parameter 3, only to be read
  bool reference_alone_is_all_axes = false;  // G28 without an axis
  bool rounds_words_whole = false;           // ROUND in a word gives a whole number, not the word's least increment
  char repeat_letter = 'K';                  // of a hole: how often; with 'L' also the count of a hole pattern
};

// The keywords of Custom Macro B; other controls append theirs.
std::span<const Keyword> common_keywords();

// Spelling of an operator; "" when the control has none.
std::string_view spelling_of(const Grammar& grammar, ir::Operator op);

}  // namespace dripfeed::macro_b
