// Arguments of macro calls and the local variables that they become: G65 P9010 A1. B2. sets #1 and #2 (argument
// assignment I of all controls with '#' variables). Parameters by position take the letters in the order of their
// variables, so that each program of a call can be translated by itself.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace dripfeed::passes {

struct ArgumentLetter {
  char letter;
  std::uint32_t number;  // of the local variable
};

// By position. G L N O P are no arguments; #10, #12 and #14 to #16 have no letter.
inline constexpr auto kArgumentLetters = std::to_array<ArgumentLetter>({
    {'A', 1},  {'B', 2},  {'C', 3},  {'I', 4},  {'J', 5},  {'K', 6},  {'D', 7},
    {'E', 8},  {'F', 9},  {'H', 11}, {'M', 13}, {'Q', 17}, {'R', 18}, {'S', 19},
    {'T', 20}, {'U', 21}, {'V', 22}, {'W', 23}, {'X', 24}, {'Y', 25}, {'Z', 26},
});

// From 0; nothing for a letter that is no argument.
inline std::optional<std::size_t> position_of_letter(char letter) {
  const auto row = std::ranges::find(kArgumentLetters, letter, &ArgumentLetter::letter);
  if (row == kArgumentLetters.end()) return std::nullopt;
  return static_cast<std::size_t>(row - kArgumentLetters.begin());
}

inline std::optional<std::size_t> position_of_local(std::uint32_t number) {
  const auto row = std::ranges::find(kArgumentLetters, number, &ArgumentLetter::number);
  if (row == kArgumentLetters.end()) return std::nullopt;
  return static_cast<std::size_t>(row - kArgumentLetters.begin());
}

}  // namespace dripfeed::passes
