// Walks the tokens of one text, blanks and unreadable characters left out. A comment ends a block as its EOB does.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "dialects/ir/token.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/text/span.h"

namespace dripfeed::sinumerik {

class TokenCursor {
 public:
  TokenCursor(std::string_view text, std::span<const ir::Token> tokens) : text_(text), tokens_(tokens) {}

  [[nodiscard]] std::uint32_t index() const { return at_; }
  void go_to(std::uint32_t index) { at_ = index; }
  [[nodiscard]] bool at_text_end() const { return at_ >= tokens_.size(); }
  [[nodiscard]] ir::TokenKind kind() const { return at_text_end() ? ir::TokenKind::eob : tokens_[at_].kind; }
  [[nodiscard]] bool at_block_end() const {
    const ir::TokenKind k = kind();
    return k == ir::TokenKind::eob || k == ir::TokenKind::comment || k == ir::TokenKind::tape_mark;
  }
  [[nodiscard]] text::Span span() const {
    const auto end = static_cast<std::uint32_t>(text_.size());
    return at_text_end() ? text::Span{end, end} : tokens_[at_].span;
  }
  [[nodiscard]] std::string_view text() const { return span().in(text_); }
  [[nodiscard]] char first() const { return at_text_end() ? '\0' : text_[tokens_[at_].span.begin]; }
  // Where the last token that was advanced over ends.
  [[nodiscard]] std::uint32_t previous_end() const { return previous_end_; }
  [[nodiscard]] std::string_view whole() const { return text_; }

  // Where the line ends, after its EOB.
  [[nodiscard]] std::uint32_t line_end() const {
    TokenCursor probe = *this;
    while (!probe.at_text_end() && probe.kind() != ir::TokenKind::eob) probe.step();
    return probe.span().end;
  }
  // To the next token, whatever it is.
  void step() { ++at_; }
  // To the next token but blanks; at the end of the text it stays there.
  void advance() {
    if (at_text_end()) return;
    previous_end_ = tokens_[at_].span.end;
    ++at_;
    skip_blanks();
  }
  void skip_blanks() {
    while (at_ < tokens_.size() &&
           (tokens_[at_].kind == ir::TokenKind::white || tokens_[at_].kind == ir::TokenKind::invalid))
      ++at_;
  }

  [[nodiscard]] bool is_symbol(char c) const {
    return kind() == ir::TokenKind::symbol && first() == c && span().size() == 1;
  }
  [[nodiscard]] bool is_symbol(std::string_view s) const { return kind() == ir::TokenKind::symbol && text() == s; }
  [[nodiscard]] bool is_name(std::string_view upper) const {
    return kind() == ir::TokenKind::name && same_name(text(), upper);
  }
  // Takes the symbol when it is there.
  bool take(char c) {
    if (!is_symbol(c)) return false;
    advance();
    return true;
  }
  bool take_name(std::string_view upper) {
    if (!is_name(upper)) return false;
    advance();
    return true;
  }
  // A copy that stands at the token after this one.
  [[nodiscard]] TokenCursor after() const {
    TokenCursor next = *this;
    next.advance();
    return next;
  }

 private:
  std::string_view text_;
  std::span<const ir::Token> tokens_;
  std::uint32_t at_ = 0;
  std::uint32_t previous_end_ = 0;
};

}  // namespace dripfeed::sinumerik
