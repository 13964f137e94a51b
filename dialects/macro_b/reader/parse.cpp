// Blocks one after the other: head (skip, O, N), then a macro statement or the words of an NC block. A block that is
// not understood becomes a Native statement of unknown effect, so that nothing after it is taken for certain.
#include "dialects/macro_b/reader/parse.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dialects/ir/sections.h"
#include "dialects/macro_b/reader/tape_marks.h"
#include "dialects/text/look_alike.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using ir::StatementKind;
using ir::TokenKind;
using enum text::DiagnosticId;

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

}  // namespace

Parser::Parser(ir::Program& program, const ir::Control& control, const Grammar& grammar,
               std::vector<text::Diagnostic>& diagnostics)
    : program_(program),
      grammar_(grammar),
      keywords_(grammar.keywords),
      cursor_(program.source.text(), program.tokens),
      faults_(control, diagnostics),
      expressions_(program, control, grammar, keywords_, cursor_, faults_),
      lowering_(program, control, grammar, faults_),
      of_machine_(control.from_profile) {}

void Parser::run() {
  const std::size_t lines = program_.source.line_count();
  program_.statements.reserve(lines + 16);
  program_.blocks.reserve(lines);
  program_.codes.reserve(lines);
  program_.words.reserve(lines * 3);
  program_.expressions.reserve(lines * 3);
  leader_ = begins_with_tape_mark(program_);
  const auto count = static_cast<std::uint32_t>(program_.tokens.size());
  cursor_.move_to(0);
  while (next_token_ + 1 < count) block();
  if (!program_.sections.empty())
    program_.sections.back().last = static_cast<std::uint32_t>(program_.statements.size());
  name_main();
  ir::match_structures(program_);
}

// The first program that has blocks: a number alone (O0002, then O9811) runs nothing.
void Parser::name_main() {
  for (const ir::Section& section : program_.sections) {
    if (ir::is_empty(program_, section)) continue;
    program_.name = program_.strings.at(section.name);
    return;
  }
}

BlockPlace Parser::place() const {
  return {line_, skip_level_, {begin_, std::max(begin_, cursor_.previous_end())}, rest_level_, rest_begin_};
}

void Parser::block() {
  const auto first_statement = static_cast<std::uint32_t>(program_.statements.size());
  const std::uint32_t first_token = next_token_;
  faults_.begin_block();
  expressions_.begin_block();
  label_ = ir::kNoIndex;
  section_name_.clear();
  skip_level_ = 0;
  rest_level_ = 0;
  keeps_structure_ = false;
  skip_leader();
  begin_ = cursor_.span().begin;
  if (cursor_.kind() == TokenKind::tape_mark) {
    ended_ = !leader_ || tape_marks_ > 0 || ended_;
    ++tape_marks_;
    cursor_.advance();
  } else if (leader_ && tape_marks_ == 0) {
    skip_label();
  } else if (ended_) {
    skip_after_end();
  } else {
    head();
    begin_ = cursor_.span().begin;
    if (!faults_.failed()) body();
    while (!cursor_.at_end()) cursor_.advance();
    if (!cursor_.comments().empty()) comment_faults();
  }
  finish_block(first_statement, first_token);
}

// The control reads from the first % on; before it stand a leader or an editor's mark of UTF-8.
void Parser::skip_leader() {
  const bool is_leader = leader_ && tape_marks_ == 0;
  const bool is_mark = cursor_.index() == 0 && cursor_.kind() == TokenKind::invalid && cursor_.text() == kUtf8Mark;
  if (is_mark && !is_leader) {
    text::Diagnostic* fault =
        faults_.report(invalid_character, cursor_.span(), {text::describe_character(cursor_.text())});
    fault->severity = text::Severity::warning;
    fault->alarm.clear();
    fault->fix = text::Edit{cursor_.span(), std::string()};
  }
  if (is_mark) cursor_.advance();
  while (is_leader && cursor_.kind() == TokenKind::invalid) cursor_.advance();
}

// Nor is what comes before the first one. A title is none that one would miss.
void Parser::skip_label() {
  const bool has_words = cursor_.kind() == TokenKind::address && cursor_.peek().kind == TokenKind::number;
  if (has_words && !std::exchange(reported_label_, true)) faults_.report(unreachable, cursor_.span());
  while (!cursor_.at_end()) cursor_.advance();
}

// What comes after the closing tape mark is not read by the control.
void Parser::skip_after_end() {
  if (!cursor_.at_end() && !std::exchange(reported_after_end_, true)) faults_.report(unreachable, cursor_.span());
  while (!cursor_.at_end()) cursor_.advance();
}

void Parser::finish_block(std::uint32_t first_statement, std::uint32_t first_token) {
  if (faults_.failed() || !faults_.native().empty()) {
    if (!keeps_structure_) {
      program_.statements.resize(first_statement);
      lowering_.emit_native(faults_.failed() ? kNotUnderstood : faults_.native(), false, place());
    }
  }
  if (!section_name_.empty()) open_section(first_statement);
  if (program_.statements.size() == first_statement) lowering_.emit(StatementKind::empty, ir::kNoIndex, place());
  std::uint32_t end = cursor_.index();
  if (cursor_.kind() == TokenKind::eob) {
    const text::Span eob = cursor_.span();
    ++end;
    if (!eob.empty() && eob.in(cursor_.whole_text()) != ";") ++line_;
  }
  ir::Statement& first = program_.statements[first_statement];
  first.tokens = {first_token, std::min(end, static_cast<std::uint32_t>(program_.tokens.size()) - 1)};
  if (label_ != ir::kNoIndex) {
    first.is_label = true;
    program_.labels.push_back({ir::StringId::none, label_, first_statement, label_span_});
  }
  next_token_ = end;
  if (end < program_.tokens.size()) cursor_.move_to(end);
}

// What stands before the first O number belongs to the program that it names.
void Parser::open_section(std::uint32_t first_statement) {
  std::vector<ir::Section>& sections = program_.sections;
  const std::uint32_t first = sections.empty() ? 0 : first_statement;
  if (!sections.empty()) sections.back().last = first_statement;
  sections.push_back({.name = program_.strings.add(section_name_), .first = first, .last = first});
}

void Parser::head() {
  while (!faults_.failed() && !cursor_.at_end()) {
    if (cursor_.kind() == TokenKind::skip) {
      skip_level_ = cursor_.span().size() == 2 ? static_cast<std::uint8_t>(cursor_.text()[1] - '0') : 1;
      cursor_.advance();
    } else if (cursor_.kind() == TokenKind::address && cursor_.front() == 'N') {
      block_number();
    } else if ((cursor_.kind() == TokenKind::address && cursor_.front() == 'O') || cursor_.is_symbol(':') ||
               cursor_.kind() == TokenKind::string) {
      program_number();
    } else {
      return;
    }
  }
}

void Parser::block_number() {
  const std::uint32_t begin = cursor_.span().begin;
  cursor_.advance();
  if (cursor_.kind() != TokenKind::number) {
    faults_.fail(address_without_value, {begin, begin + 1}, {"N"});
    return;
  }
  const text::Span span = {begin, cursor_.span().end};
  const auto number = text::parse_integer(cursor_.text());
  if (!number) {
    faults_.fail(decimal_point_not_allowed, span, {"N"});
  } else if (*number > grammar_.highest_block_number) {
    faults_.report(too_many_digits, span,
                   {std::string(cursor_.text()), std::to_string(cursor_.text().size()),
                    std::to_string(std::to_string(grammar_.highest_block_number).size())},
                   ir::AlarmDetail::block_number);
  } else if (*number == 0) {
    zero_number("N0", span);
  } else if (label_ == ir::kNoIndex) {
    label_ = static_cast<std::uint32_t>(*number);
    label_span_ = span;
  }
  cursor_.advance();
}

// O1234, :1234, O<NAME> and <NAME>. The first one names the program.
void Parser::program_number() {
  const text::Span head_span = cursor_.span();
  if (cursor_.kind() != TokenKind::string) cursor_.advance();
  std::string name;
  if (cursor_.kind() == TokenKind::number) {
    const auto number = text::parse_integer(cursor_.text());
    if (!number) {
      faults_.fail(decimal_point_not_allowed, cursor_.span(), {"O"});
      return;
    }
    name = macro_b::program_name(static_cast<double>(*number));
    if (*number == 0) zero_program(cursor_.span());
  } else if (cursor_.kind() == TokenKind::string) {
    const std::string_view written = cursor_.text();
    name = written.size() > 2 ? written.substr(1, written.size() - 2) : std::string_view();
  } else {
    faults_.fail(address_without_value, head_span, {"O"});
    return;
  }
  if (program_.name.empty()) program_.name = name;
  section_name_ = name;
  cursor_.advance();
}

// An error where the control has an alarm for it.
void Parser::zero_number(std::string_view written, text::Span span) {
  text::Diagnostic* fault = faults_.report(number_zero, span, {std::string(written)});
  if (fault != nullptr && !fault->alarm.empty()) fault->severity = text::Severity::error;
}

// O0000 is what many programs are posted with; whoever stores them gives the number.
void Parser::zero_program(text::Span span) {
  text::Diagnostic* fault = faults_.report(number_zero, span, {"O0"}, ir::AlarmDetail::program_number);
  if (fault != nullptr)
    fault->notes.push_back({span, "a number that is given when the program is stored takes its place"});
}

void Parser::body() {
  if (cursor_.at_end()) return;
  if (has_nested_comment()) {
    if (!only_brackets_follow()) {
      faults_.fail(nested_comment, cursor_.comments().back());
      return;
    }
    warn_of_brackets();
    return;
  }
  if (cursor_.kind() == TokenKind::variable) {
    assignment();
    return trailer();
  }
  if (const Keyword* keyword = expressions_.keyword();
      keyword != nullptr && keyword->role != KeywordRole::function && keyword->role != KeywordRole::infix) {
    macro_statement(*keyword);
    return trailer();
  }
  if (cursor_.is_symbol('&')) {
    lowering_.emit_native(kFolderLine, true, place());
    while (!cursor_.at_end()) cursor_.advance();
    return;
  }
  if (cursor_.is_symbol('[') && cursor_.peek().kind == TokenKind::variable) {
    if (!expressions_.has_names()) return faults_.make_native("a variable with a name");
    bracketed_target_ = true;
    cursor_.advance();
    assignment();
    return trailer();
  }
  words();
}

}  // namespace dripfeed::macro_b
