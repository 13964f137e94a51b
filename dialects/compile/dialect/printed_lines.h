// The lines of a printed text, and which of them are blocks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace dripfeed::compile {

struct PrintedLine {
  std::uint32_t number = 1;  // 1-based
  std::uint32_t offset = 0;
  std::string_view text;  // without its LF
};

// Calls visit(PrintedLine) for each line of a text with LF as EOB.
template <class Visit>
void for_each_line(std::string_view text, Visit visit) {
  PrintedLine line;
  while (line.offset < text.size()) {
    const std::size_t end = std::min(text.find('\n', line.offset), text.size());
    line.text = text.substr(line.offset, end - line.offset);
    visit(line);
    line.offset = static_cast<std::uint32_t>(end + 1);
    ++line.number;
  }
}

// Not empty and no tape mark.
inline bool is_block(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first != std::string_view::npos &&
         !(line[first] == '%' && line.find_first_not_of(" \t\r", first + 1) == std::string_view::npos);
}

inline std::uint64_t count_blocks(std::string_view text) {
  std::uint64_t count = 0;
  for_each_line(text, [&count](const PrintedLine& line) { count += is_block(line.text) ? 1U : 0U; });
  return count;
}

}  // namespace dripfeed::compile
