// Assignments, messages and alarms, and what is kept as it is written: synchronized actions, cycles, couplings,
// transformations. Those lose no verdict silently: a Native names itself, and only a few are known to do nothing.
#include <algorithm>
#include <utility>

#include "dialects/ir/axis_letters.h"
#include "dialects/ir/transformation_use.h"
#include "dialects/sinumerik/reader/data_file.h"
#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/tables/whole_number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using ir::TokenKind;
using text::DiagnosticId;

// What is kept as written under that name, and after which axes may be anywhere: cycles, frames, texts, and the words
// of addresses that move axes by themselves.
bool may_move(std::string_view name) {
  constexpr std::string_view kAddresses[] = {"PO", "MEASA", "MEAWA", "MEAC", "POSP", "OSCILL", "MOVT"};
  constexpr std::string_view kOscillating = "XYZABCUVWEQ";
  if (name.size() == 3 && name.ends_with("[]") && kOscillating.contains(name.front())) return true;
  if (name.starts_with("HOLES") || std::ranges::find(kAddresses, name) != std::end(kAddresses)) return true;
  const Keyword* keyword = find_keyword(name);
  return keyword != nullptr && (keyword->effect == Effect::moves || keyword->effect == Effect::shifts);
}

}  // namespace

void Parser::statement_of(const Keyword& keyword, text::Span head) {
  if (keyword.name == "TRANSMIT" || keyword.name == "TRACYL") return transformation(keyword.name, head);
  if (keyword.name == "SETMS") return main_spindle(head);
  if (keyword.name == "CYCLE802" && positions_are_absolute()) {
    cursor_.advance();
    return call_by_name(lower_.name(keyword.name), head);
  }
  if (keyword.name == "SPLINEPATH" && names_the_usual_axes()) {
    cursor_.advance();
    return native(keyword.name, true, head);
  }
  switch (keyword.role) {
    case Role::address: return named_word(keyword);
    case Role::procedure:
    case Role::cycle: {
      cursor_.advance();
      const bool is_known = keyword.effect == Effect::none || keyword.effect == Effect::paces ||
                            (keyword.effect == Effect::smooths && sets_smoothing_alone());
      return native(keyword.name, is_known, head);
    }
    case Role::foreign: cursor_.advance(); return native(keyword.name, false, head);
    case Role::infix:
    case Role::prefix:
    case Role::function:
    case Role::constant:
    case Role::word_mode:
    case Role::type:
    case Role::attribute:
      // APR 7 APW 11: who may read and write what the file declares from here on.
      if (keyword.role == Role::attribute && is_data_file(program_)) {
        cursor_.advance();
        return native(keyword.name, true, head);
      }
      return give_up(DiagnosticId::syntax_error, head, {std::string(keyword.name) + " does not begin a statement"});
    case Role::statement: break;
  }
  cursor_.advance();
  switch (keyword.verb) {
    case Verb::define: return definition(head);
    case Verb::procedure: return procedure(head);
    case Verb::declare:
      if (cursor_.kind() == TokenKind::name) externs_.insert(lower_.name(cursor_.text()));
      lower_.add_plain(StatementKind::declaration, head);
      return skip_block();
    case Verb::message: return message(head);
    case Verb::alarm: return alarm(head);
    case Verb::call: return call_statement(head);
    case Verb::call_modal: return modal_call(head);
    case Verb::call_path: return path_call(head);
    case Verb::call_external: return external_call(head);
    case Verb::call_iso: return iso_call(head);
    case Verb::execute: return execute_statement(head);
    case Verb::macro: return macro_definition(head);
    case Verb::return_word: return return_statement(head);
    case Verb::none:
    case Verb::if_word:
    case Verb::else_word:
    case Verb::end_if:
    case Verb::while_word:
    case Verb::end_while:
    case Verb::for_word:
    case Verb::end_for:
    case Verb::loop:
    case Verb::end_loop:
    case Verb::repeat:
    case Verb::repeat_block:
    case Verb::until:
    case Verb::case_word:
    case Verb::go_to:
    case Verb::go_to_forward:
    case Verb::go_to_backward:
    case Verb::go_to_tolerant:
    case Verb::go_to_start: return flow(keyword.verb, head);
  }
}

// The rest of the block belongs to what stands at its head and is not read, but for its brackets.
void Parser::native(std::string_view name, bool effects_known, text::Span head) {
  bool moves = may_move(name) || acts_on_axes();
  std::string open;  // what would close them, the innermost last
  for (; !cursor_.at_block_end(); cursor_.advance()) {
    moves = moves || (open.empty() && is_axis_address());
    if (cursor_.is_symbol('(')) open += ')';
    if (cursor_.is_symbol('[')) open += ']';
    if (!open.empty() && cursor_.is_symbol(open.back())) open.pop_back();
  }
  if (!open.empty()) report(DiagnosticId::missing_bracket, cursor_.span(), {std::string(1, open.back())});
  lower_.keep_as_native(name, effects_known, to_here(head), moves);
}

// CYCLE832(tolerance, kind, …): what the kind switches, is documented for those below; its digits above the tens had
// more to do in older versions, transformations among it. (NC programming 12/2019, "High-speed settings"; PGZ 11/2006,
// "CYCLE832".)
bool Parser::sets_smoothing_alone() const {
  constexpr std::string_view kKinds[] = {"_OFF",        "_FINISH",      "_SEMIFIN",   "_ROUGH",        "_PRECISION",
                                         "_ORI_FINISH", "_ORI_SEMIFIN", "_ORI_ROUGH", "_ORI_PRECISION"};
  constexpr std::uint32_t kFirstOfOlder = 100;
  TokenCursor probe = cursor_;
  if (probe.at_block_end()) return true;
  if (!probe.is_symbol('(')) return false;
  probe.advance();
  while (!probe.at_block_end() && !probe.is_symbol(',') && !probe.is_symbol(')')) {
    if (probe.is_symbol('(')) return false;
    probe.advance();
  }
  if (!probe.is_symbol(',')) return true;
  probe.advance();
  if (probe.is_symbol(',') || probe.is_symbol(')')) return true;
  const bool is_kind = std::ranges::find(kKinds, probe.text()) != std::end(kKinds);
  const bool is_number = probe.kind() == TokenKind::number && whole_number(probe.text()) < kFirstOfOlder;
  probe.advance();
  return (is_kind || is_number) && (probe.is_symbol(',') || probe.is_symbol(')'));
}

// X10 or Z=R1 at the cursor, with which a block moves whatever else stands in it.
bool Parser::is_axis_address() const {
  if (cursor_.kind() != TokenKind::address || cursor_.span().size() != 1) return false;
  const TokenCursor value = cursor_.after();
  const bool has_value = value.kind() == TokenKind::number || value.is_symbol('=') || value.is_symbol('-');
  return has_value && ir::kAxisLetters.contains(to_upper(cursor_.first()));
}

// CYCLE802(111111111,111111111,…): a digit a position, 1 absolute. Of mixed ones the cycle is stated (PGZ, CYCLE802).
bool Parser::positions_are_absolute() const {
  TokenCursor probe = cursor_.after();
  const auto all_ones = [&] {
    probe.advance();
    return probe.kind() == TokenKind::number && std::ranges::all_of(probe.text(), [](char c) { return c == '1'; });
  };
  if (!probe.is_symbol('(') || !all_ones()) return false;
  probe.advance();
  return probe.is_symbol(',') && all_ones();
}

// Synchronized actions may move axes while the program goes on: … DO POS[Z]=100.
bool Parser::acts_on_axes() const {
  static constexpr std::string_view kActions[] = {"POS", "POSA", "MOV", "DELDTG", "$AA_OFF"};
  for (TokenCursor probe = cursor_; !probe.at_block_end(); probe.advance())
    if (std::ranges::any_of(kActions, [&](std::string_view action) { return same_name(probe.text(), action); }))
      return true;
  return false;
}

// TRANSMIT, TRANSMIT(n); TRACYL(diameter), TRACYL(diameter, n, k): the number is that of one of the machine's data
// sets.
void Parser::transformation(std::string_view name, text::Span head) {
  static constexpr GCode kFace = {
      {"TRANSMIT", -1, ir::Function::transformation, ir::kFaceByY, ir::ModalGroup::other, "PGA, TRANSMIT"},
      0,
      WordUse::usual};
  static constexpr GCode kCylinder = {
      {"TRACYL", -1, ir::Function::transformation, ir::kCylinderByY, ir::ModalGroup::other, "PGA, TRACYL"},
      0,
      WordUse::usual};
  cursor_.advance();
  const bool face = name == "TRANSMIT";
  ir::ExpressionId diameter = ir::ExpressionId::none;
  if (cursor_.take('(')) {
    ++brackets_;
    bool first = true;
    do {
      const bool left_out = cursor_.is_symbol(',') || cursor_.is_symbol(')');
      const ir::ExpressionId value = left_out ? ir::ExpressionId::none : binary(kWeakestRank);
      if (std::exchange(first, false)) diameter = value;
    } while (cursor_.take(','));
    --brackets_;
    expect(')');
  }
  const text::Span span = to_here(head);
  if (!face && diameter == ir::ExpressionId::none)
    return give_up(DiagnosticId::missing_operand, head, {std::string(name)});
  lower_.add_code(face ? kFace : kCylinder, span);
  if (!face) lower_.add_word({.address = ir::Address::r, .value = diameter, .span = span});
}

// `head` is the variable's first token; the cursor stands after the variable.
void Parser::assignment(ir::VariableId target, text::Span head) {
  const text::Span variable_span = program_.at(target).span;
  if (!cursor_.take('=')) {
    report(DiagnosticId::missing_equals, variable_span, {std::string(variable_span.in(cursor_.whole()))});
    faulty_ = true;
    return lower_.keep_as_native("missing =", false, variable_span);
  }
  operator_ = {cursor_.previous_end() - 1, cursor_.previous_end()};
  foreign_chain_ = false;
  const ir::Variable written = program_.at(target);
  const bool list = cursor_.is_name("SET") || cursor_.is_name("REP");
  if (list && written.bank != ir::Bank::system) {
    (void)value_list(written, head);
    return;
  }
  if (list) return native("SET", false, head);
  const ir::ExpressionId value = expression();
  ir::Variable whole = written;
  if (character_index(whole) != nullptr)
    return lower_.keep_as_native(variable_span.in(cursor_.whole()), false, to_here(head));
  if (foreign_chain_) return lower_.keep_as_native(variable_span.in(cursor_.whole()), false, to_here(head));
  // $$ stands for a value of the main run: only synchronized actions write it.
  const bool main_run = variable_span.in(cursor_.whole()).starts_with("$$");
  if (main_run) return lower_.keep_as_native(variable_span.in(cursor_.whole()), false, to_here(head));
  lower_.add_assign(target, value, to_here(head));
  frame_elsewhere(target, to_here(head));
}

void Parser::missing_target() {
  const text::Span sign = cursor_.span();
  report(DiagnosticId::missing_target, sign);
  lower_.keep_as_native("assignment without target", false, sign);
  cursor_.advance();
  operator_ = sign;
  (void)expression();
}

// EXECSTRING(text)
void Parser::execute_statement(text::Span head) {
  operator_ = head;
  ir::Message message;
  message.text = parenthesized();
  lower_.add_message(StatementKind::execute_text, message, to_here(head));
}

// MSG("text" << value), MSG() clears.
void Parser::message(text::Span head) {
  ir::Message message;
  operator_ = head;
  // MSG alone clears, too, on controls in use; the manual writes MSG().
  if (cursor_.at_block_end() && !faulty_) {
    report(DiagnosticId::missing_bracket, head, {"("});
    diagnostics_.back().severity = text::Severity::warning;
    return lower_.add_message(StatementKind::message, message, head);
  }
  if (!cursor_.is_symbol('(')) return give_up(DiagnosticId::missing_bracket, head, {"("});
  cursor_.advance();
  if (!cursor_.is_symbol(')')) {
    ++brackets_;
    message.text = binary(kWeakestRank);
    if (cursor_.take(',')) (void)binary(kWeakestRank);
    --brackets_;
  }
  expect(')');
  lower_.add_message(StatementKind::message, message, to_here(head));
}

void Parser::alarm(text::Span head) {
  ir::Message alarm;
  operator_ = head;
  if (!cursor_.is_symbol('(')) return give_up(DiagnosticId::missing_bracket, head, {"("});
  cursor_.advance();
  ++brackets_;
  alarm.number = binary(kWeakestRank);
  if (cursor_.take(',')) alarm.text = binary(kWeakestRank);
  --brackets_;
  expect(')');
  lower_.add_message(StatementKind::alarm, alarm, to_here(head));
}

}  // namespace dripfeed::sinumerik
