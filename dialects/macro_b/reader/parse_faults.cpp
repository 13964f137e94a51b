// What of a block has no meaning: characters of no code table, brackets too many, comments in comments.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dialects/macro_b/reader/parse.h"
#include "dialects/text/look_alike.h"

namespace dripfeed::macro_b {

namespace {

using ir::TokenKind;
using enum text::DiagnosticId;

}  // namespace

void Parser::unexpected() {
  if (cursor_.kind() == TokenKind::invalid) return character_fault();
  const std::string written(cursor_.text());
  if (cursor_.is_symbol(']')) {
    faults_.fail(unbalanced_bracket, cursor_.span(), {written});
  } else if (cursor_.is_symbol('=')) {
    faults_.fail(missing_target, cursor_.span());
  } else if (cursor_.is_symbol(')')) {
    const bool nested = std::ranges::any_of(
        cursor_.comments(), [&](text::Span s) { return s.in(cursor_.whole_text()).substr(1).contains('('); });
    if (nested && only_brackets_follow()) return warn_of_brackets();
    if (nested) faults_.fail(nested_comment, cursor_.span());
    faults_.fail(unbalanced_bracket, cursor_.span(), {written});
  } else {
    faults_.fail(syntax_error, cursor_.span(), {fmt::format("{} has no meaning here", written)});
  }
}

void Parser::character_fault() {
  const std::string_view bytes = cursor_.text();
  const char looks = text::look_alike(text::read_character(bytes).code_point);
  const bool lower_case = bytes.size() == 1 && bytes.front() >= 'a' && bytes.front() <= 'z';
  const bool is_open = lower_case && !of_machine_;
  const bool shows = looks != '?' && looks != ' ' && looks != '\0';
  if (is_open && std::exchange(reported_lower_case_, true)) {
    faults_.make_native(kNotUnderstood);
    while (!cursor_.at_end()) cursor_.advance();
    return;
  }
  text::Diagnostic* fault =
      shows ? faults_.fail(homoglyph, cursor_.span(), {text::describe_character(bytes), std::string(1, looks)})
            : faults_.fail(invalid_character, cursor_.span(), {text::describe_character(bytes)});
  if (fault == nullptr) return;
  if (looks != '?') fault->fix = text::Edit{cursor_.span(), looks == '\0' ? std::string() : std::string(1, looks)};
  if (lower_case) fault->fix = text::Edit{cursor_.span(), std::string(1, static_cast<char>(bytes.front() - 'a' + 'A'))};
  if (!is_open) return;
  // Some controls read them as capitals, others skip what their code table does not have: once a program.
  fault->severity = text::Severity::warning;
  fault->alarm.clear();
}

// (OUTER (INNER)): a bracket that ends no comment is left, and nothing else.
bool Parser::only_brackets_follow() const {
  for (std::uint32_t i = cursor_.index(); program_.tokens[i].kind != TokenKind::eob; ++i) {
    const ir::Token& token = program_.tokens[i];
    const bool is_bracket = token.kind == TokenKind::symbol && token.span.in(cursor_.whole_text()) == ")";
    if (!is_bracket && token.kind != TokenKind::white && token.kind != TokenKind::comment) return false;
  }
  return true;
}

// Controls pass over a bracket that ends no comment; not every manual says so.
void Parser::warn_of_brackets() {
  if (text::Diagnostic* fault = faults_.report(nested_comment, cursor_.comments().back())) {
    fault->severity = text::Severity::warning;
    fault->alarm.clear();
  }
  while (!cursor_.at_end()) cursor_.advance();
}

// (OUTER (INNER) REST) ends at the first closing bracket, and REST) is read as program.
bool Parser::has_nested_comment() const {
  if (cursor_.comments().empty()) return false;
  if (!cursor_.comments().back().in(cursor_.whole_text()).substr(1).contains('(')) return false;
  for (std::uint32_t i = cursor_.index(); program_.tokens[i].kind != TokenKind::eob; ++i) {
    const ir::Token& token = program_.tokens[i];
    if (token.kind == TokenKind::symbol && token.span.in(cursor_.whole_text()) == ")") return true;
  }
  return false;
}

void Parser::comment_faults() {
  for (const text::Span span : cursor_.comments()) {
    const std::string_view comment = span.in(cursor_.whole_text());
    if (!comment.ends_with(')')) faults_.report(unterminated_comment, span);
    if (const auto mark = comment.find('%'); mark != std::string_view::npos) {
      const auto at = span.begin + static_cast<std::uint32_t>(mark);
      // An error where the control has an alarm for it.
      text::Diagnostic* fault = faults_.report(tape_mark_in_comment, {at, at + 1});
      if (fault != nullptr && fault->alarm.empty()) fault->severity = text::Severity::warning;
    }
  }
}

}  // namespace dripfeed::macro_b
