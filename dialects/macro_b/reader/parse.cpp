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

using ir::ExpressionId;
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

void Parser::words() {
  raw_.clear();
  while (!cursor_.at_end() && !faults_.failed()) word();
  if (!faults_.failed() && faults_.native().empty()) lowering_.lower(raw_, place());
}

void Parser::word() {
  if (cursor_.kind() != TokenKind::address) return other_word();
  const char letter = cursor_.front();
  const text::Span address = cursor_.span();
  if (letter == 'N') return block_number();
  cursor_.advance();
  const std::uint32_t value_index = cursor_.index();
  const ExpressionId value = expressions_.word_value();
  if (faults_.failed()) return;
  if (value == ExpressionId::none) return word_without_value(address);
  raw_.push_back({letter, false, value, {address.begin, cursor_.previous_end()}});
  if (!cursor_.at_end() && cursor_.kind() != TokenKind::address) bare_expression(address, value_index);
}

void Parser::word_without_value(text::Span address) {
  const std::string letter(address.in(cursor_.whole_text()));
  if (cursor_.is_symbol('=')) {
    faults_.fail(syntax_error, cursor_.span(), {fmt::format("{} takes no = before its value", letter)});
  } else if (cursor_.kind() == TokenKind::invalid) {
    character_fault();
  } else {
    faults_.fail(address_without_value, address, {letter});
  }
}

// X#106+50.: the control takes #106 and finds +50. without an address. It is read as it was meant, so that the other
// faults of the block are found too; the fix puts brackets around it.
void Parser::bare_expression(text::Span address, std::uint32_t value_index) {
  const Keyword* keyword = expressions_.keyword();
  const bool infix = keyword != nullptr && keyword->role == KeywordRole::infix;
  const ir::Expression& value = program_.at(raw_.back().value);
  const bool divides = cursor_.is_symbol('/') && value.op != ir::Operator::constant;
  if (!infix && !divides && !cursor_.is_symbol('+') && !cursor_.is_symbol('-') && !cursor_.is_symbol('*')) return;
  const std::uint32_t begin = value.span.begin;
  cursor_.back_to(value_index);
  const ExpressionId whole = expressions_.expression(address.in(cursor_.whole_text()));
  if (faults_.failed()) return;
  const bool begins_with_variable = program_.at(raw_.back().value).op == ir::Operator::variable;
  raw_.back().value = whole;
  const text::Span span = {begin, cursor_.previous_end()};
  raw_.back().span.end = span.end;
  if (grammar_.bare_expressions && begins_with_variable) return;
  text::Diagnostic* fault = faults_.report(expression_without_brackets, {address.begin, span.end},
                                           {std::string(address.in(cursor_.whole_text()))});
  if (fault != nullptr) fault->fix = text::Edit{span, fmt::format("[{}]", span.in(cursor_.whole_text()))};
}

void Parser::other_word() {
  if (cursor_.is_symbol(',')) return comma_word();
  if (cursor_.kind() == TokenKind::string) {
    raw_.push_back({'<', false, ExpressionId::none, cursor_.span()});
    cursor_.advance();
  } else if (cursor_.is_symbol('[') && !raw_.empty() && raw_.front().span.in(cursor_.whole_text()) == "G10") {
    faults_.make_native("G10");  // data in brackets, as memory dumps hold them
    while (!cursor_.at_end()) cursor_.advance();
  } else if (cursor_.is_symbol('/')) {
    rest_of_block();
  } else if (cursor_.kind() == TokenKind::number) {
    faults_.fail(value_without_address, cursor_.span(), {std::string(cursor_.text())});
  } else if (cursor_.kind() == TokenKind::variable && !raw_.empty()) {
    faults_.fail(statement_not_alone, cursor_.span(), {"the macro statement"});
  } else if (const Keyword* keyword = expressions_.keyword(); keyword != nullptr && !raw_.empty()) {
    faults_.fail(statement_not_alone, cursor_.span(), {std::string(keyword->spelling)});
  } else {
    unexpected();
  }
}

// What comes after "/" or "/n" inside a block is left out while that switch is on.
void Parser::rest_of_block() {
  cursor_.advance();
  std::uint8_t level = 1;
  if (!cursor_.at_end() && cursor_.kind() == TokenKind::number) {
    const std::string_view digits = cursor_.text();
    if (digits.size() != 1 || digits.front() < '1' || digits.front() > '9') {
      faults_.fail(skip_level_invalid, cursor_.span(), {std::string(digits)});
      return;
    }
    level = static_cast<std::uint8_t>(digits.front() - '0');
    cursor_.advance();
  }
  // Of two, the second would need both switches to be known.
  if (rest_level_ != 0) {
    faults_.make_native("block skip twice inside a block");
    while (!cursor_.at_end()) cursor_.advance();
    return;
  }
  rest_level_ = level;
  rest_begin_ = cursor_.previous_end();
}

// ,C ,R and ,A: chamfer, corner radius and angle of direct drawing input.
void Parser::comma_word() {
  const std::uint32_t begin = cursor_.span().begin;
  cursor_.advance();
  if (cursor_.kind() != TokenKind::address) {
    faults_.fail(syntax_error, {begin, begin + 1}, {"a comma needs an address after it"});
    return;
  }
  const char letter = cursor_.front();
  const text::Span address = {begin, cursor_.span().end};
  cursor_.advance();
  const ExpressionId value = expressions_.word_value();
  if (faults_.failed()) return;
  if (value == ExpressionId::none) return word_without_value(address);
  raw_.push_back({letter, true, value, {begin, cursor_.previous_end()}});
}

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
