// Whether two programs are the same text, EOBs and leader aside, and where they first differ.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::app {

struct TextDifference {
  std::uint64_t line = 0;    // 1-based, in `expected`
  std::uint64_t column = 0;  // 1-based byte
  std::string expected;      // the rest of that line, "" where it ends
  std::string found;
};

struct NumberedLine {
  std::uint64_t number = 0;  // from 1
  std::string text;
};
// The lines of a text that count where two are compared: EOBs of any form are one; blank lines, blanks at the end of a
// line and lines with '%' alone do not count.
std::vector<NumberedLine> numbered_lines(std::string_view text);

// Nothing when they are the same. Compared byte by byte, number formats too; EOBs of any form are one, blank lines and
// what precedes the first '%' of both do not count, nor does a final '%' line.
std::optional<TextDifference> first_difference(std::string_view expected, std::string_view found);

// "line 3, column 5: expected \"X1.\", found \"X1\"".
std::string sentence_of(const TextDifference& difference);

}  // namespace dripfeed::app
