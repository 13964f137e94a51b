// What a program sets before it moves, and what it passes to programs of its own: the numbers that whoever runs it is
// meant to change.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

struct HeaderConstant {
  std::string target;         // as find_target takes it: "#100", "DIA", "TURNING_CYCLE.EXTD"
  std::string name;           // that people know it by, in the program's own case
  bool has_own_name = false;  // a name of the program, not a number
  ir::Variable variable;      // the one that takes it
  std::uint32_t statement = 0;
  std::uint32_t line = 0;
};

// In the order of the text; constants of assignments before the first move, initial values of definitions, and constant
// arguments of calls of programs of the same text. Each target once.
std::vector<HeaderConstant> header_constants(const ir::Program& program, const ir::Control& control);

// The comment after the number at `offset`; "" where the line sets another number as well, because only a person knows
// which of them is meant.
std::string_view comment_on_line(const ir::Program& program, std::uint32_t offset);

// The comment of the line, without its delimiters; "" when there is none.
std::string_view comment_at(const ir::Program& program, std::uint32_t offset);

}  // namespace dripfeed::compile
