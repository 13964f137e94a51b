// Words are kept by one spelling: capitals, and of codes no zeros in front.
#include "dialects/compile/dialect/word_index.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "dialects/text/number.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using ir::TokenKind;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

// "g002" as "G2"; what is no letter with a number as it is, in capitals.
std::string key_of(std::string_view written) {
  std::string key = text::upper_case(written);
  if (key.size() < 3 || !is_letter(key.front()) || !is_digit(key[1])) return key;
  const std::size_t last_zero = key.size() - 2;
  std::size_t zeros = 1;
  while (zeros <= last_zero && key[zeros] == '0' && is_digit(key[zeros + 1])) ++zeros;
  return key.erase(1, zeros - 1);
}

bool has_value_after_it(TokenKind kind) { return kind == TokenKind::address || kind == TokenKind::variable; }
bool is_of_a_word(TokenKind kind) {
  return has_value_after_it(kind) || kind == TokenKind::number || kind == TokenKind::name;
}

}  // namespace

WordIndex::WordIndex(std::vector<DialectWord> words) : words_(std::move(words)) {
  for (std::size_t i = 0; i < words_.size(); ++i) by_key_.try_emplace(key_of(words_[i].spelling), i);
}

const DialectWord* WordIndex::find(std::string_view written) const {
  if (const auto found = by_key_.find(key_of(written)); found != by_key_.end()) return &words_[found->second];
  if (!written.starts_with('#')) return nullptr;
  const auto number = text::parse_integer(written.substr(1));
  if (!number) return nullptr;
  const auto holds = [&](const DialectWord& word) {
    if (word.last == 0 || !word.spelling.starts_with('#')) return false;
    const auto first = text::parse_integer(std::string_view(word.spelling).substr(1));
    return first && *number >= *first && *number <= word.last;
  };
  const auto range = std::ranges::find_if(words_, holds);
  return range == words_.end() ? nullptr : &*range;
}

std::optional<text::Span> written_word_at(const ir::Program& program, std::uint32_t offset) {
  const auto& tokens = program.tokens;
  auto at = std::ranges::upper_bound(tokens, offset, {}, [](const ir::Token& one) { return one.span.begin; });
  if (at == tokens.begin()) return std::nullopt;
  --at;
  if (!is_of_a_word(at->kind) && at->span.begin == offset && at != tokens.begin()) --at;
  if (!is_of_a_word(at->kind) || offset > at->span.end) return std::nullopt;
  text::Span span = at->span;
  const auto next = std::next(at);
  if (at->kind == TokenKind::number && at != tokens.begin() && has_value_after_it(std::prev(at)->kind))
    span.begin = std::prev(at)->span.begin;
  else if (has_value_after_it(at->kind) && next != tokens.end() && next->kind == TokenKind::number)
    span.end = next->span.end;
  return span;
}

}  // namespace dripfeed::compile
