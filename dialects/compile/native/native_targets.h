// Where a native program takes the value of a family: the plain constant of an assignment (#100=50., R10=-3.5), of a
// definition (DEF REAL DIA=100), or of a call (TURNING_CYCLE(100, …)).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

struct NativeConstant {
  text::Span span;  // sign and digits, in the program's text
  double value = 0.0;
  bool has_point = false;
  std::uint8_t digits = 0;      // as written, without leading zeros
  bool takes_integer = false;   // INT: whole numbers, without a point
  std::uint32_t statement = 0;  // that holds it
};

struct NativeTarget {
  std::optional<NativeConstant> constant;
  std::string why = {};                      // without one: why not
  std::string warning = {};                  // with one: what may take its value away, as far as no one here can see
  std::vector<ir::Variable> variables = {};  // that take its value: all are one
  std::vector<bool> scope = {};              // by statement: where they are that one
  std::vector<text::DiagnosticNote> notes = {};  // the places of the program that show either
};

// `target` is in upper case: "#100", "R10", "DIA", "TURNING_CYCLE.EXTD". It must be set by one plain constant of the
// text, on every path before the text reads it, and nothing else of the text may set it before that, by a computed
// number or otherwise.
NativeTarget find_target(const ir::Program& program, const ir::Control& control, std::string_view target);

// A number as it is written, with its sign: nothing for what is computed, and for other forms of numbers.
std::optional<NativeConstant> plain_constant(const ir::Program& program, ir::ExpressionId value);

}  // namespace dripfeed::compile
