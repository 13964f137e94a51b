// A file with several programs, as controls dump their memory, taken apart for the library. Nothing of it is lost: what
// cannot be taken apart so stays one text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::app {

struct SplitProgram {
  std::string name;     // that it gives itself; "" where it gives none
  std::string comment;  // its first; "" without one
  std::string text;     // with the line ends of the file; "%" stands around each where it stood around all
};

// In their order; one where the text holds one.
std::vector<SplitProgram> split_text(std::string_view text);

}  // namespace dripfeed::app
