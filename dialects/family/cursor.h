// Where the reader stands in the lexemes, what it accepts, and what it reports. After the first fault of a line nothing
// more is reported of that line: readers go on with what they have and the line is left out.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/family/lexer.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::family {

class Cursor {
 public:
  Cursor(std::string_view text, std::vector<Lexeme> lexemes) : text_(text), lexemes_(std::move(lexemes)) {}

  [[nodiscard]] const Lexeme& peek(std::size_t ahead = 0) const {
    const std::size_t last = lexemes_.size() - 1;
    return lexemes_[at_ + ahead < last ? at_ + ahead : last];
  }
  [[nodiscard]] std::string_view word(std::size_t ahead = 0) const { return peek(ahead).span.in(text_); }
  [[nodiscard]] bool at_word(std::string_view wanted) const {
    return peek().kind == LexemeKind::word && word() == wanted;
  }
  [[nodiscard]] bool at_symbol(std::string_view wanted, std::size_t ahead = 0) const {
    return peek(ahead).kind == LexemeKind::symbol && word(ahead) == wanted;
  }
  [[nodiscard]] bool at_line_end() const { return peek().kind == LexemeKind::end_of_line; }
  [[nodiscard]] bool at_end() const { return at_ + 1 >= lexemes_.size() && at_line_end(); }
  [[nodiscard]] std::string_view text() const { return text_; }
  // Span of what was taken last.
  [[nodiscard]] text::Span last_span() const { return last_span_; }

  void advance();
  bool accept_word(std::string_view wanted);
  bool accept_symbol(std::string_view wanted);
  // A fault when it is not there.
  bool expect_word(std::string_view wanted);
  bool expect_symbol(std::string_view wanted);
  // A string without its quotes, when one stands here.
  std::optional<std::string> accept_string();
  // A name with hyphens, as families and kinds of machines have it ("mill-turn"); empty after a fault.
  std::string expect_hyphenated(std::string_view what);
  // A whole number without unit, 0..99999999; 0 after a fault.
  std::int32_t expect_integer(std::string_view what);

  // To the start of the next line; a fault when something is left of this one.
  void finish_line();
  // To the start of the next line without a word.
  void skip_line();

  [[nodiscard]] bool line_failed() const { return line_failed_; }
  void report(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments);
  void report(text::Diagnostic diagnostic);
  // "expected …, found …" here.
  void expected(std::string_view what);
  // The same, with the word that is most like the one found.
  void expected_one_of(std::string_view what, std::span<const std::string_view> words);
  void syntax(text::Span span, std::string sentence);

  std::vector<text::Diagnostic> diagnostics;

 private:
  std::string_view text_;
  std::vector<Lexeme> lexemes_;
  std::size_t at_ = 0;
  text::Span last_span_;
  bool line_failed_ = false;
};

}  // namespace dripfeed::family
