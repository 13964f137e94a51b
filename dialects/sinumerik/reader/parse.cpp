// Lines and words. Every step of a line takes at least one token, so that any text comes to its end.
#include "dialects/sinumerik/reader/parse.h"

#include <algorithm>
#include <utility>

#include "dialects/sinumerik/reader/data_file.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/tables/whole_number.h"
#include "dialects/text/look_alike.h"

namespace dripfeed::sinumerik {

using ir::TokenKind;
using text::DiagnosticId;

Parser::Parser(ir::Program& program, const ir::Control& control, std::vector<text::Diagnostic>& diagnostics)
    : program_(program),
      control_(control),
      diagnostics_(diagnostics),
      lower_(program),
      cursor_(program.source.text(), program.tokens),
      has_invalid_(
          std::ranges::any_of(program.tokens, [](const ir::Token& t) { return t.kind == TokenKind::invalid; })) {}

void Parser::run() {
  if (control_.semantics.starts_in_iso_mode) begin_iso_mode(0, 0);
  while (!cursor_.at_text_end()) line();
  if (in_iso_) end_iso_mode(static_cast<std::uint32_t>(program_.source.text().size()), false);
  if (!program_.sections.empty())
    program_.sections.back().last = static_cast<std::uint32_t>(program_.statements.size());
}

void Parser::line() {
  faulty_ = false;
  in_condition_ = false;
  brackets_ = 0;
  operators_ = 0;
  repeats_ = ir::ExpressionId::none;
  has_call_ = false;
  operator_ = {};
  const text::Span start = cursor_.span();
  lower_.begin_line(line_, cursor_.index());
  if (in_iso_ && iso_line(start)) return;
  if (has_invalid_ && !in_other_data_) unreadable_tokens();
  cursor_.skip_blanks();
  if (cursor_.kind() == TokenKind::tape_mark) tape_head();
  if (in_other_data_) {
    lower_.keep_as_native("DATA", true, cursor_.span());
    return finish_line(start);
  }
  block_head();
  while (!cursor_.at_block_end()) {
    const std::uint32_t before = cursor_.index();
    statement();
    if (cursor_.index() == before) stray_symbol();
  }
  finish_line(start);
}

void Parser::finish_line(text::Span start) {
  if (repeats_ != ir::ExpressionId::none && !has_call_) {
    ir::Word p;
    p.address = ir::Address::p;
    p.value = repeats_;
    p.span = repeats_span_;
    lower_.add_word(p);
  }
  while (!cursor_.at_text_end() && cursor_.kind() != TokenKind::eob) cursor_.step();
  const text::Span end = cursor_.span();
  if (!cursor_.at_text_end()) cursor_.step();
  lower_.end_line(cursor_.index(), {start.begin, end.begin});
  ++line_;
  if (std::exchange(resumes_iso_, false))
    begin_iso_mode(static_cast<std::uint32_t>(program_.statements.size()), cursor_.span().begin);
}

// The characters that the control cannot read are reported, and no fault that follows from them.
void Parser::unreadable_tokens() {
  TokenCursor probe = cursor_;
  for (; !probe.at_text_end() && probe.kind() != TokenKind::eob; probe.step()) {
    if (probe.kind() != TokenKind::invalid) continue;
    const std::string_view bytes = probe.text();
    const text::Character character = text::read_character(bytes);
    const std::uint32_t begin = probe.span().begin;
    const text::Span span = {begin, begin + std::min(character.length, probe.span().size())};
    const char alike = text::look_alike(character.code_point);
    const std::string shown = text::describe_character(bytes);
    if (static_cast<unsigned char>(bytes.front()) >= 0x80 && alike != '?' && alike != '\0' && alike != ' ') {
      report(DiagnosticId::homoglyph, span, {shown, std::string(1, alike)});
    } else {
      report(DiagnosticId::invalid_character, span, {shown});
    }
    faulty_ = true;
  }
  if (faulty_) lower_.keep_as_native("unreadable", false, cursor_.span());
}

// "%_N_SHAFT_MPF": the head of a file on a serial line names the program; each further one begins another file of the
// same stream.
void Parser::tape_head() {
  std::string_view head = cursor_.text().substr(1);
  while (!head.empty() && (head.back() == ' ' || head.back() == '\t')) head.remove_suffix(1);
  if (head.size() > 3 && same_name(head.substr(0, 3), "_N_")) head.remove_prefix(3);
  in_other_data_ = false;
  if (head.size() > 4 && head[head.size() - 4] == '_') {
    in_other_data_ = is_other_ending(head.substr(head.size() - 3));
    head.remove_suffix(4);
  }
  if (head.empty() || !std::ranges::all_of(head, is_name_character)) return;
  const std::string name(UpperName(head).view());
  const bool has_blocks = std::ranges::any_of(
      program_.statements, [](const ir::Statement& s) { return s.kind != ir::StatementKind::empty; });
  if (std::exchange(has_head_, true) || has_blocks) {
    open_section(name);
    lower_.begin_program();
    macros_.clear();
  } else {
    program_.name = name;
  }
}

void Parser::open_section(const std::string& name) {
  const auto first = static_cast<std::uint32_t>(program_.statements.size());
  std::vector<ir::Section>& sections = program_.sections;
  if (sections.empty()) sections.push_back({.name = program_.strings.add(program_.name), .first = 0});
  sections.back().last = first;
  sections.push_back({.name = program_.strings.add(name), .first = first, .last = first});
}

// '/' with its level, N10 or :10, labels.
void Parser::block_head() {
  if (cursor_.kind() == TokenKind::skip) {
    const std::string_view digits = cursor_.text().substr(1);
    if (digits.size() > 1) report(DiagnosticId::skip_level_invalid, cursor_.span(), {std::string(digits)});
    lower_.set_skip_level(static_cast<std::uint8_t>(digits.empty() ? 1 : digits.front() - '0' + 1));
    cursor_.advance();
  }
  const text::Span head = cursor_.span();
  const bool subblock = cursor_.kind() == TokenKind::address && to_upper(cursor_.first()) == 'N';
  if (subblock || cursor_.is_symbol(':')) {
    cursor_.advance();
    if (cursor_.kind() == TokenKind::number) {
      const std::uint32_t number = whole_number(cursor_.text());
      if (number == kNoNumber) report(DiagnosticId::malformed_number, cursor_.span(), {here()});
      cursor_.advance();
      if (number != kNoNumber) lower_.add_block_number(number, to_here(head));
    } else {
      report(DiagnosticId::address_without_value, head, {std::string(head.in(cursor_.whole()))});
    }
  }
  while (label_here()) {
  }
}

// L1, a letter and a number in one: by the manual a label begins with two letters, but programs have such ones.
text::Span Parser::short_label() const {
  if (cursor_.kind() != TokenKind::address || cursor_.span().size() != 1 || to_upper(cursor_.first()) == 'N') return {};
  const TokenCursor digits = cursor_.after();
  const bool joined = digits.kind() == TokenKind::number && digits.span().begin == cursor_.span().end &&
                      std::ranges::all_of(digits.text(), is_digit);
  return joined ? text::Span{cursor_.span().begin, digits.span().end} : text::Span{};
}

bool Parser::label_here() {
  if (const text::Span name = short_label(); !name.empty()) {
    TokenCursor colon = cursor_.after();
    colon.advance();
    if (!colon.is_symbol(':')) return false;
    lower_.add_label(name.in(cursor_.whole()), name);
    colon.advance();
    cursor_.go_to(colon.index());
    return true;
  }
  if (cursor_.kind() != TokenKind::name || !cursor_.after().is_symbol(':')) return false;
  if (go_to_verb(cursor_.text())) return false;  // GOTO :100
  lower_.add_label(cursor_.text(), cursor_.span());
  cursor_.advance();
  cursor_.advance();
  return true;
}

void Parser::statement() {
  if (expand_macro()) return;
  switch (cursor_.kind()) {
    case TokenKind::address:
      if (cursor_.span().size() > 1) {
        extended_address();
      } else {
        address_word();
      }
      return;
    case TokenKind::variable: variable_statement(); return;
    case TokenKind::name: name_statement(); return;
    case TokenKind::number:
      report(DiagnosticId::value_without_address, cursor_.span(), {here()});
      lower_.keep_as_native("value without address", false, cursor_.span());
      cursor_.advance();
      return;
    case TokenKind::white:
    case TokenKind::eob:
    case TokenKind::comment:
    case TokenKind::tape_mark:
    case TokenKind::skip:
    case TokenKind::string:
    case TokenKind::symbol:
    case TokenKind::invalid: stray_symbol(); return;
  }
}

void Parser::stray_symbol() {
  if (cursor_.is_symbol('=')) return missing_target();
  // $MN_… = 1 '2a3f: the check sum that the control writes after machine data.
  if (cursor_.is_symbol('\'') && is_data_file(program_)) return skip_block();
  if (cursor_.is_symbol(')') || cursor_.is_symbol(']') || cursor_.is_symbol('(') || cursor_.is_symbol('[')) {
    return give_up(DiagnosticId::unbalanced_bracket, cursor_.span(), {here()});
  }
  give_up(DiagnosticId::syntax_error, cursor_.span(), {here() + " is not expected here"});
}

void Parser::variable_statement() {
  const text::Span head = cursor_.span();
  const ir::VariableId target = variable();
  assignment(target, head);
}

// Defined in the program, or in a definition file of the control.
bool Parser::is_variable(std::string_view name) const {
  if (lower_.is_declared(lower_.find_symbol(name))) return true;
  return control_.shared != nullptr && control_.shared->variables.contains(UpperName(name).view());
}

// XV=IC(3): only a word takes its value so, and a word of a free name is an axis of the machine.
bool Parser::is_axis_word() const {
  const TokenCursor equals = cursor_.after();
  if (!equals.is_symbol('=')) return false;
  const TokenCursor mode = equals.after();
  const Keyword* keyword = mode.kind() == TokenKind::name ? find_keyword(mode.text()) : nullptr;
  return keyword != nullptr && keyword->role == Role::word_mode && mode.after().is_symbol('(');
}

void Parser::name_statement() {
  const text::Span head = cursor_.span();
  const std::string_view name = cursor_.text();
  const Keyword* keyword = find_keyword(name);
  const bool variable_here = is_variable(name);
  const bool axis_word = same_name(name, "AX") && !variable_here && cursor_.after().is_symbol('[');
  const bool is_declared_program = externs_.contains(program_.strings.find(UpperName(name).view()));
  if (is_declared_program && (keyword == nullptr || keyword->role != Role::statement)) {
    cursor_.advance();
    return call_by_name(lower_.name(name), head);
  }
  if (keyword != nullptr && !axis_word && !(variable_here && keyword->role != Role::statement))
    return statement_of(*keyword, head);
  const TokenCursor next = cursor_.after();
  if (same_name(name, "AX") && next.is_symbol('[')) return named_axis_word(head);
  const bool assigned = next.is_symbol('=') || next.is_symbol('[');
  if (!variable_here && is_axis_word()) {
    cursor_.advance();
    return word(ir::Address::other, 0, lower_.name(name), head);
  }
  if (!variable_here && !assigned) {
    if (const GCode* code = find_named_code(name)) {
      cursor_.advance();
      if (cursor_.is_symbol('(')) no_parameters(head, code->group == 0);
      return lower_.add_code(*code, head);
    }
    cursor_.advance();
    return call_by_name(lower_.name(name), head);
  }
  const ir::VariableId target = variable();
  assignment(target, head);
}

// STOPRE(1), G functions in brackets: what is predefined without parameters takes none (12090).
void Parser::no_parameters(text::Span head, bool may_be_empty) {
  cursor_.advance();
  int given = cursor_.is_symbol(')') ? 0 : 1;
  for (int open = 0; !cursor_.at_block_end() && (open > 0 || !cursor_.is_symbol(')')); cursor_.advance()) {
    open += cursor_.is_symbol('(') ? 1 : cursor_.is_symbol(')') ? -1 : 0;
    given += open == 0 && cursor_.is_symbol(',') ? 1 : 0;
  }
  expect(')');
  if (given == 0 && may_be_empty) return;
  report(DiagnosticId::wrong_argument_count, to_here(head),
         {std::string(head.in(cursor_.whole())), "no", std::to_string(given)});
  if (!faulty_) diagnostics_.back().alarm = "12090";
}

void Parser::report(DiagnosticId id, text::Span span, std::vector<std::string> arguments) {
  if (!faulty_) diagnostics_.push_back(ir::diagnose(control_, id, span, std::move(arguments)));
}

void Parser::give_up(DiagnosticId id, text::Span span, std::vector<std::string> arguments) {
  report(id, span, std::move(arguments));
  lower_.keep_as_native("syntax error", false, span);
  faulty_ = true;
  skip_block();
}

void Parser::expect(char symbol) {
  if (!cursor_.take(symbol)) report(DiagnosticId::missing_bracket, cursor_.span(), {std::string(1, symbol)});
}

void Parser::skip_block() {
  while (!cursor_.at_block_end()) cursor_.advance();
}

std::string Parser::here() const {
  return cursor_.at_block_end() ? std::string("the end of the block") : std::string(cursor_.text());
}

}  // namespace dripfeed::sinumerik
