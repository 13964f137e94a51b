// What may stand before the first %.
#include "dialects/macro_b/reader/tape_marks.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace dripfeed::macro_b {

bool begins_with_tape_mark(const ir::Program& program) {
  using ir::TokenKind;
  const auto is_leader = [](const ir::Token& t) {
    return t.kind == TokenKind::white || t.kind == TokenKind::eob || t.kind == TokenKind::invalid;
  };
  const auto is_label = [&](const ir::Token& t) { return is_leader(t) || t.kind == TokenKind::comment; };
  const auto is_mark = [](const ir::Token& t) { return t.kind == TokenKind::tape_mark; };
  const auto first = std::ranges::find_if_not(program.tokens, is_leader);
  if (first != program.tokens.end() && is_mark(*first)) return true;
  // Text before a % that a program number follows is a label, too, whatever it says.
  const auto any_mark = std::ranges::find_if(program.tokens, is_mark);
  const auto is_number_at = [&](auto at) {
    const std::string_view written = at->span.in(program.source.text());
    const bool begins = at->kind == TokenKind::address ? written == "O" : written == ":";
    return begins && std::next(at) != program.tokens.end() && std::next(at)->kind == TokenKind::number;
  };
  if (any_mark != program.tokens.end()) {
    bool has_number = false;
    for (auto at = program.tokens.begin(); at != any_mark; ++at) has_number |= is_number_at(at);
    const auto after = std::find_if_not(std::next(any_mark), program.tokens.end(), is_label);
    if (!has_number && after != program.tokens.end() && is_number_at(after)) return true;
  }
  const auto mark = std::ranges::find_if_not(program.tokens, is_label);
  return mark != program.tokens.end() && is_mark(*mark) &&
         !std::all_of(std::next(mark), program.tokens.end(), is_label);
}

}  // namespace dripfeed::macro_b
