// Accepting and reporting; see the header for the rule of one fault a line.
#include "dialects/family/cursor.h"

#include <utility>

#include <fmt/format.h>

#include "dialects/text/nearest.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

void Cursor::advance() {
  last_span_ = peek().span;
  if (at_ + 1 < lexemes_.size()) ++at_;
}

bool Cursor::accept_word(std::string_view wanted) {
  if (!at_word(wanted)) return false;
  advance();
  return true;
}

bool Cursor::accept_symbol(std::string_view wanted) {
  if (!at_symbol(wanted)) return false;
  advance();
  return true;
}

bool Cursor::expect_word(std::string_view wanted) {
  if (accept_word(wanted)) return true;
  expected(fmt::format("'{}'", wanted));
  return false;
}

bool Cursor::expect_symbol(std::string_view wanted) {
  if (accept_symbol(wanted)) return true;
  expected(fmt::format("'{}'", wanted));
  return false;
}

std::optional<std::string> Cursor::accept_string() {
  if (peek().kind != LexemeKind::string) return std::nullopt;
  const std::string_view quoted = word();
  advance();
  return std::string(quoted.substr(1, quoted.size() - 2));
}

std::string Cursor::expect_hyphenated(std::string_view what) {
  if (peek().kind != LexemeKind::word) {
    expected(what);
    return {};
  }
  text::Span span = peek().span;
  advance();
  while (!at_line_end() && peek().span.begin == span.end &&
         (at_symbol("-") || peek().kind == LexemeKind::word || peek().kind == LexemeKind::number)) {
    span.end = peek().span.end;
    advance();
  }
  return std::string(span.in(text_));
}

std::int32_t Cursor::expect_integer(std::string_view what) {
  const auto value = peek().kind == LexemeKind::number ? text::parse_integer(word()) : std::nullopt;
  if (!value || *value > 99'999'999) {
    expected(what);
    return 0;
  }
  advance();
  return static_cast<std::int32_t>(*value);
}

void Cursor::finish_line() {
  if (!at_line_end()) expected("the end of the line");
  skip_line();
}

void Cursor::skip_line() {
  while (!at_line_end()) advance();
  advance();
  line_failed_ = false;
}

void Cursor::report(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments) {
  report(text::make_diagnostic(id, span, std::move(arguments)));
}

void Cursor::report(text::Diagnostic diagnostic) {
  if (!std::exchange(line_failed_, true)) diagnostics.push_back(std::move(diagnostic));
}

void Cursor::expected(std::string_view what) {
  const Lexeme& here = peek();
  if (here.kind == LexemeKind::end_of_line) {
    syntax(here.span, fmt::format("expected {} before the end of the line", what));
  } else if (here.kind == LexemeKind::invalid && word().starts_with('"')) {
    syntax(here.span, "a string without its closing quote");
  } else {
    syntax(here.span, fmt::format("expected {}, found '{}'", what, word()));
  }
}

void Cursor::expected_one_of(std::string_view what, std::span<const std::string_view> words) {
  const std::string_view near = peek().kind == LexemeKind::word ? text::nearest_of(word(), words) : std::string_view();
  if (near.empty()) return expected(what);
  text::Diagnostic fault = text::make_diagnostic(text::DiagnosticId::family_syntax, peek().span,
                                                 {fmt::format("expected {}, found '{}'", what, word())});
  fault.notes.push_back({peek().span, fmt::format("did you mean {}?", near)});
  fault.fix = text::Edit{peek().span, std::string(near)};
  report(std::move(fault));
}

void Cursor::syntax(text::Span span, std::string sentence) {
  report(text::DiagnosticId::family_syntax, span, {std::move(sentence)});
}

}  // namespace dripfeed::family
