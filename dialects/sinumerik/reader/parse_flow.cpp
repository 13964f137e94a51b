// Jumps, labels as targets, and structures. CASE is lowered to jumps with comparisons on the spot, which share its
// selector.
#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using ir::TokenKind;
using text::DiagnosticId;

}  // namespace

std::optional<Verb> Parser::go_to_verb(std::string_view name) {
  const Keyword* keyword = find_keyword(name);
  if (keyword == nullptr || keyword->verb < Verb::go_to || keyword->verb > Verb::go_to_start) return std::nullopt;
  return keyword->verb;
}

void Parser::flow(Verb verb, text::Span head) {
  switch (verb) {
    case Verb::if_word: return if_statement(head);
    case Verb::else_word: return opener(StatementKind::else_begin, head, false);
    case Verb::end_if: return opener(StatementKind::if_end, head, false);
    case Verb::while_word: return opener(StatementKind::while_begin, head, true);
    case Verb::end_while: return opener(StatementKind::while_end, head, false);
    case Verb::for_word: return for_statement(head);
    case Verb::end_for: return opener(StatementKind::for_end, head, false);
    case Verb::loop: return opener(StatementKind::loop_begin, head, false);
    case Verb::end_loop: return opener(StatementKind::loop_end, head, false);
    case Verb::repeat: return repeat_statement(head, false);
    case Verb::repeat_block: return repeat_statement(head, true);
    case Verb::until: return opener(StatementKind::repeat_end, head, true);
    case Verb::case_word: return case_statement(head);
    case Verb::go_to:
    case Verb::go_to_forward:
    case Verb::go_to_backward:
    case Verb::go_to_tolerant:
    case Verb::go_to_start: return jump(verb, ir::ExpressionId::none, head);
    case Verb::none:
    case Verb::define:
    case Verb::procedure:
    case Verb::declare:
    case Verb::message:
    case Verb::alarm:
    case Verb::call:
    case Verb::call_path:
    case Verb::call_external:
    case Verb::call_iso:
    case Verb::execute:
    case Verb::macro:
    case Verb::call_modal:
    case Verb::return_word: return;
  }
}

ir::ExpressionId Parser::condition(text::Span head) {
  operator_ = head;
  in_condition_ = true;
  ir::ExpressionId value = expression();
  if (cursor_.is_symbol('=')) {
    report(DiagnosticId::syntax_error, cursor_.span(), {"= compares nothing, == does"});
    cursor_.advance();
    value = program_.add_operator(ir::Operator::equal, value, expression(), head);
  }
  in_condition_ = false;
  return value;
}

void Parser::opener(StatementKind kind, text::Span head, bool with_condition) {
  ir::Structure structure;
  if (with_condition) structure.condition = condition(head);
  lower_.add_structure(kind, structure, to_here(head));
  if (!cursor_.at_block_end())
    give_up(DiagnosticId::statement_not_alone, head, {std::string(UpperName(head.in(cursor_.whole())).view())});
}

// IF … GOTOF label in one block is a jump; IF alone opens a structure.
void Parser::if_statement(text::Span head) {
  const ir::ExpressionId value = condition(head);
  const auto verb = cursor_.kind() == TokenKind::name ? go_to_verb(cursor_.text()) : std::nullopt;
  if (verb) {
    cursor_.advance();
    return jump(*verb, value, head);
  }
  ir::Structure structure;
  structure.condition = value;
  lower_.add_structure(StatementKind::if_begin, structure, to_here(head));
  if (!cursor_.at_block_end()) give_up(DiagnosticId::statement_not_alone, head, {"IF"});
}

void Parser::jump(Verb verb, ir::ExpressionId condition, text::Span head) {
  ir::Jump jump;
  jump.condition = condition;
  jump.search = verb == Verb::go_to_forward    ? ir::JumpSearch::forward
                : verb == Verb::go_to_backward ? ir::JumpSearch::backward
                                               : ir::JumpSearch::both;
  jump.tolerant = verb == Verb::go_to_tolerant;
  jump.restart = verb == Verb::go_to_start;
  if (jump.restart || jump_target(jump)) lower_.add_jump(jump, to_here(head));
}

// LABEL, N100, :100, or a string that is one of these.
bool Parser::jump_target(ir::Jump& jump) {
  const bool block_number =
      (cursor_.kind() == TokenKind::address && to_upper(cursor_.first()) == 'N' && cursor_.span().size() == 1) ||
      cursor_.is_symbol(':');
  if (block_number) {
    cursor_.advance();
    const auto number = cursor_.kind() == TokenKind::number ? text::parse_integer(cursor_.text()) : std::nullopt;
    if (!number || *number > 999'999'999) {
      give_up(DiagnosticId::syntax_error, cursor_.span(), {here() + " is not a block number"});
      return false;
    }
    jump.number = static_cast<std::uint32_t>(*number);
    cursor_.advance();
    return true;
  }
  if (const text::Span name = short_label(); !name.empty()) {
    jump.label = lower_.name(name.in(cursor_.whole()));
    cursor_.advance();
    cursor_.advance();
    return true;
  }
  const bool known_variable = lower_.is_declared(lower_.find_symbol(cursor_.text()));
  if (cursor_.kind() == TokenKind::name && !known_variable && !cursor_.after().is_symbol("<<")) {
    jump.label = lower_.name(cursor_.text());
    cursor_.advance();
    return true;
  }
  if (cursor_.kind() != TokenKind::name && cursor_.kind() != TokenKind::string &&
      cursor_.kind() != TokenKind::variable && !cursor_.is_symbol('(')) {
    give_up(DiagnosticId::syntax_error, cursor_.span(), {here() + " is not a jump target"});
    return false;
  }
  const ir::ExpressionId target = expression();
  const ir::Expression& e = program_.at(target);
  if (e.op == ir::Operator::string) {
    jump.label = lower_.name(std::string(program_.strings.at(e.string)));
  } else {
    jump.computed = target;
  }
  return true;
}

void Parser::for_statement(text::Span head) {
  ir::Structure structure;
  const bool counter = cursor_.kind() == TokenKind::variable || cursor_.kind() == TokenKind::name;
  if (!counter) return give_up(DiagnosticId::syntax_error, cursor_.span(), {"FOR needs a variable"});
  structure.counter = variable();
  if (!cursor_.take('=')) return give_up(DiagnosticId::missing_equals, cursor_.span(), {"FOR"});
  operator_ = head;
  structure.first = expression();
  if (!cursor_.take_name("TO")) return give_up(DiagnosticId::syntax_error, cursor_.span(), {"FOR has no TO"});
  structure.last = expression();
  lower_.add_structure(StatementKind::for_begin, structure, to_here(head));
  if (!cursor_.at_block_end()) give_up(DiagnosticId::statement_not_alone, head, {"FOR"});
}

// REPEAT alone opens a loop. REPEAT A, REPEAT A B, REPEATB A run a part of the program again, P=n times.
void Parser::repeat_statement(text::Span head, bool one_block) {
  if (cursor_.at_block_end() && !one_block) return lower_.add_structure(StatementKind::repeat_begin, {}, head);
  ir::Repeat repeat;
  repeat.one_block = one_block;
  if (!section_label(repeat.first, repeat.first_number))
    return give_up(DiagnosticId::syntax_error, cursor_.span(), {here() + " is not a label"});
  if (!one_block) (void)section_label(repeat.last, repeat.last_number);
  if (cursor_.kind() == TokenKind::address && to_upper(cursor_.first()) == 'P' && cursor_.span().size() == 1) {
    const text::Span p = cursor_.span();
    cursor_.advance();
    operator_ = p;
    if (cursor_.take('=')) {
      repeat.times = expression();
    } else if (!signed_constant(repeat.times)) {
      return give_up(DiagnosticId::address_without_value, p, {"P"});
    }
  }
  lower_.add_repeat(repeat, to_here(head));
  if (!cursor_.at_block_end()) give_up(DiagnosticId::statement_not_alone, head, {one_block ? "REPEATB" : "REPEAT"});
}

// A label, or a block number.
bool Parser::section_label(ir::StringId& label, std::uint32_t& number) {
  if (cursor_.kind() == TokenKind::name) {
    label = lower_.name(cursor_.text());
    cursor_.advance();
    return true;
  }
  const bool block_number = cursor_.kind() == TokenKind::address && to_upper(cursor_.first()) == 'N' &&
                            cursor_.span().size() == 1 && cursor_.after().kind() == TokenKind::number;
  if (!block_number) return false;
  cursor_.advance();
  const auto value = text::parse_integer(cursor_.text());
  if (!value || *value < 0 || *value > 999'999'999) return false;
  number = static_cast<std::uint32_t>(*value);
  cursor_.advance();
  return true;
}

// CASE(selector) OF 1 GOTOF A 2 GOTOF B DEFAULT GOTOF C
void Parser::case_statement(text::Span head) {
  operator_ = head;
  const ir::ExpressionId selector = expression();
  if (!cursor_.take_name("OF")) return give_up(DiagnosticId::syntax_error, cursor_.span(), {"CASE has no OF"});
  while (!cursor_.at_block_end()) {
    if (!case_branch(selector, head)) return;
  }
}

bool Parser::case_branch(ir::ExpressionId selector, text::Span head) {
  ir::ExpressionId condition = ir::ExpressionId::none;
  const text::Span start = cursor_.span();
  if (!cursor_.take_name("DEFAULT")) {
    operator_ = head;
    const ir::ExpressionId value = binary(kWeakestRank - 1);
    condition = program_.add_operator(ir::Operator::equal, selector, value, program_.at(value).span);
  }
  const auto verb = cursor_.kind() == TokenKind::name ? go_to_verb(cursor_.text()) : std::nullopt;
  if (!verb) {
    give_up(DiagnosticId::syntax_error, cursor_.span(), {"each value of CASE needs a jump"});
    return false;
  }
  cursor_.advance();
  jump(*verb, condition, start);
  return true;
}

}  // namespace dripfeed::sinumerik
