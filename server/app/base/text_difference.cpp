// Line by line, with the line's number in the expected text.
#include "server/app/base/text_difference.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "protocol/tape_code/eob.h"

namespace dripfeed::app {

namespace {

constexpr std::size_t kShown = 40;

}  // namespace

std::vector<NumberedLine> numbered_lines(std::string_view text) {
  std::string plain;
  tape_code::EobReader eobs;
  for (const char c : text) {
    if (c != '\0' && c != '\x7F') eobs.put(c, plain);
  }
  eobs.finish(plain);
  std::vector<NumberedLine> lines;
  std::uint64_t number = 0;
  for (std::size_t begin = 0; begin < plain.size();) {
    const std::size_t end = std::min(plain.find('\n', begin), plain.size());
    std::string line = plain.substr(begin, end - begin);
    while (!line.empty() && line.back() == ' ') line.pop_back();
    ++number;
    if (!line.empty() && line != "%") lines.push_back({number, std::move(line)});
    begin = end + 1;
  }
  return lines;
}

std::optional<TextDifference> first_difference(std::string_view expected, std::string_view found) {
  const std::vector<NumberedLine> left = numbered_lines(expected);
  const std::vector<NumberedLine> right = numbered_lines(found);
  for (std::size_t i = 0; i < std::max(left.size(), right.size()); ++i) {
    const std::string one = i < left.size() ? left[i].text : "";
    const std::string other = i < right.size() ? right[i].text : "";
    if (i < left.size() && i < right.size() && one == other) continue;
    const auto at = static_cast<std::size_t>(std::ranges::mismatch(one, other).in1 - one.begin());
    const std::uint64_t line = i < left.size() ? left[i].number : left.empty() ? 1 : left.back().number + 1;
    return TextDifference{
        .line = line, .column = at + 1, .expected = one.substr(at, kShown), .found = other.substr(at, kShown)};
  }
  return std::nullopt;
}

std::string sentence_of(const TextDifference& difference) {
  return fmt::format("line {}, column {}: expected \"{}\", found \"{}\"", difference.line, difference.column,
                     difference.expected, difference.found);
}

}  // namespace dripfeed::app
