// UTF-8 is read as RFC 3629 has it: shortest form, no surrogates, nothing beyond U+10FFFF.
#include "server/app/base/names.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

// What a screen does not show, or shows as something else: controls, marks that turn the direction of a text,
// separators of lines, what is no character.
struct Range {
  std::uint32_t first;
  std::uint32_t last;
};
constexpr std::array kUnprintable = {
    Range{0x00, 0x1F},     Range{0x7F, 0x9F},     Range{0xAD, 0xAD},     Range{0x061C, 0x061C}, Range{0x200B, 0x200F},
    Range{0x2028, 0x202E}, Range{0x2060, 0x206F}, Range{0xFDD0, 0xFDEF}, Range{0xFEFF, 0xFEFF}, Range{0xFFF0, 0xFFFB},
};

bool is_printable(std::uint32_t code) {
  const bool no_character = (code & 0xFFFEU) == 0xFFFEU;
  return !no_character &&
         std::ranges::none_of(kUnprintable, [&](Range range) { return range.first <= code && code <= range.last; });
}

// The next code point, taken off the front of `text`; nothing where that is not UTF-8.
std::optional<std::uint32_t> take_code(std::string_view& text) {
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};  // by the number of bytes
  const auto first = static_cast<std::uint8_t>(text.front());
  const std::size_t bytes = first < 0x80 ? 1 : first < 0xC0 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (bytes == 0 || first >= 0xF8 || text.size() < bytes) return std::nullopt;
  std::uint32_t code = bytes == 1 ? first : first & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    const auto next = static_cast<std::uint8_t>(text[i]);
    if ((next & 0xC0U) != 0x80U) return std::nullopt;
    code = (code << 6U) | (next & 0x3FU);
  }
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kLeast[bytes] || code > 0x10FFFF || surrogate) return std::nullopt;
  text.remove_prefix(bytes);
  return code;
}

}  // namespace

std::string why_no_name(std::string_view name) {
  if (name.empty()) return "must not be empty";
  if (name.size() > kLongestName_bytes)
    return fmt::format("must be at most {} bytes, and has {}", kLongestName_bytes, name.size());
  if (name.front() == ' ' || name.back() == ' ') return "must not begin or end with a blank";
  if (name == "." || name == "..") return "must be a name: \".\" and \"..\" stand for folders";
  for (std::string_view rest = name; !rest.empty();) {
    const std::size_t at = name.size() - rest.size();
    const auto code = take_code(rest);
    if (!code) return fmt::format("must be UTF-8: byte {} is not", at + 1);
    if (!is_printable(*code))
      return fmt::format("must be printable: U+{:04X} at byte {} is a control character or is not shown", *code,
                         at + 1);
  }
  return {};
}

std::string why_no_folder(std::string_view folder) {
  if (folder.size() > kLongestFolder_bytes)
    return fmt::format("must not have more than {} bytes", kLongestFolder_bytes);
  for (std::size_t begin = 0; !folder.empty() && begin <= folder.size();) {
    const std::size_t end = std::min(folder.find('/', begin), folder.size());
    if (const std::string why = why_no_name(folder.substr(begin, end - begin)); !why.empty())
      return "has a name that " + why;
    begin = end + 1;
  }
  return {};
}

}  // namespace dripfeed::app
