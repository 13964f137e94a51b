// Where ISO mode begins and ends in a text. What its blocks say is another reader's.
#include <algorithm>
#include <string>
#include <utility>

#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/tables/whole_number.h"

namespace dripfeed::sinumerik {

using ir::TokenKind;
using text::DiagnosticId;

namespace {

constexpr std::uint32_t kSiemensMode = 290;
constexpr std::uint32_t kIsoMode = 291;

// POPEN, GOTO10, END1: words of Custom Macro B, with a number or without.
bool is_of_macro_language(std::string_view name) {
  constexpr std::string_view kWords[] = {"POPEN", "PCLOS", "GOTO", "IF", "THEN", "WHILE", "DO", "END"};
  name = name.substr(0, name.find_last_not_of("0123456789") + 1);
  return std::ranges::any_of(kWords, [name](std::string_view word) { return same_name(name, word); });
}

}  // namespace

// After G291 the blocks are those of another language, and are kept as written until G290, which stands alone in its
// block; only their end is seen. Comments stand in brackets there, or after a semicolon as here.
bool Parser::iso_line(text::Span start) {
  cursor_.skip_blanks();
  const bool is_head = cursor_.kind() == TokenKind::tape_mark && cursor_.text().starts_with("%_N_");
  const bool ends = switches_mode(kSiemensMode);
  const bool again = switches_mode(kIsoMode);
  resumes_iso_ = is_head ? control_.semantics.starts_in_iso_mode : again || (!ends && calls_from_iso_mode());
  if (ends || is_head || resumes_iso_) end_iso_mode(start.begin, ends);
  if (ends || again) {
    switch_line(start);
    return true;
  }
  if (!in_iso_ || cursor_.at_block_end()) return false;
  const text::Span head = cursor_.span();
  std::uint32_t end = kNoNumber;
  int comment = 0;
  for (TokenCursor probe = cursor_; !probe.at_block_end(); probe.advance()) {
    comment += static_cast<int>(probe.is_symbol('(')) - static_cast<int>(probe.is_symbol(')'));
    const TokenCursor next = probe.after();
    if (comment > 0 || probe.kind() != TokenKind::address || next.kind() != TokenKind::number) continue;
    const std::uint32_t number = whole_number(next.text());
    if (to_upper(probe.first()) == 'M' && (number == 2 || number == 30)) end = 30;
    if (to_upper(probe.first()) == 'M' && (number == 17 || number == 99)) end = 17;
  }
  if (end != kNoNumber) lower_.add_m_code(end, 0, head);
  if (const std::uint32_t code = named_switch(); code != 0)
    report(DiagnosticId::statement_not_alone, head, {"G" + std::to_string(code)});
  skip_block();
  lower_.keep_as_native(kInIsoMode, false, to_here(head), true);
  finish_line(start);
  return true;
}

// The block does nothing but that. Comments stand in brackets here.
void Parser::switch_line(text::Span start) {
  block_head();
  cursor_ = after_comments(cursor_);
  lower_.add_code(*find_g_code(kSiemensMode), cursor_.span());
  skip_block();
  finish_line(start);
}

bool Parser::is_code(const TokenCursor& at, char letter) {
  return at.kind() == TokenKind::address && at.span().size() == 1 && to_upper(at.first()) == letter &&
         at.after().kind() == TokenKind::number;
}

TokenCursor Parser::after_block_number() const {
  TokenCursor probe = after_comments(cursor_);
  if (probe.kind() == TokenKind::skip) probe.advance();
  const bool main_block = probe.is_symbol(':') && probe.after().kind() == TokenKind::number;
  if (!main_block && !is_code(probe, 'N')) return probe;
  probe.advance();
  probe.advance();
  return probe;
}

// A call as Siemens mode writes it, which ISO mode takes, too (Diagnostics Manual, alarm 12710; from memory).
bool Parser::calls_from_iso_mode() const {
  const TokenCursor probe = after_block_number();
  if (probe.kind() != TokenKind::name || is_of_macro_language(probe.text())) return false;
  if (const Keyword* keyword = find_keyword(probe.text())) {
    constexpr Verb kCalls[] = {Verb::call, Verb::call_modal, Verb::call_path, Verb::call_external, Verb::call_iso};
    return std::ranges::find(kCalls, keyword->verb) != std::end(kCalls);
  }
  return probe.after().is_symbol('(') || probe.after().at_block_end();
}

// G290 or G291, alone in its block but for comments in brackets.
bool Parser::switches_mode(std::uint32_t code) const {
  TokenCursor probe = after_block_number();
  if (!is_code(probe, 'G') || whole_number(probe.after().text()) != code) return false;
  probe.advance();
  probe.advance();
  return after_comments(probe).at_block_end();
}

TokenCursor Parser::after_comments(TokenCursor at) {
  while (at.is_symbol('(')) {
    while (!at.at_block_end() && !at.is_symbol(')')) at.advance();
    if (!at.at_block_end()) at.advance();
  }
  return at;
}

// Of a block that does not switch: the switch in it, which is not alone; 0 without one.
std::uint32_t Parser::named_switch() const {
  int comment = 0;
  for (TokenCursor probe = cursor_; !probe.at_block_end(); probe.advance()) {
    comment += static_cast<int>(probe.is_symbol('(')) - static_cast<int>(probe.is_symbol(')'));
    if (comment > 0 || !is_code(probe, 'G')) continue;
    const std::uint32_t number = whole_number(probe.after().text());
    if (number == kSiemensMode || number == kIsoMode) return number;
  }
  return 0;
}

// The part begins with the statement that switches, and with the text after its block.
void Parser::begin_iso_mode(std::uint32_t statement, std::uint32_t text_begin) {
  if (std::exchange(in_iso_, true)) return;
  program_.foreign_parts.push_back({.first = statement, .last = statement, .text = {text_begin, text_begin}});
}

void Parser::end_iso_mode(std::uint32_t text_end, bool by_switch) {
  in_iso_ = false;
  ir::ForeignPart& part = program_.foreign_parts.back();
  part.ends_by_switch = by_switch;
  part.last = static_cast<std::uint32_t>(program_.statements.size());
  part.text.end = text_end;
}

}  // namespace dripfeed::sinumerik
