// A text with several programs, as memory dumps have them, cut at the names that they give themselves: O1234, :1234,
// <NAME>.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::app {

struct ProgramPiece {
  std::string name;       // "O12" for O0012, "PROBE" for <PROBE>
  std::string_view text;  // of the text that was cut
  std::size_t lines_before = 0;

  // After as many empty lines as stand before it, so that messages count as the text does.
  [[nodiscard]] std::string in_place() const { return std::string(lines_before, '\n') + std::string(text); }
};

// In their order; what stands before the first name is none.
std::vector<ProgramPiece> pieces_of(std::string_view text);

// O0012 and O12 are one name; others stay as they are.
std::string number_name(std::string_view name);

}  // namespace dripfeed::app
