// Which words may touch is asked of the pair of tokens that a blank parts. Where that is not certain, one blank stays.
#include "server/app/library/letters_and_blanks.h"

#include <algorithm>
#include <string_view>

#include "server/app/library/same_program.h"

namespace dripfeed::app {

namespace {

using ir::StatementKind;
using ir::Token;
using ir::TokenKind;

// Its bytes are what it says.
bool writes_out(StatementKind kind) { return kind == StatementKind::output || kind == StatementKind::execute_text; }
// … or it is not known what they mean to the control.
bool may_count_blanks(StatementKind kind) { return writes_out(kind) || kind == StatementKind::native; }

// By token: it belongs to a block of such a kind, or to the control's other language.
std::vector<bool> tokens_to_leave(const ir::Program& program, bool (*is_left)(StatementKind kind)) {
  std::vector<bool> leave(program.tokens.size());
  ir::TokenRange block;
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    const ir::Statement& one = program.statements[i];
    if (one.tokens.first != one.tokens.last) block = one.tokens;
    if (is_left(one.kind) || is_foreign(program, i))
      std::fill(leave.begin() + block.first, leave.begin() + block.last, true);
  }
  for (std::uint32_t i = 0; i < program.tokens.size(); ++i)
    if (program.tokens[i].kind == TokenKind::tape_mark) leave[i] = true;
  return leave;
}

bool is_one_of(std::string_view written, std::string_view characters) {
  return written.size() == 1 && characters.find(written.front()) != std::string_view::npos;
}

class Spacing {
 public:
  Spacing(const ir::Program& program, const BlankOrder& order)
      : program_(program),
        order_(order),
        text_(program.source.text()),
        leave_(tokens_to_leave(program, may_count_blanks)) {}

  std::string run() {
    const TokenBlocks all = blocks_of(program_);
    std::uint32_t number = 0;
    for (const BlockTokens& block : all.blocks) {
      words_.clear();
      for (std::uint32_t i = block.first; i < block.last; ++i) words_.push_back(all.indexes[i]);
      const std::uint32_t end =
          number + 1 < all.blocks.size() ? all.blocks[number + 1].begin : static_cast<std::uint32_t>(text_.size());
      if (is_left(number))
        out_ += text_.substr(block.begin, end - block.begin);
      else
        put(block.begin, end);
      ++number;
    }
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool is_left(std::uint32_t number) const {
    return words_.empty() || std::ranges::binary_search(order_.left_blocks, number) ||
           std::ranges::any_of(words_, [this](std::uint32_t i) { return leave_[i]; });
  }

  void put(std::uint32_t begin, std::uint32_t end) {
    depth_ = 0;
    std::uint32_t at = begin;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const Token& word = program_.tokens[words_[i]];
      put_gap(text_.substr(at, word.span.begin - at), i);
      const std::string_view written = word.span.in(text_);
      if (word.kind == TokenKind::symbol) depth_ += is_one_of(written, "([") ? 1 : is_one_of(written, ")]") ? -1 : 0;
      out_ += written;
      at = word.span.end;
    }
    const std::string_view rest = text_.substr(at, end - at);  // blanks and the EOB
    const std::size_t blanks = rest.find_first_not_of(" \t");
    out_ += order_.blanks == Blanks::remove && blanks != std::string_view::npos ? rest.substr(blanks) : rest;
  }

  // Before the block's i-th word.
  void put_gap(std::string_view gap, std::size_t i) {
    const bool is_plain = gap.find_first_not_of(" \t") == std::string_view::npos;
    if (order_.blanks == Blanks::add) {
      out_ += gap.empty() && i > 0 && begins_word(i) ? " " : gap;
    } else if (!is_plain) {
      out_ += gap;
    } else if (!gap.empty() && i > 0 && !may_touch(i)) {
      out_ += ' ';
    }
  }

  [[nodiscard]] const Token& word(std::size_t i) const { return program_.tokens[words_[i]]; }
  [[nodiscard]] std::string_view written(std::size_t i) const { return word(i).span.in(text_); }

  // Whether the i-th word may stand at once after the one before it.
  [[nodiscard]] bool may_touch(std::size_t i) const {
    const TokenKind left = word(i - 1).kind;
    const TokenKind right = word(i).kind;
    if (left == TokenKind::comment || right == TokenKind::comment) return true;
    if (left == TokenKind::symbol && right == TokenKind::symbol)
      return is_one_of(written(i - 1), "()[],") || is_one_of(written(i), "()[],");
    if (right == TokenKind::symbol) return left != TokenKind::skip && !is_one_of(written(i), ":");
    if (left == TokenKind::symbol)
      return !is_one_of(written(i - 1), ":") && (order_.words_may_touch || !is_one_of(written(i - 1), ")]"));
    if (left == TokenKind::skip || left == TokenKind::string || right == TokenKind::string) return false;
    return order_.words_may_touch ? may_touch_anywhere(left, right) : is_plain_pair(i);
  }

  static bool may_touch_anywhere(TokenKind left, TokenKind right) {
    if (left == TokenKind::name) return right == TokenKind::number || right == TokenKind::variable;
    return left != TokenKind::address && !(left == TokenKind::number && right == TokenKind::number);
  }

  // "G1 X10": a letter with its number, then another one. Where names may have digits, all else is read by its blanks.
  [[nodiscard]] bool is_plain_pair(std::size_t i) const {
    const auto is_letter = [this](std::size_t at) {
      return word(at).kind == TokenKind::address && word(at).span.end - word(at).span.begin == 1;
    };
    if (word(i - 1).kind != TokenKind::number || i < 2 || !is_letter(i) || i + 1 >= words_.size()) return false;
    const bool has_sign = word(i - 2).kind == TokenKind::symbol && is_one_of(written(i - 2), "+-");
    if (has_sign ? i < 3 || !is_letter(i - 3) : !is_letter(i - 2)) return false;
    return word(i + 1).kind == TokenKind::number || is_one_of(written(i + 1), "+-");
  }

  // Whether a blank before the i-th word makes the line easier to read.
  [[nodiscard]] bool begins_word(std::size_t i) const {
    const TokenKind left = word(i - 1).kind;
    const TokenKind right = word(i).kind;
    if (right == TokenKind::comment) return left != TokenKind::comment;
    if (depth_ != 0 || (right != TokenKind::address && right != TokenKind::name && right != TokenKind::variable))
      return false;
    if (left == TokenKind::symbol) return is_one_of(written(i - 1), ")]") && right != TokenKind::variable;
    return left == TokenKind::number || left == TokenKind::comment || left == TokenKind::string;
  }

  const ir::Program& program_;
  const BlankOrder& order_;
  std::string_view text_;
  std::vector<bool> leave_;
  std::vector<std::uint32_t> words_;  // tokens of the block
  int depth_ = 0;                     // of brackets
  std::string out_;
};

bool has_letters_to_change(TokenKind kind) {
  switch (kind) {
    case TokenKind::address:
    case TokenKind::number:  // 1EX5
    case TokenKind::variable:
    case TokenKind::name:
    case TokenKind::symbol:
    case TokenKind::invalid: return true;  // a small letter, of which the control takes capitals only
    case TokenKind::white:
    case TokenKind::eob:
    case TokenKind::comment:
    case TokenKind::tape_mark:
    case TokenKind::skip:
    case TokenKind::string: return false;
  }
  return false;
}

}  // namespace

std::string with_blanks(const ir::Program& program, const BlankOrder& order) { return Spacing(program, order).run(); }

std::string with_case(const ir::Program& program, LetterCase wanted) {
  const char first = wanted == LetterCase::upper ? 'a' : 'A';
  const char shift = wanted == LetterCase::upper ? 'A' - 'a' : 'a' - 'A';
  const std::vector<bool> leave = tokens_to_leave(program, writes_out);
  std::string out(program.source.text());
  for (std::uint32_t i = 0; i < program.tokens.size(); ++i) {
    const Token& token = program.tokens[i];
    if (leave[i] || !has_letters_to_change(token.kind)) continue;
    for (std::uint32_t at = token.span.begin; at < token.span.end; ++at)
      if (out[at] >= first && out[at] < first + 26) out[at] = static_cast<char>(out[at] + shift);
  }
  return out;
}

}  // namespace dripfeed::app
