// The reserved words of the language, one row each: what they are to the parser. Codes with names (DIAMON, BRISK) are
// in codes.h, system variables in system_variables.h.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "dialects/ir/expression.h"
#include "dialects/ir/statement.h"

namespace dripfeed::sinumerik {

// What a reserved word is.
enum class Role : std::uint8_t {
  infix,      // DIV, AND: Keyword::op
  prefix,     // NOT, B_NOT: Keyword::op
  function,   // SIN(…): Keyword::op
  foreign,    // a function that is known and has no counterpart in ir: INDEX, CTRANS
  constant,   // TRUE, FALSE
  word_mode,  // AC, IC and the like around the value of a word
  address,    // a word with a name: CR=
  statement,  // opens a statement: Keyword::statement
  procedure,  // a statement that is kept as it is; its words are not read
  cycle,      // the same: a standard cycle of the control
  type,       // INT, REAL …
  attribute,  // of PROC and DEF
};

// What a word may do when its statement runs, as far as the reader does not carry it out. Only `none` and
// `paces`, and `smooths` of values that are known, leave the verdict on a program as it is.
enum class Effect : std::uint8_t {
  unknown,  // neither moves nor shifts for certain; what else it changes is not known here
  none,     // nothing of motion or state
  moves,    // axes may be anywhere afterwards
  shifts,   // coordinates may lie elsewhere afterwards
  smooths,  // how the machine follows the path, not which path: tolerance, smoothing
  paces,    // how fast it follows the path: along which axes feeds count
};

enum class Verb : std::uint8_t {
  none,
  if_word,
  else_word,
  end_if,
  while_word,
  end_while,
  for_word,
  end_for,
  loop,
  end_loop,
  repeat,
  repeat_block,
  until,
  case_word,
  go_to,
  go_to_forward,
  go_to_backward,
  go_to_tolerant,
  go_to_start,
  define,
  procedure,
  declare,
  message,
  alarm,
  call,
  call_path,      // PCALL
  call_external,  // EXTCALL
  call_iso,       // ISOCALL
  execute,        // EXECSTRING
  macro,          // DEFINE … AS
  call_modal,
  return_word,
};

struct Keyword {
  std::string_view name;
  Role role = Role::procedure;
  ir::Operator op = ir::Operator::constant;  // infix, prefix, function
  Verb verb = Verb::none;                    // statement
  ir::Address address = ir::Address::other;  // address
  ir::ValueType type = ir::ValueType::real;  // type
  std::uint8_t rank = 0;                     // infix: its level, 1 binds closest
  Effect effect = Effect::unknown;           // of what is kept as it is
};

std::span<const Keyword> keywords();
// nullptr for a name that is free.
const Keyword* find_keyword(std::string_view name);

// Level of an infix operator; comparisons are the weakest, 0 when it is none.
std::uint8_t rank_of(ir::Operator op);
// As it is written: "DIV", "==", "SIN"; "" when the language has no such operator.
std::string_view spelling_of(ir::Operator op);

inline constexpr std::uint8_t kUnaryRank = 1;
inline constexpr std::uint8_t kWeakestRank = 11;

}  // namespace dripfeed::sinumerik
