// Words of the tables that begin with what stands before the cursor. Where words may touch each other (G01G41), the
// last letter with its digits, or the last letters, are a word.
#include <algorithm>
#include <string_view>

#include "dialects/compile/dialect/comment_style.h"
#include "dialects/text/upper_case.h"
#include "server/lsp/features.h"

namespace dripfeed::lsp {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '$' || c == '#'; }

// "N10G01X": of a name the whole, of touching words the last one.
std::string_view beginning_of(std::string_view before, bool may_touch) {
  std::size_t begin = before.size();
  const auto back_over = [&](auto&& belongs) {
    while (begin > 0 && belongs(before[begin - 1])) --begin;
  };
  if (may_touch) {
    back_over([](char c) { return is_digit(c) || c == '.'; });
    back_over(is_letter);
  } else {
    back_over([](char c) { return is_digit(c) || is_letter(c) || c == '.'; });
  }
  return before.substr(begin);
}

}  // namespace

std::vector<Proposal> proposals_at(const Subject& of, Position at) {
  std::vector<Proposal> out;
  if (of.reading.is_family) return out;
  const std::uint32_t end = of.offset_of(at);
  const text::Span line = of.text.lines().span_of(at.line);
  const std::string_view before = text::Span{std::min(line.begin, end), end}.in(of.text.source().text());
  const bool may_touch = of.reading.language.dialect->comments == compile::CommentStyle::brackets;
  const std::string_view begun = beginning_of(before, may_touch);
  const std::string wanted = text::upper_case(begun);
  const Range replaced = of.range_of({end - static_cast<std::uint32_t>(begun.size()), end});
  for (const compile::DialectWord& word : of.reading.words.words())
    if (word.spelling.starts_with(wanted)) out.push_back({&word, replaced});
  return out;
}

}  // namespace dripfeed::lsp
