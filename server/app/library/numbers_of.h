// A program as its words and its numbers: two texts with the same words differ by numbers alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::app {

// Numbers that differ by no more are the same.
inline constexpr double kSameNumber = 1e-9;

struct ProgramNumber {
  double value = 0.0;  // with its sign
  std::uint32_t line = 0;
};

struct NumbersOf {
  std::vector<std::string> words;  // everything else, in its order; a number's place is "0"
  std::vector<std::uint32_t> word_lines;
  std::vector<ProgramNumber> numbers;
};

// Without comments, blanks, '%' and the program's own number. A text that the reader finds errors in has them, too.
NumbersOf numbers_of(std::string_view text, const compile::Dialect& dialect, const ir::Control& control);

// The first line of `found` whose words are others; nothing: the words are the same.
std::optional<std::uint32_t> first_other_word(const NumbersOf& expected, const NumbersOf& found);
// Indexes of the numbers that differ, of two with the same words.
std::vector<std::size_t> other_numbers(const NumbersOf& expected, const NumbersOf& found);

}  // namespace dripfeed::app
