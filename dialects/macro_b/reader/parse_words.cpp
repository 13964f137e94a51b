// The words of an NC block: an address and its value, a call by a name, a chamfer after a comma, block skip inside.
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "dialects/macro_b/reader/parse.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::TokenKind;
using enum text::DiagnosticId;

}  // namespace

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

}  // namespace dripfeed::macro_b
