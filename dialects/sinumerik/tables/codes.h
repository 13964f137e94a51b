// The G and M functions of the SINUMERIK 840D sl, one row a code with its G group and where the manual lists it. How a
// function acts is the interpreter's; which words it takes is the parser's.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "dialects/ir/function.h"

namespace dripfeed::sinumerik {

// What the words in the block of a code mean. `own`: to this code alone (G25 S100 is a limit, not a speed): a block
// with it is kept as it is. `declared`: the same, but it neither moves nor changes what is modelled.
enum class WordUse : std::uint8_t { usual, own, declared };

struct GCode {
  ir::CodeRow row;
  std::uint8_t group = 0;  // the control's number of the G group; 0: none (a command with a name)
  WordUse words = WordUse::usual;
};

// Sorted by number10; those with a name only (number10 -1) come first.
std::span<const GCode> g_codes();
// The same rows, as ir::Control wants them.
std::span<const ir::CodeRow> g_code_rows();
std::span<const ir::CodeRow> m_code_rows();

// nullptr when there is none.
const GCode* find_g_code(std::uint32_t number);
const GCode* find_named_code(std::string_view name);
// G1 or DIAMON as written; nullptr when it is neither.
const GCode* find_code_as_written(std::string_view text);
// Of the M functions that every machine has; nullptr for those of the machine tool builder.
const ir::CodeRow* find_m_code(std::uint32_t number);

// The rows with names only, in named_codes.cpp.
std::span<const GCode> named_codes();

}  // namespace dripfeed::sinumerik
