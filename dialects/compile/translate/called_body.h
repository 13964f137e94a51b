// What a subprogram does between its head and its return, as lines that may stand in its caller's text: or why they may
// not. How it is called is not looked at here.
#pragma once

#include <cstdint>
#include <expected>
#include <string>

#include "dialects/ir/program.h"
#include "dialects/text/span.h"

namespace dripfeed::compile {

struct CalledBody {
  const ir::Program* text = nullptr;
  std::uint32_t first = 0;  // statements [first, last)
  std::uint32_t last = 0;
  std::uint32_t first_line = 1;  // lines [first_line, last_line] of the text
  std::uint32_t last_line = 0;
  text::Span return_words;        // of the last line; empty: the return has a line of its own
  std::uint32_t blocks = 0;       // lines that do something
  bool returns_by_code = false;   // alone in its block
  bool has_loop_numbers = false;  // DO1
};

// The reason is a clause about the program: "it jumps".
std::expected<CalledBody, std::string> called_body(const ir::Program& text, const ir::Section& range);

}  // namespace dripfeed::compile
