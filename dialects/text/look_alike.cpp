// The table of look-alikes, sorted by code point: what turns up in programs that went through a word processor or were
// typed on a keyboard of another alphabet.
#include "dialects/text/look_alike.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace dripfeed::text {

namespace {

struct LookAlike {
  char32_t code_point;
  char looks;
};

constexpr auto kLookAlikes = std::to_array<LookAlike>({
    {0x00A0, ' '},  {0x00AD, '\0'}, {0x00D7, 'X'}, {0x0391, 'A'},  {0x0392, 'B'},  {0x0395, 'E'},  {0x0396, 'Z'},
    {0x0397, 'H'},  {0x0399, 'I'},  {0x039A, 'K'}, {0x039C, 'M'},  {0x039D, 'N'},  {0x039F, 'O'},  {0x03A1, 'P'},
    {0x03A4, 'T'},  {0x03A5, 'Y'},  {0x03A7, 'X'}, {0x0405, 'S'},  {0x0406, 'I'},  {0x0408, 'J'},  {0x0410, 'A'},
    {0x0412, 'B'},  {0x0415, 'E'},  {0x0417, '3'}, {0x041A, 'K'},  {0x041C, 'M'},  {0x041D, 'H'},  {0x041E, 'O'},
    {0x0420, 'P'},  {0x0421, 'C'},  {0x0422, 'T'}, {0x0423, 'Y'},  {0x0425, 'X'},  {0x0430, 'a'},  {0x0435, 'e'},
    {0x043E, 'o'},  {0x0440, 'p'},  {0x0441, 'c'}, {0x0443, 'y'},  {0x0445, 'x'},  {0x0455, 's'},  {0x0456, 'i'},
    {0x0458, 'j'},  {0x04AE, 'Y'},  {0x04C0, 'I'}, {0x200B, '\0'}, {0x200C, '\0'}, {0x200D, '\0'}, {0x200E, '\0'},
    {0x200F, '\0'}, {0x2010, '-'},  {0x2011, '-'}, {0x2012, '-'},  {0x2013, '-'},  {0x2014, '-'},  {0x2018, '\''},
    {0x2019, '\''}, {0x201C, '"'},  {0x201D, '"'}, {0x202F, ' '},  {0x2044, '/'},  {0x2060, '\0'}, {0x2212, '-'},
    {0x2215, '/'},  {0x2217, '*'},  {0x3000, ' '}, {0xFEFF, '\0'},
});
static_assert(std::ranges::is_sorted(kLookAlikes, {}, &LookAlike::code_point));

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

// Length that the first byte announces, 0 for one that begins nothing.
std::uint32_t announced_length(unsigned char first) {
  if (first < 0x80U) return 1;
  if (first >= 0xC2U && first < 0xE0U) return 2;
  if (first >= 0xE0U && first < 0xF0U) return 3;
  return first >= 0xF0U && first < 0xF5U ? 4 : 0;
}

}  // namespace

Character read_character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::uint32_t length = announced_length(first);
  const Character invalid = {char32_t{0xDC00U} + first, 1};
  if (length == 0 || text.size() < length) return invalid;
  if (length == 1) return {first, 1};
  char32_t code_point = first & (0x7FU >> length);
  for (const char c : text.substr(1, length - 1)) {
    if (!is_continuation(c)) return invalid;
    code_point = (code_point << 6U) | (static_cast<unsigned char>(c) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code_point >= 0xD800U && code_point < 0xE000U;
  return code_point < kLeast[length] || code_point > 0x10FFFFU || surrogate ? invalid : Character{code_point, length};
}

char look_alike(char32_t code_point) {
  // The full-width forms repeat ASCII from '!' to '~'.
  if (code_point >= 0xFF01U && code_point <= 0xFF5EU) return static_cast<char>(code_point - 0xFF01U + U'!');
  const auto row = std::ranges::lower_bound(kLookAlikes, code_point, {}, &LookAlike::code_point);
  return row != kLookAlikes.end() && row->code_point == code_point ? row->looks : '?';
}

std::string describe_character(std::string_view bytes) {
  const Character c = read_character(bytes);
  const auto value = static_cast<std::uint32_t>(c.code_point);
  if (value >= 0xDC00U && value < 0xDD00U) return fmt::format("byte {:02X}", value - 0xDC00U);
  const bool shows = value > 0x20U && value != 0x7FU && (look_alike(c.code_point) != '\0') &&
                     look_alike(c.code_point) != ' ' && !(value >= 0x80U && value < 0xA0U);
  if (!shows) return fmt::format("U+{:04X}", value);
  return value < 0x80U ? std::string(bytes.substr(0, 1))
                       : fmt::format("{} (U+{:04X})", bytes.substr(0, c.length), value);
}

}  // namespace dripfeed::text
