// Expressions: nodes in an arena, addressed by index. Operators are named by what they do; how a control spells them,
// ranks them and rounds in them is its own table and Semantics.
#pragma once

#include <cstdint>

#include "dialects/text/span.h"

namespace dripfeed::ir {

enum class ExpressionId : std::uint32_t { none = 0xFFFFFFFFU };
enum class VariableId : std::uint32_t { none = 0xFFFFFFFFU };
enum class StringId : std::uint32_t { none = 0xFFFFFFFFU };
enum class SymbolId : std::uint32_t { none = 0xFFFFFFFFU };

enum class Operator : std::uint8_t {
  // leaves
  constant,  // Expression::value
  vacant,    // #0
  variable,  // Expression::variable
  string,    // Expression::string
  // one operand (a)
  negate,
  logic_not,
  bit_not,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sqrt,
  square,
  abs,
  ln,
  exp,
  round,
  truncate,
  round_up,  // ROUND; FIX, TRUNC (toward zero); FUP, ROUNDUP (away from zero, next larger: Semantics)
  bcd,
  bin,
  is_variable,
  frame_mirror,  // CMIRROR(axis)
  string_length,
  to_string,
  to_number,
  is_number,
  to_axis,  // AXNAME: the axis of a name
  to_upper,
  to_lower,
  // two operands (a, b)
  add,
  subtract,
  multiply,
  divide,
  integer_divide,
  modulo,
  bit_and,
  bit_or,
  bit_xor,
  logic_and,
  logic_or,
  logic_xor,
  equal,
  not_equal,
  less,
  less_equal,
  greater,
  greater_equal,
  concatenate,
  atan2,
  power,
  minimum,
  maximum,
  find_text,
  find_text_last,
  find_any,     // INDEX, RINDEX: a character in a text; MINDEX: any of several; -1 for none
  frame_shift,  // CTRANS(axis, value)
  frame_turn,   // CROT
  frame_scale,  // CSCALE
  frame_chain,  // A : B
  // three operands (a, b, c)
  bound,
  substring,  // SUBSTR(text, first, count); first from 0
  count_,
};

// A node. `a`, `b`, `c` are operands as far as the operator has them. For `variable`, `a` is unused: the index lives in
// Variable.
struct Expression {
  Operator op = Operator::constant;
  bool has_point = false;  // constants: the decimal point was written
  ExpressionId a = ExpressionId::none;
  ExpressionId b = ExpressionId::none;
  ExpressionId c = ExpressionId::none;
  double value = 0.0;  // constant
  VariableId variable = VariableId::none;
  StringId string = StringId::none;
  text::Span span;
};

// Where a variable lives. `hash` is #n, `r` is Rn, `named` is a DEF, a parameter or a name of the family language,
// `system` is one that the control defines by name ($P_EP, $AA_IW) and the control's table numbers.
enum class Bank : std::uint8_t { hash, r, named, system };

// One written use of a variable: #101, #[#2+1], R5, R[R1], COUNTER, A[3], $P_EP[X].
struct Variable {
  Bank bank = Bank::hash;
  std::uint32_t number = 0;          // hash, r: the number when `index` is none; system: row of the control's table
  SymbolId symbol = SymbolId::none;  // named
  ExpressionId index = ExpressionId::none;   // computed number (hash, r) or first array index (named, system)
  ExpressionId index2 = ExpressionId::none;  // second array index
  ExpressionId index3 = ExpressionId::none;  // third
  StringId name = StringId::none;            // system: as the control writes it, "$P_EP"
  text::Span span;
};

enum class ValueType : std::uint8_t { integer, real, boolean, character, string, axis, frame };

// A declared name: DEF, PROC parameter, or a variable of the family language.
struct Symbol {
  StringId name = StringId::none;
  ValueType type = ValueType::real;
  std::uint16_t dimension1 = 0;  // 0: a scalar
  std::uint16_t dimension2 = 0;
  std::uint16_t dimension3 = 0;
  std::uint16_t string_length = 0;  // STRING[n]
  bool is_parameter = false;
  bool by_reference = false;
  bool is_global = false;  // data of the control that outlives the program (GUD), declared elsewhere or in this text
  ExpressionId initial = ExpressionId::none;  // DEF … = value, or the default of a parameter
  text::Span span;
};

}  // namespace dripfeed::ir
