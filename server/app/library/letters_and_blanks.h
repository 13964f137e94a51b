// A text laid out again by its tokens: blanks between the words, and the case of letters. Comments, strings and what
// the control writes out stay byte for byte. What comes out is to be read again: see rewriting.h.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/ir/stage.h"

namespace dripfeed::app {

enum class Blanks : std::uint8_t { add, remove };

struct BlankOrder {
  Blanks blanks = Blanks::add;
  // The control takes words that follow each other without blanks, whatever they consist of: IF[#1EQ1]GOTO10.
  bool words_may_touch = false;
  std::vector<std::uint32_t> left_blocks{};  // sorted, by their number from 0: they stay as they are
};
std::string with_blanks(const ir::Program& program, const BlankOrder& order);

enum class LetterCase : std::uint8_t { upper, lower };
std::string with_case(const ir::Program& program, LetterCase wanted);

}  // namespace dripfeed::app
