// Two thirds of an excerpt stand before the place: a fault is often at the end of what it is about.
#include "dialects/text/excerpt.h"

#include <algorithm>

namespace dripfeed::text {

namespace {

constexpr std::string_view kCut = "...";

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

// Back to where a character begins. Bytes that are no UTF-8 are cut anywhere.
std::size_t character_begin(std::string_view text, std::size_t at) {
  constexpr std::size_t kLongestCharacter = 4;
  for (std::size_t back = 0; back < kLongestCharacter && at >= back; ++back) {
    if (at - back >= text.size() || !is_continuation(text[at - back])) return at - back;
  }
  return at;
}

}  // namespace

Excerpt excerpt_of(std::string_view line, std::size_t at) {
  at = std::min(at, line.size());
  if (line.size() <= kExcerptBytes) return {std::string(line), at};
  std::size_t begin = at - std::min(at, kExcerptBytes * 2 / 3);
  begin = std::min(begin, line.size() - kExcerptBytes);
  const std::size_t end = character_begin(line, begin + kExcerptBytes);
  begin = character_begin(line, begin);
  // A character more at the beginning is one too many.
  while (end - begin > kExcerptBytes && begin < at) {
    ++begin;
    while (begin < at && is_continuation(line[begin])) ++begin;
  }
  Excerpt out;
  if (begin > 0) out.text = kCut;
  out.place = out.text.size() + (at - begin);
  out.text += line.substr(begin, end - begin);
  if (end < line.size()) out.text += kCut;
  return out;
}

std::string shortened(std::string_view word) {
  if (word.size() <= kExcerptBytes) return std::string(word);
  return std::string(word.substr(0, character_begin(word, kExcerptBytes))) + std::string(kCut);
}

}  // namespace dripfeed::text
