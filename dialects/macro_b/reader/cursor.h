// A place in the tokens of a program, block by block: blanks and comments are stepped over and comments remembered,
// and the faults of the block are collected next to it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/token.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// Faults go to one list for the whole program; failed() is of the current block. A text that is not a program at all
// has a fault in every line, so that the list ends at kMostFaults.
class Faults {
 public:
  static constexpr std::size_t kMostFaults = 2000;
  Faults(const ir::Control& control, std::vector<text::Diagnostic>& diagnostics)
      : control_(control), diagnostics_(diagnostics) {}

  // `detail` chooses among the control's alarms where the block shows more than the id does. Returns what was
  // added, valid until the next report; nullptr when the list is full.
  text::Diagnostic* report(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments = {},
                           ir::AlarmDetail detail = ir::AlarmDetail::none);
  // The same, and the block is not understood; nullptr for the second fault of a block, which only follows from the
  // first.
  text::Diagnostic* fail(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments = {},
                         ir::AlarmDetail detail = ir::AlarmDetail::none);
  // Not understood, and said already or no fault: `name` states what it is.
  void make_native(std::string_view name) { native_ = name; }

  void begin_block() { failed_ = false, native_ = {}; }
  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] std::string_view native() const { return native_; }

 private:
  const ir::Control& control_;
  std::vector<text::Diagnostic>& diagnostics_;
  bool failed_ = false;
  std::string_view native_;
};

class Cursor {
 public:
  // `tokens` ends with an eob, which may be empty.
  Cursor(std::string_view text, std::span<const ir::Token> tokens) : text_(text), tokens_(tokens) {}

  // To the token of that index, or the next one that counts.
  void move_to(std::uint32_t index) {
    index_ = index;
    comments_.clear();
    skip_blanks();
  }
  void advance() {
    previous_end_ = span().end;
    ++index_;
    skip_blanks();
  }
  // Back to a token of the same block that was the current one before.
  void back_to(std::uint32_t index) { index_ = index; }
  // At the end of the block: nothing more to advance over.
  [[nodiscard]] bool at_end() const { return kind() == ir::TokenKind::eob || kind() == ir::TokenKind::tape_mark; }

  [[nodiscard]] std::uint32_t index() const { return index_; }
  [[nodiscard]] ir::TokenKind kind() const { return tokens_[index_].kind; }
  [[nodiscard]] text::Span span() const { return tokens_[index_].span; }
  [[nodiscard]] std::string_view text() const { return span().in(text_); }
  [[nodiscard]] char front() const { return text_[span().begin]; }
  [[nodiscard]] bool is_symbol(char c) const { return kind() == ir::TokenKind::symbol && front() == c; }
  // Where the token before the current one ended, comments and blanks left out.
  [[nodiscard]] std::uint32_t previous_end() const { return previous_end_; }
  // The next token that counts after the current one, on the same block; an eob at its end.
  [[nodiscard]] const ir::Token& peek() const;
  [[nodiscard]] std::string_view whole_text() const { return text_; }

  // Comments stepped over since move_to.
  [[nodiscard]] std::span<const text::Span> comments() const { return comments_; }

 private:
  void skip_blanks() {
    while (tokens_[index_].kind == ir::TokenKind::white || tokens_[index_].kind == ir::TokenKind::comment) {
      if (tokens_[index_].kind == ir::TokenKind::comment) comments_.push_back(tokens_[index_].span);
      ++index_;
    }
  }

  std::string_view text_;
  std::span<const ir::Token> tokens_;
  std::uint32_t index_ = 0;
  std::uint32_t previous_end_ = 0;
  std::vector<text::Span> comments_;
};

}  // namespace dripfeed::macro_b
