// U+10FFhh is F4 8F BC..BF 80..BF: the byte's upper two bits in the third, its lower six in the fourth. Where a text
// has such a character itself, its four bytes go one by one, so that the return is unique.
#include "store/postgresql/texts.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace dripfeed::postgresql {
namespace {

constexpr std::size_t kStandInBytes = 4;

std::uint8_t at(std::string_view text, std::size_t i) { return static_cast<std::uint8_t>(text[i]); }

bool is_stand_in(std::string_view text) {
  return text.size() >= kStandInBytes && at(text, 0) == 0xF4 && at(text, 1) == 0x8F && at(text, 2) >= 0xBC &&
         at(text, 2) <= 0xBF && at(text, 3) >= 0x80 && at(text, 3) <= 0xBF;
}

// What may follow the first byte of a character: Unicode's table 3-7, "Well-Formed UTF-8 Byte Sequences".
struct Sequence {
  std::uint8_t first_from, first_to;
  std::uint8_t second_from, second_to;
  std::size_t bytes;
};
constexpr std::array<Sequence, 9> kSequences{{{0x01, 0x7F, 0, 0, 1},
                                              {0xC2, 0xDF, 0x80, 0xBF, 2},
                                              {0xE0, 0xE0, 0xA0, 0xBF, 3},
                                              {0xE1, 0xEC, 0x80, 0xBF, 3},
                                              {0xED, 0xED, 0x80, 0x9F, 3},
                                              {0xEE, 0xEF, 0x80, 0xBF, 3},
                                              {0xF0, 0xF0, 0x90, 0xBF, 4},
                                              {0xF1, 0xF3, 0x80, 0xBF, 4},
                                              {0xF4, 0xF4, 0x80, 0x8F, 4}}};

// Bytes of the character that the text begins with and that goes as it is; 0 for a byte that does not.
std::size_t plain_bytes(std::string_view text) {
  const std::uint8_t first = at(text, 0);
  const auto fits = std::ranges::find_if(
      kSequences, [&](const Sequence& one) { return first >= one.first_from && first <= one.first_to; });
  if (fits == kSequences.end() || text.size() < fits->bytes || is_stand_in(text)) return 0;
  if (fits->bytes > 1 && (at(text, 1) < fits->second_from || at(text, 1) > fits->second_to)) return 0;
  for (std::size_t i = 2; i < fits->bytes; ++i) {
    if (at(text, i) < 0x80 || at(text, i) > 0xBF) return 0;
  }
  return fits->bytes;
}

void add_stand_in(std::string& to, std::uint8_t byte) {
  to += "\xF4\x8F";
  to += static_cast<char>(0xBCU | (byte >> 6U));
  to += static_cast<char>(0x80U | (byte & 0x3FU));
}

}  // namespace

std::optional<std::string> to_database(std::string_view text) {
  std::size_t same = 0;
  while (same < text.size()) {
    const std::size_t bytes = plain_bytes(text.substr(same));
    if (bytes == 0) break;
    same += bytes;
  }
  if (same == text.size()) return std::nullopt;
  std::string out(text.substr(0, same));
  while (same < text.size()) {
    const std::size_t bytes = plain_bytes(text.substr(same));
    if (bytes == 0) {
      add_stand_in(out, at(text, same));
    } else {
      out += text.substr(same, bytes);
    }
    same += std::max<std::size_t>(bytes, 1);
  }
  return out;
}

std::optional<std::string> from_database(std::string_view text) {
  std::size_t next = text.find("\xF4\x8F");
  if (next == std::string_view::npos) return std::nullopt;
  std::string out;
  while (next != std::string_view::npos) {
    out += text.substr(0, next);
    text.remove_prefix(next);
    if (is_stand_in(text)) {
      out += static_cast<char>(((at(text, 2) & 0x03U) << 6U) | (at(text, 3) & 0x3FU));
      text.remove_prefix(kStandInBytes);
    } else {
      out += text.substr(0, 2);
      text.remove_prefix(2);
    }
    next = text.find("\xF4\x8F");
  }
  out += text;
  return out;
}

}  // namespace dripfeed::postgresql
