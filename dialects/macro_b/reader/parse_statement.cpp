// The macro statements of the parser: assignments, messages, IF, GOTO, loops, and those that stay text.
#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "dialects/macro_b/reader/parse.h"
#include "dialects/macro_b/tables/variables.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::StatementKind;
using ir::TokenKind;
using enum text::DiagnosticId;

}  // namespace

// After a macro statement the block must end.
void Parser::trailer() {
  if (cursor_.at_end() || faults_.failed() || !faults_.native().empty()) return;
  if (cursor_.kind() == TokenKind::address || cursor_.kind() == TokenKind::name) {
    faults_.fail(statement_not_alone, {begin_, cursor_.previous_end()}, {"the macro statement"});
  } else {
    unexpected();
  }
}

void Parser::macro_statement(const Keyword& keyword) {
  switch (keyword.role) {
    case KeywordRole::if_word: return if_statement();
    case KeywordRole::go_to: return go_to(ExpressionId::none);
    case KeywordRole::while_word: return while_statement();
    case KeywordRole::do_word: return loop_begin(ExpressionId::none, false);
    case KeywordRole::end_word: return loop_end();
    case KeywordRole::else_word:
    case KeywordRole::end_if:
      cursor_.advance();
      return structure(keyword.role == KeywordRole::end_if ? StatementKind::if_end : StatementKind::else_begin,
                       ExpressionId::none, 0);
    case KeywordRole::output: return output_statement(keyword);
    case KeywordRole::set_name: return set_names();
    case KeywordRole::unmodelled_function: return text_statement(keyword);
    case KeywordRole::then_word:
    case KeywordRole::function:
    case KeywordRole::infix: return unexpected();
  }
}

void Parser::text_statement(const Keyword& keyword) {
  while (!cursor_.at_end()) cursor_.advance();
  lowering_.emit_native(keyword.spelling, keyword.role == KeywordRole::output, place());
}

namespace {

// #100 and neither [53] nor a further index after it.
bool has_field_missing(std::string_view text) {
  for (std::size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1)) {
    const std::size_t end = text.find_first_not_of("0123456789", at + 1);
    const bool is_index = at > 1 && text[at - 1] == '[';  // #[#1]
    if (!is_index && end != at + 1 && (end == std::string_view::npos || text[end] != '[')) return true;
  }
  return false;
}

}  // namespace

// POPEN, PCLOS, DPRNT[TEXT #1[53]]; other forms stay text.
void Parser::output_statement(const Keyword& keyword) {
  const std::string_view word = keyword.spelling;
  if (word != "POPEN" && word != "PCLOS" && word != "DPRNT") return text_statement(keyword);
  ir::Output output;
  output.kind = word == "POPEN" ? ir::OutputKind::open : word == "PCLOS" ? ir::OutputKind::close : ir::OutputKind::line;
  output.first_part = static_cast<std::uint32_t>(program_.output_parts.size());
  cursor_.advance();
  if (output.kind == ir::OutputKind::line) {
    if (cursor_.kind() != TokenKind::string || !output_parts(cursor_.text(), cursor_.span().begin)) {
      program_.output_parts.resize(output.first_part);
      const std::string_view text = cursor_.text();
      const bool opened = cursor_.kind() == TokenKind::string;
      if (opened && std::ranges::count(text, '[') > std::ranges::count(text, ']'))
        return void(faults_.fail(missing_bracket, cursor_.span(), {fmt::format("] of {}", word)},
                                 ir::AlarmDetail::closing_bracket));
      if (opened && has_field_missing(text))
        return void(faults_.fail(syntax_error, cursor_.span(), {"a variable without its field, as in #100[53]"},
                                 ir::AlarmDetail::output_statement));
      return text_statement(keyword);
    }
    cursor_.advance();
  }
  output.part_count = static_cast<std::uint32_t>(program_.output_parts.size()) - output.first_part;
  program_.outputs.push_back(output);
  lowering_.emit(StatementKind::output, static_cast<std::uint32_t>(program_.outputs.size() - 1), place());
}

// [X#100[53]*Y#101[53]]: an asterisk is a blank, two digits are the places before and after the point.
bool Parser::output_parts(std::string_view text, std::uint32_t begin) {
  if (text.size() < 2 || !text.ends_with(']')) return false;
  std::string words;
  std::size_t i = 1;
  while (i + 1 < text.size()) {
    if (text[i] != '#') {
      words += text[i] == '*' ? ' ' : text[i];
      ++i;
      continue;
    }
    const std::size_t end = text.find_first_not_of("0123456789", i + 1);
    const bool has_field = end != std::string_view::npos && end > i + 1 && end + 3 < text.size() && text[end] == '[' &&
                           text[end + 3] == ']';
    const auto number = has_field ? text::parse_integer(text.substr(i + 1, end - i - 1)) : std::nullopt;
    if (!number || *number > 99'999'999 || text[end + 1] < '0' || text[end + 1] > '9' || text[end + 2] < '0' ||
        text[end + 2] > '9')
      return false;
    ir::Variable variable;
    variable.number = static_cast<std::uint32_t>(*number);
    variable.span = {begin + static_cast<std::uint32_t>(i), begin + static_cast<std::uint32_t>(end)};
    program_.output_parts.push_back({.text = program_.strings.add(words),
                                     .value = program_.add_variable(variable),
                                     .whole_digits = static_cast<std::uint8_t>(text[end + 1] - '0'),
                                     .decimals = static_cast<std::uint8_t>(text[end + 2] - '0')});
    words.clear();
    i = end + 4;
  }
  if (!words.empty()) program_.output_parts.push_back({.text = program_.strings.add(words)});
  return i + 1 == text.size();  // otherwise the last field took the bracket that closes all
}

// Of eight letters and digits at most, a letter first (0i-F B-64604EN, "Setting of a name"); some controls take seven.
void Parser::check_variable_name(std::string_view name) {
  constexpr std::size_t kMost = kLongestVariableName;
  const auto begin = static_cast<std::uint32_t>(name.data() - cursor_.whole_text().data());
  const text::Span span{begin, begin + static_cast<std::uint32_t>(name.size())};
  const auto is_letter = [](char c) { return c >= 'A' && c <= 'Z'; };
  const bool plain =
      std::ranges::all_of(name, [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; });
  if (name.empty() || !plain || !is_letter(name.front()))
    faults_.report(syntax_error, span, {fmt::format("{} is not a name of a variable", name)},
                   ir::AlarmDetail::name_characters);
  else if (name.size() > kMost)
    faults_.report(name_too_long, span, {std::string(name), std::to_string(name.size()), std::to_string(kMost)},
                   ir::AlarmDetail::name_statement);
}

// SETVN 101[NAME1,NAME2]: from here on [#NAME1] is #101.
void Parser::set_names() {
  cursor_.advance();
  const auto first = cursor_.kind() == TokenKind::number ? text::parse_integer(cursor_.text()) : std::nullopt;
  if (first) cursor_.advance();
  if (!first || cursor_.kind() != TokenKind::string) {
    faults_.fail(syntax_error, {begin_, std::max(begin_, cursor_.previous_end())}, {"SETVN needs a number and [NAMES]"},
                 ir::AlarmDetail::name_statement);
    return;
  }
  std::string_view names = cursor_.text();
  names.remove_prefix(1);
  if (names.ends_with(']')) names.remove_suffix(1);
  auto number = static_cast<std::uint32_t>(std::clamp<std::int64_t>(*first, 0, 99'999'999));
  while (!names.empty()) {
    const std::string_view name = names.substr(0, names.find(','));
    check_variable_name(name);
    if (expressions_.names_other(name, number)) {
      const auto begin = static_cast<std::uint32_t>(name.data() - cursor_.whole_text().data());
      const text::Span span{begin, begin + static_cast<std::uint32_t>(name.size())};
      text::Diagnostic* fault = faults_.report(name_defined_twice, span, {std::string(name)});
      if (fault != nullptr && fault->alarm.empty()) fault->severity = text::Severity::warning;
    }
    names.remove_prefix(std::min(names.size(), name.size() + 1));
    expressions_.name_variable(name, number++);
  }
  cursor_.advance();
  lowering_.emit_native("SETVN", true, place());
}

void Parser::structure(StatementKind kind, ExpressionId condition, std::uint8_t number) {
  ir::Structure structure;
  structure.condition = condition;
  structure.loop_number = number;
  program_.structures.push_back(structure);
  lowering_.emit(kind, static_cast<std::uint32_t>(program_.structures.size() - 1), place());
}

// One #i = expression, or several with commas between them.
void Parser::assignment() {
  while (!faults_.failed()) {
    begin_ = cursor_.span().begin;
    const auto target = expressions_.variable();
    if (!target) return;
    if (std::exchange(bracketed_target_, false) && cursor_.is_symbol(']')) cursor_.advance();
    if (!cursor_.is_symbol('=')) {
      faults_.fail(missing_equals, target->span, {std::string(target->span.in(cursor_.whole_text()))});
      return;
    }
    cursor_.advance();
    const ExpressionId value = expressions_.expression("=");
    if (faults_.failed()) return;
    const bool fixed = target->index == ExpressionId::none;
    if (fixed && (target->number == kAlarmVariable || target->number == kMessageVariable)) {
      message(*target, value);
    } else {
      lowering_.emit_assign(*target, value, place());
    }
    const bool listed = cursor_.is_symbol(',') && cursor_.peek().kind == TokenKind::variable;
    if (listed) {
      cursor_.advance();
    } else if (cursor_.kind() == TokenKind::variable) {
      warn_of_second_statement();
    } else {
      const Keyword* keyword = expressions_.keyword();
      if (keyword == nullptr || keyword->role != KeywordRole::go_to) return;
      warn_of_second_statement();
      begin_ = cursor_.span().begin;
      return go_to(ExpressionId::none);
    }
  }
}

// #1=2 #3=4 and #1=2 GOTO 5: the manuals forbid NC words together with a macro statement (PS0127), and do not say what
// a second macro statement is. Once a program.
void Parser::warn_of_second_statement() {
  if (std::exchange(reported_second_statement_, true)) return;
  text::Diagnostic* fault = faults_.report(statement_not_alone, cursor_.span(), {"the second macro statement"});
  if (fault == nullptr) return;
  fault->severity = text::Severity::warning;
  fault->alarm.clear();
  fault->notes.push_back({fault->span, "some controls take several macro statements in a block"});
}

// #3000 = n(TEXT) stops with an alarm, #3006 = n(TEXT) with a message; the text is a comment after the number.
void Parser::message(const ir::Variable& target, ExpressionId value) {
  ir::Message message;
  message.number = value;
  const auto comments = cursor_.comments();
  const auto text = std::ranges::find_if(comments, [&](text::Span s) { return s.begin >= target.span.end; });
  if (text != comments.end()) {
    std::string_view inner = text->in(cursor_.whole_text()).substr(1);
    if (inner.ends_with(')')) inner.remove_suffix(1);
    ir::Expression string;
    string.op = ir::Operator::string;
    string.string = program_.strings.add(inner);
    string.span = *text;
    message.text = program_.add(string);
  }
  program_.messages.push_back(message);
  const bool is_alarm = target.number == kAlarmVariable;
  lowering_.emit(is_alarm ? StatementKind::alarm : StatementKind::message,
                 static_cast<std::uint32_t>(program_.messages.size() - 1), place());
  if (!is_alarm) lowering_.emit_code(ir::Function::program_stop, ir::ModalGroup::flow, place());
}

void Parser::if_statement() {
  cursor_.advance();
  const ExpressionId condition = expressions_.condition("IF");
  if (faults_.failed()) return;
  const Keyword* next = expressions_.keyword();
  if (next != nullptr && next->role == KeywordRole::go_to) return go_to(condition);
  const bool has_then = next != nullptr && next->role == KeywordRole::then_word;
  if (!has_then && (!grammar_.then_may_lack || cursor_.at_end())) {
    if (cursor_.kind() != TokenKind::variable) {
      faults_.fail(syntax_error, {begin_, cursor_.previous_end()}, {"IF needs GOTO or THEN after its condition"},
                   ir::AlarmDetail::if_statement);
      return;
    }
    warn_of_no_then();
  }
  if (has_then) cursor_.advance();
  structure(StatementKind::if_begin, condition, 0);
  if (cursor_.at_end()) return;  // THEN over several blocks
  one_macro_statement("THEN");
  if (!faults_.failed()) structure(StatementKind::if_end, ExpressionId::none, 0);
}

// IF [#1 GT 0] #2=3: memory dumps of machines at work hold it, and manuals have it with THEN alone.
void Parser::warn_of_no_then() {
  text::Diagnostic* fault =
      faults_.report(syntax_error, {begin_, cursor_.previous_end()}, {"IF needs GOTO or THEN after its condition"},
                     ir::AlarmDetail::if_statement);
  if (fault == nullptr) return;
  fault->severity = text::Severity::warning;
  fault->notes.push_back({fault->span, "some controls read the statement as that after THEN"});
}

void Parser::one_macro_statement(std::string_view after) {
  begin_ = cursor_.span().begin;
  if (cursor_.kind() == TokenKind::variable) return assignment();
  const Keyword* keyword = expressions_.keyword();
  if (keyword != nullptr && keyword->role == KeywordRole::go_to) return go_to(ExpressionId::none);
  const std::size_t before = program_.statements.size();
  if (cursor_.kind() == TokenKind::address) words();
  const bool is_call = !faults_.failed() && program_.statements.size() == before + 1 &&
                       (program_.statements.back().kind == StatementKind::call ||
                        program_.statements.back().kind == StatementKind::native);
  if (!is_call) {
    faults_.fail(statement_not_alone, {begin_, std::max(begin_, cursor_.previous_end())},
                 {fmt::format("the NC block after {}", after)});
  }
}

void Parser::go_to(ExpressionId condition) {
  cursor_.advance();
  ir::Jump jump;
  jump.condition = condition;
  const text::Span at = cursor_.span();
  const ExpressionId target = expressions_.word_value();
  if (faults_.failed()) return;
  if (target == ExpressionId::none) {
    faults_.fail(missing_operand, at, {"GOTO"});
    return;
  }
  const ir::Expression& value = program_.at(target);
  if (value.op != ir::Operator::constant) {
    jump.computed = target;
  } else if (value.value < 1.0 || value.value > grammar_.highest_block_number ||
             (value.has_point && at.in(cursor_.whole_text()) != "[")) {
    faults_.fail(syntax_error, at, {fmt::format("GOTO {} is not a block number", at.in(cursor_.whole_text()))},
                 ir::AlarmDetail::jump_number);
    return;
  } else {
    jump.number = static_cast<std::uint32_t>(value.value);
  }
  program_.jumps.push_back(jump);
  lowering_.emit(StatementKind::go_to, static_cast<std::uint32_t>(program_.jumps.size() - 1), place());
}

// A fault in the condition must not make its END look like one without a WHILE.
void Parser::while_statement() {
  cursor_.advance();
  const ExpressionId condition = expressions_.condition("WHILE");
  if (faults_.failed()) {
    while (!cursor_.at_end() &&
           (expressions_.keyword() == nullptr || expressions_.keyword()->role != KeywordRole::do_word)) {
      cursor_.advance();
    }
  }
  const Keyword* next = expressions_.keyword();
  if (next == nullptr || next->role != KeywordRole::do_word) {
    faults_.fail(syntax_error, {begin_, cursor_.previous_end()}, {"WHILE needs DO after its condition"},
                 ir::AlarmDetail::while_statement);
    return;
  }
  loop_begin(condition, condition != ExpressionId::none);
}

void Parser::loop_begin(ExpressionId condition, bool conditional) {
  const std::uint8_t number = loop_number("DO");
  structure(conditional ? StatementKind::while_begin : StatementKind::loop_begin, condition, number);
  open_loops_.push_back({number, conditional});
  keeps_structure_ = true;
}

// The closer's kind is its opener's: the innermost open loop of that number. Crossing loops are for validate to report.
void Parser::loop_end() {
  const std::uint8_t number = loop_number("END");
  const auto open = std::ranges::find(open_loops_.rbegin(), open_loops_.rend(), number, &OpenLoop::number);
  const bool conditional = open != open_loops_.rend() && open->conditional;
  if (open != open_loops_.rend()) open_loops_.erase(std::next(open).base());
  structure(conditional ? StatementKind::while_end : StatementKind::loop_end, ExpressionId::none, number);
  keeps_structure_ = true;
}

std::uint8_t Parser::loop_number(std::string_view word) {
  const std::uint32_t begin = cursor_.span().begin;
  cursor_.advance();
  std::string written;
  std::int64_t number = 0;
  text::Span span = {begin, cursor_.previous_end()};
  if (cursor_.kind() == TokenKind::number) {
    written = cursor_.text();
    number = text::parse_integer(written).value_or(0);
    span.end = cursor_.span().end;
    cursor_.advance();
  }
  if (number < 1 || number > grammar_.highest_loop_number) {
    faults_.report(loop_number_invalid, span, {fmt::format("{}{}", word, written)});
  }
  return static_cast<std::uint8_t>(std::clamp<std::int64_t>(number, 0, 255));
}

}  // namespace dripfeed::macro_b
