// The line table is made once, when the text arrives: positions are asked for many times in reports. It has each 16th
// line, so that it is small next to the text; the lines after that one are counted.
#include "dialects/text/source.h"

#include <algorithm>
#include <optional>
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

constexpr std::uint32_t kStride = 16;

// The start of the line after the one that `offset` lies in; nothing where that is the last one.
std::optional<std::size_t> next_line(std::string_view text, std::size_t offset) {
  const std::size_t eob = find_eob(text, offset);
  if (eob >= text.size()) return std::nullopt;
  return eob + eob_length(text, eob);
}

std::vector<std::uint32_t> find_line_starts(std::string_view text) {
  std::vector<std::uint32_t> starts = {0};
  std::uint32_t lines = 0;
  for (auto at = next_line(text, 0); at; at = next_line(text, *at))
    if (++lines % kStride == 0) starts.push_back(static_cast<std::uint32_t>(*at));
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
  std::uint32_t index = (static_cast<std::uint32_t>(after - line_starts_.begin()) - 1) * kStride;
  std::uint32_t start = *(after - 1);
  for (auto at = next_line(text(), start); at && *at <= offset; at = next_line(text(), start)) {
    start = static_cast<std::uint32_t>(*at);
    ++index;
  }
  const std::string_view before = text().substr(start, offset - start);
  const auto continuations = static_cast<std::uint32_t>(std::ranges::count_if(before, is_continuation_byte));
  return {index + 1, offset - start + 1, offset - start - continuations + 1};
}

std::string_view Source::line(std::uint32_t number) const {
  if (number == 0 || (number - 1) / kStride >= line_starts_.size()) return {};
  std::size_t start = line_starts_[(number - 1) / kStride];
  for (std::uint32_t n = (number - 1) % kStride; n > 0; --n) {
    const auto at = next_line(text(), start);
    if (!at) return {};
    start = *at;
  }
  const std::string_view rest = text().substr(start);
  return rest.substr(0, find_eob(rest, 0));
}

std::uint32_t Source::line_count() const {
  std::uint32_t starts = (static_cast<std::uint32_t>(line_starts_.size()) - 1) * kStride + 1;
  std::size_t last = line_starts_.back();
  for (auto at = next_line(text(), last); at; at = next_line(text(), last)) {
    last = *at;
    ++starts;
  }
  // An EOB at the very end closes the last line and opens none.
  return last == text().size() && starts > 1 ? starts - 1 : starts;
}

}  // namespace dripfeed::text
