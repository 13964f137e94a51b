// Found before the text is split into lexemes: a native program has none of the family language.
#include "dialects/family/native_text.h"

#include <algorithm>

namespace dripfeed::family {

namespace {

constexpr std::string_view kNative = "native";

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_name_byte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || is_digit(c);
}

// The verb of that name has its text in quotes on its line.
bool is_native_line(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  if (!line.starts_with(kNative) || line.contains('"')) return false;
  return line.size() == kNative.size() || !is_name_byte(line[kNative.size()]);
}

}  // namespace

std::uint32_t native_begin(std::string_view text) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    // One line end alone: the program may begin with others.
    const std::size_t next = end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
    if (is_native_line(text.substr(begin, end - begin))) return static_cast<std::uint32_t>(std::min(next, text.size()));
    begin = next;
  }
  return static_cast<std::uint32_t>(text.size());
}

std::size_t target_length(std::string_view text) {
  std::size_t end = 0;
  if (text.starts_with('#')) {
    ++end;
    while (end < text.size() && is_digit(text[end])) ++end;
    return end == 1 ? 0 : end;
  }
  while (end < text.size() && (is_name_byte(text[end]) || text[end] == '.')) ++end;
  return end;
}

}  // namespace dripfeed::family
