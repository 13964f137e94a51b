// Characters are counted from the start of their line: lines of a program are short.
#include "server/lsp/positions.h"

#include <algorithm>
#include <tuple>

namespace dripfeed::lsp {

namespace {

bool is_before(const Position& a, const Position& b) {
  return std::tuple(a.line, a.character) < std::tuple(b.line, b.character);
}

// Of the UTF-8 character that begins with this byte; the text of a message is well-formed.
std::uint32_t bytes_of(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte < 0xC0U ? 1 : byte < 0xE0U ? 2 : byte < 0xF0U ? 3 : 4;
}

std::uint32_t units_of(std::uint32_t bytes, PositionUnit unit) {
  if (unit == PositionUnit::utf8) return bytes;
  return unit == PositionUnit::utf16 && bytes == 4 ? 2 : 1;
}

}  // namespace

bool touches(const Range& a, const Range& b) { return !is_before(a.end, b.start) && !is_before(b.end, a.start); }

Lines::Lines(std::string_view text) : text_(text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool ends = text[at] == '\n' || (text[at] == '\r' && (at + 1 == text.size() || text[at + 1] != '\n'));
    if (ends) starts_.push_back(static_cast<std::uint32_t>(at + 1));
  }
}

text::Span Lines::span_of(std::uint32_t line) const {
  const auto size = static_cast<std::uint32_t>(text_.size());
  if (line >= count()) return {size, size};
  text::Span span{starts_[line], line + 1 < count() ? starts_[line + 1] : size};
  while (!span.empty() && (text_[span.end - 1] == '\n' || text_[span.end - 1] == '\r')) --span.end;
  return span;
}

std::uint32_t Lines::offset_of(Position position, PositionUnit unit) const {
  const text::Span line = span_of(position.line);
  std::uint32_t at = line.begin;
  std::uint32_t passed = 0;
  while (at < line.end && passed < position.character) {
    const std::uint32_t bytes = bytes_of(text_[at]);
    passed += units_of(bytes, unit);
    if (passed > position.character) break;  // inside a character
    at = std::min(line.end, at + bytes);
  }
  return at;
}

Position Lines::position_of(std::uint32_t offset, PositionUnit unit) const {
  const auto after = std::ranges::upper_bound(starts_, offset);
  const auto line = static_cast<std::uint32_t>(after - starts_.begin() - 1);
  std::uint32_t character = 0;
  for (std::uint32_t at = starts_[line]; at < offset && at < text_.size();) {
    const std::uint32_t bytes = bytes_of(text_[at]);
    character += units_of(bytes, unit);
    at += bytes;
  }
  return {line, character};
}

Range Lines::range_of(text::Span span, PositionUnit unit) const {
  return {position_of(span.begin, unit), position_of(span.end, unit)};
}

}  // namespace dripfeed::lsp
