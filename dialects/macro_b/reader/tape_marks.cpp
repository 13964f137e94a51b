// What may stand before the first %.
#include "dialects/macro_b/reader/tape_marks.h"

#include <algorithm>
#include <iterator>

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
  const auto mark = std::ranges::find_if_not(program.tokens, is_label);
  return mark != program.tokens.end() && is_mark(*mark) &&
         !std::all_of(std::next(mark), program.tokens.end(), is_label);
}

}  // namespace dripfeed::macro_b
