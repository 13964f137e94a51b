// Calls in all forms and returns from them.
#include <algorithm>

#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/called_cycles.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using ir::TokenKind;
using text::DiagnosticId;

constexpr std::int64_t kHighestBlockNumber = 999'999'999;

}  // namespace

void Parser::call_by_name(ir::StringId name, text::Span head, StatementKind kind) {
  ir::Call call;
  call.in_other_language = resumes_iso_;
  call.name = name;
  call.repeats = repeats_;
  if (cursor_.is_symbol('(')) arguments(call);
  has_call_ = true;
  lower_.add_call(kind, call, to_here(head));
}

// (a, b,, d): an argument that is left out is none.
void Parser::arguments(ir::Call& call) {
  const text::Span before = operator_;
  expect('(');
  ++brackets_;
  std::vector<ir::Argument> given;
  if (!cursor_.is_symbol(')')) {
    do {
      operator_ = before;
      const bool left_out = cursor_.is_symbol(',') || cursor_.is_symbol(')');
      given.push_back({0, left_out ? ir::ExpressionId::none : binary(kWeakestRank)});
    } while (cursor_.take(','));
  }
  --brackets_;
  expect(')');
  call.first_argument = static_cast<std::uint32_t>(program_.arguments.size());
  call.argument_count = static_cast<std::uint32_t>(given.size());
  program_.arguments.insert(program_.arguments.end(), given.begin(), given.end());
}

// CALL "NAME" or a text that is computed; CALL "NAME" BLOCK "A" TO "B": a part of it.
void Parser::call_statement(text::Span head) {
  operator_ = head;
  if (cursor_.take_name("BLOCK")) return own_part_call(head);
  ir::Call call;
  const ir::ExpressionId name = expression();
  if (cursor_.take_name("BLOCK") && !part_labels(call, head)) return;
  computed_call(name, call, head);
}

bool Parser::part_labels(ir::Call& call, text::Span head) {
  call.first_label = expression();
  if (!cursor_.take_name("TO")) {
    give_up(DiagnosticId::syntax_error, head, {"CALL BLOCK has no TO"});
    return false;
  }
  call.last_label = expression();
  return true;
}

// A part of the program itself is run as REPEAT does, with its variables. Which one, a text may decide in the run.
void Parser::own_part_call(text::Span head) {
  ir::Call labels;
  if (!part_labels(labels, head)) return;
  ir::Repeat repeat;
  const auto name = [&](ir::ExpressionId id, ir::StringId& label, std::uint32_t& number) {
    const ir::Expression& e = program_.at(id);
    if (e.op != ir::Operator::string) return false;
    const std::string_view written = program_.strings.at(e.string);
    const auto block =
        written.starts_with('N') || written.starts_with('n') ? text::parse_integer(written.substr(1)) : std::nullopt;
    if (block && *block >= 0 && *block <= kHighestBlockNumber)
      number = static_cast<std::uint32_t>(*block);
    else
      label = lower_.name(written);
    return true;
  };
  if (!name(labels.first_label, repeat.first, repeat.first_number) ||
      !name(labels.last_label, repeat.last, repeat.last_number) || repeats_ != ir::ExpressionId::none ||
      !cursor_.at_block_end())
    return native("CALL", false, head);
  lower_.add_repeat(repeat, to_here(head));
}

// A name that is written is known now, without its path and ending.
void Parser::computed_call(ir::ExpressionId name, ir::Call call, text::Span head) {
  const ir::Expression& e = program_.at(name);
  const bool is_iso_call = call.in_other_language;
  if (e.op == ir::Operator::string)
    call.name = lower_.name(ir::program_name_of_path(program_.strings.at(e.string)));
  else
    call.computed = name;
  call.in_other_language |= resumes_iso_;
  call.repeats = repeats_;
  const bool may_pass = e.op == ir::Operator::string && call.first_label == ir::ExpressionId::none && !is_iso_call;
  if (may_pass && cursor_.is_symbol('(')) arguments(call);
  has_call_ = true;
  lower_.add_call(StatementKind::call, call, to_here(head));
}

// MCALL NAME(…): the call is made after every block that moves; MCALL alone ends that. A cycle that is not read ends
// the one before it as well.
void Parser::modal_call(text::Span head) {
  if (cursor_.at_block_end()) return lower_.add_plain(StatementKind::modal_call_end, head);
  if (cursor_.kind() == TokenKind::address && cursor_.span().size() == 1 && to_upper(cursor_.first()) == 'L') {
    cursor_.advance();
    return numbered_call(head, StatementKind::modal_call);
  }
  if (cursor_.kind() != TokenKind::name)
    return give_up(DiagnosticId::syntax_error, cursor_.span(), {here() + " is not a program to be called"});
  const std::string_view name = cursor_.text();
  cursor_.advance();
  const ir::CalledCycle* const cycle = find_called_cycle(UpperName(name).view());
  // What a milling cycle takes of the position before it, is not certain.
  if (find_keyword(name) != nullptr || (cycle != nullptr && cycle->sort == ir::CalledSort::milling)) {
    lower_.add_plain(StatementKind::modal_call_end, head);
    return native(UpperName(name).view(), false, head);
  }
  call_by_name(lower_.name(name), head, StatementKind::modal_call);
}

// PCALL /_N_WKS_DIR/_N_SHAFT_WPD/_N_GROOVE_SPF(1,2): the path ends where the arguments begin.
void Parser::path_call(text::Span head) {
  const text::Span start = cursor_.span();
  text::Span path = {start.begin, start.begin};
  while (!cursor_.at_block_end() && !cursor_.is_symbol('(')) {
    path.end = cursor_.span().end;
    cursor_.advance();
  }
  if (path.empty()) return give_up(DiagnosticId::syntax_error, head, {"PCALL has no path"});
  const std::string name(ir::program_name_of_path(path.in(cursor_.whole())));
  call_by_name(lower_.name(name), head);
}

// EXTCALL("path/name"): a program of another device.
void Parser::external_call(text::Span head) {
  operator_ = head;
  if (cursor_.kind() == TokenKind::string) return computed_call(expression(), {}, head);
  if (!cursor_.is_symbol('(')) return give_up(DiagnosticId::missing_bracket, head, {"("});
  computed_call(parenthesized(), {}, head);
}

// ISOCALL "NAME": the program begins in ISO mode (PGA, "Indirect call of a program programmed in ISO language").
void Parser::iso_call(text::Span head) {
  operator_ = head;
  ir::Call call;
  call.in_other_language = true;
  computed_call(expression(), call, head);
}

// L100 and L0100 are two programs: the digits are the name.
void Parser::numbered_call(text::Span head, StatementKind kind) {
  const std::string_view digits = cursor_.kind() == TokenKind::number ? cursor_.text() : std::string_view();
  if (digits.empty() || !std::ranges::all_of(digits, is_digit))
    return give_up(DiagnosticId::address_without_value, head, {"L"});
  const ir::StringId id = lower_.name("L" + std::string(digits));
  cursor_.advance();
  call_by_name(id, head, kind);
}

// RET alone, RET("LABEL") to a block of the caller, RET(,,2) to the caller's caller (PGA, "Parameterizable subprogram
// return"). What goes to a block after the target or to the start of the program is kept as written.
bool Parser::returns_usually(std::uint8_t& levels, bool& has_target) const {
  constexpr int kLevels = 1;
  constexpr std::uint8_t kMostLevels = 16;
  TokenCursor probe = cursor_.after();
  has_target = !probe.is_symbol(',') && !probe.is_symbol(')');
  while (!probe.at_block_end() && !probe.is_symbol(',') && !probe.is_symbol(')')) probe.advance();
  for (int place = 0; place < 3 && probe.is_symbol(','); ++place) {
    probe.advance();
    if (probe.is_symbol(',') || probe.is_symbol(')')) continue;
    const auto number = text::parse_integer(probe.text());
    if (!number || *number < 0 || (place != kLevels && *number != 0) || *number > kMostLevels) return false;
    if (place == kLevels) levels = static_cast<std::uint8_t>(*number);
    probe.advance();
  }
  return levels != 0 && probe.is_symbol(')');
}

void Parser::return_statement(text::Span head) {
  if (!cursor_.is_symbol('(')) return lower_.add_plain(StatementKind::subprogram_return, head);
  ir::Jump jump;
  bool has_target = false;
  if (!returns_usually(jump.levels, has_target)) return native("RET", false, head);
  operator_ = head;
  expect('(');
  ++brackets_;
  if (has_target) jump.computed = binary(kWeakestRank);
  --brackets_;
  while (!cursor_.at_block_end() && !cursor_.is_symbol(')')) cursor_.advance();
  expect(')');
  lower_.add_return(jump, to_here(head));
}

}  // namespace dripfeed::sinumerik
