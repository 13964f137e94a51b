// One line of a program as the language reads it: without blanks and comments, in small letters, with the place of
// every character in the text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/token.h"
#include "dialects/text/span.h"

namespace dripfeed::linuxcnc {

struct Line {
  std::string text;
  std::vector<std::uint32_t> offsets;  // of each character, and of what comes after the last
  std::vector<text::Span> comments;
  bool is_tape_mark = false;

  [[nodiscard]] char at(std::size_t i) const { return i < text.size() ? text[i] : '\0'; }
  [[nodiscard]] std::string_view rest(std::size_t i) const { return std::string_view(text).substr(i); }
  [[nodiscard]] text::Span span(std::size_t first, std::size_t last) const {
    return {offsets[first], last > first ? offsets[last - 1] + 1 : offsets[first]};
  }
};

// Reads the line that begins at `at`, and appends its tokens with its EOB; gives where the next one begins.
std::uint32_t read_line(std::string_view text, std::uint32_t at, Line& line, std::vector<ir::Token>& tokens);

}  // namespace dripfeed::linuxcnc
