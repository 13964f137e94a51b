// Letters that move an axis without being its name.
#pragma once

#include <optional>
#include <string_view>

#include "dialects/ir/control.h"
#include "dialects/ir/statement.h"

namespace dripfeed::ir {

inline constexpr std::string_view kAxisLetters = "XYZABCUVW";  // by ir::Axis

// 'X' for Address::x; '?' for those that are no letter.
constexpr char letter_of(Address address) {
  return address <= Address::z ? static_cast<char>('A' + static_cast<int>(address)) : '?';
}

// U V W H are increments of X Y Z C on controls where increments have letters (G-code system A), as far as the axis is
// there and the letter is not an axis itself. Where T is a plain tool number, H is the number of a tool length. Nothing
// for all other letters.
inline std::optional<char> incremented_axis(const Control& control, char letter) {
  constexpr std::string_view kIncrements = "UVWH";
  constexpr std::string_view kAxes = "XYZC";
  const std::size_t row = kIncrements.find(letter);
  if (!control.semantics.incremental_letters_uvw || row == std::string_view::npos) return std::nullopt;
  if (!control.axes.contains(kAxes[row]) || control.axes.contains(letter)) return std::nullopt;
  if (letter == 'H' && control.semantics.tool_word != ToolWord::number_and_offset) return std::nullopt;
  return kAxes[row];
}

}  // namespace dripfeed::ir
