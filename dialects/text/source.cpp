// The line table is made once, when the text arrives: positions are asked for many times in reports.
#include "dialects/text/source.h"

#include <algorithm>
#include <utility>

namespace dripfeed::text {

namespace {

// The next byte of an EOB; the text's size when there is none. Not find_first_of: that is a call of memchr for each
// byte.
std::size_t find_eob(std::string_view text, std::size_t offset) {
  const auto begin = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
  return static_cast<std::size_t>(std::find_if(begin, text.end(), [](char c) { return c == '\n' || c == '\r'; }) -
                                  text.begin());
}

// Lengths of the EOBs in one scan. LF CR CR is looked for before LF, because its first byte is one.
std::vector<std::uint32_t> find_line_starts(std::string_view text) {
  std::vector<std::uint32_t> starts = {0};
  for (std::size_t offset = find_eob(text, 0); offset < text.size(); offset = find_eob(text, offset)) {
    offset += eob_length(text, offset);
    starts.push_back(static_cast<std::uint32_t>(offset));
  }
  return starts;
}

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

}  // namespace

std::uint32_t eob_length(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) return 0;
  const std::string_view rest = text.substr(offset);
  if (rest.starts_with("\n\r\r")) return 3;
  if (rest.starts_with("\r\n")) return 2;
  return rest.front() == '\n' || rest.front() == '\r' ? 1 : 0;
}

Source::Source(std::string name, std::string text)
    : name_(std::move(name)),
      text_(std::make_shared<const std::string>(std::move(text))),
      line_starts_(find_line_starts(*text_)) {}

Position Source::position(std::uint32_t offset) const {
  const auto after = std::ranges::upper_bound(line_starts_, offset);
  const auto index = static_cast<std::uint32_t>(after - line_starts_.begin()) - 1;
  const std::uint32_t start = line_starts_[index];
  const std::string_view before = text().substr(start, offset - start);
  const auto continuations = static_cast<std::uint32_t>(std::ranges::count_if(before, is_continuation_byte));
  return {index + 1, offset - start + 1, offset - start - continuations + 1};
}

std::string_view Source::line(std::uint32_t number) const {
  if (number == 0 || number > line_starts_.size()) return {};
  const std::uint32_t start = line_starts_[number - 1];
  const std::string_view rest = text().substr(start);
  return rest.substr(0, find_eob(rest, 0));
}

std::uint32_t Source::line_count() const {
  // An EOB at the very end closes the last line and opens none.
  const auto starts = static_cast<std::uint32_t>(line_starts_.size());
  return line_starts_.back() == text().size() && starts > 1 ? starts - 1 : starts;
}

}  // namespace dripfeed::text
