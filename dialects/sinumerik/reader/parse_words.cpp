// Addresses with their values: words, G codes, M functions, how often a call runs.
#include <algorithm>
#include <array>
#include <utility>

#include "dialects/ir/axis_letters.h"
#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/tables/whole_number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::TokenKind;
using text::DiagnosticId;

ir::Address letter_address(char c) { return static_cast<ir::Address>(to_upper(c) - 'A'); }
static_assert(static_cast<int>(ir::Address::z) - static_cast<int>(ir::Address::a) == 25);

}  // namespace

void Parser::address_word() {
  const text::Span head = cursor_.span();
  const char letter = to_upper(cursor_.first());
  cursor_.advance();
  // S[SPINDLE]=…, X[2]=…: which spindle, tool or axis it is, the index decides (PG, "Extended address notation").
  constexpr std::string_view kNotIndexed = "GLMNP";
  if (cursor_.is_symbol('[') && !kNotIndexed.contains(letter)) return native(std::string{letter} + "[]", false, head);
  switch (letter) {
    // Axes that a machine may have; where they are is not followed.
    case 'E':
    case 'Q': word(Address::other, 0, lower_.name(head.in(cursor_.whole())), head); return;
    case 'G': g_code(head); return;
    case 'M': m_function(0, head); return;
    case 'L': numbered_call(head); return;
    case 'P': repeats_word(head); return;
    case 'N': give_up(DiagnosticId::syntax_error, head, {"a block number stands first in its block"}); return;
    default: word(letter_address(letter), 0, ir::StringId::none, head); return;
  }
}

// S2=, M2=, T1= belong to a spindle; X1=, I1=, A2= are names of their own.
void Parser::extended_address() {
  const text::Span head = cursor_.span();
  const std::string_view name = cursor_.text();
  const std::uint32_t extension = whole_number(name.substr(1));
  const char letter = to_upper(name.front());
  cursor_.advance();
  const bool indexed = (letter == 'S' || letter == 'T' || letter == 'H' || letter == 'D') && extension <= 255;
  if (letter == 'M') return m_function(extension, head);
  // I1= J1= K1=: the point in between of CIP
  if (extension == 1 && letter >= 'I' && letter <= 'K')
    return word(static_cast<ir::Address>(static_cast<int>(ir::Address::via_i) + (letter - 'I')), 0, ir::StringId::none,
                head);
  if (!indexed) return axis_of_another_name(letter, name, head);
  word(letter_address(letter), static_cast<std::uint8_t>(extension), ir::StringId::none, head);
}

// X1=5 is the machine's own name of X, or another axis next to it: X may be elsewhere afterwards.
void Parser::axis_of_another_name(char letter, std::string_view name, text::Span head) {
  word(ir::Address::other, 0, lower_.name(name), head);
  if (letter < 'X' || letter > 'Z' || faulty_ || lower_.is_native()) return;
  const text::Span span = to_here(head);
  const ir::Code code{.function = ir::Function::not_modelled,
                      .group = ir::ModalGroup::non_modal,
                      .name = lower_.name(name),
                      .span = span};
  ir::Word lost = ir::word(letter_address(letter), constant(0.0, span));
  lost.span = span;
  lower_.add_aside(code, lost);
}

// P5 or P=R1: how often the subprogram of the block runs.
void Parser::repeats_word(text::Span head) {
  ir::ExpressionId value = ir::ExpressionId::none;
  if (cursor_.take('=')) {
    value = expression();
  } else if (!signed_constant(value)) {
    return give_up(DiagnosticId::address_without_value, head, {"P"});
  }
  repeats_span_ = to_here(head);
  if (has_call_ && !program_.calls.empty()) {
    program_.calls.back().repeats = value;
  } else {
    repeats_ = value;
  }
}

bool Parser::signed_constant(ir::ExpressionId& value) {
  const bool sign = cursor_.is_symbol('-') || cursor_.is_symbol('+');
  if (cursor_.kind() != TokenKind::number && !(sign && cursor_.after().kind() == TokenKind::number)) return false;
  const text::Span head = cursor_.span();
  const bool negative = cursor_.is_symbol('-');
  if (sign) cursor_.advance();
  value = number();
  ir::Expression& constant = program_.expressions[static_cast<std::uint32_t>(value)];
  if (negative) constant.value = -constant.value;
  constant.span = join(head, constant.span);
  return true;
}

void Parser::word(ir::Address address, std::uint8_t extension, ir::StringId name, text::Span head,
                  ir::ExpressionId axis) {
  ir::Word w;
  w.axis = axis;
  w.address = address;
  w.extension = extension;
  w.name = name;
  const std::string_view written = head.in(cursor_.whole());
  if (cursor_.take('=')) {
    operator_ = {head.begin, cursor_.previous_end()};
    if (cursor_.is_name("PO") && cursor_.after().is_symbol('(')) {
      cursor_.advance();
      return polynomial(address, head);
    }
    w.value = word_value(w);
  } else if (head.size() == 1 && signed_constant(w.value)) {
    // the usual word
  } else if (cursor_.at_block_end() || cursor_.kind() == TokenKind::address || cursor_.kind() == TokenKind::name) {
    report(DiagnosticId::address_without_value, head, {std::string(written)});
    return lower_.keep_as_native("address without value", false, head);
  } else {
    report(DiagnosticId::missing_equals, head, {std::string(written)});
    w.value = expression();
  }
  w.span = to_here(head);
  lower_.add_word(w);
  if (w.address != Address::other || !ir::is_axis(address)) return;
  // X=CAC(2), X=DAC(10): where the axis is then only the machine knows.
  ir::Code code{
      .function = ir::Function::not_modelled, .group = ir::ModalGroup::non_modal, .name = w.name, .span = w.span};
  w.address = address;
  w.name = ir::StringId::none;
  lower_.add_aside(code, w);
}

ir::ExpressionId Parser::word_value(ir::Word& w) {
  if (cursor_.kind() == TokenKind::name && cursor_.after().is_symbol('(')) {
    const Keyword* keyword = find_keyword(cursor_.text());
    if (keyword != nullptr && keyword->role == Role::word_mode) return moded_value(w);
    if (cursor_.is_name("QU")) {
      cursor_.advance();
      return parenthesized();
    }
  }
  return expression();
}

// AC(…), IC(…) and the rotary forms, which end at the same point as AC; coded positions and DAC … RIC are kept by name.
ir::ExpressionId Parser::moded_value(ir::Word& w) {
  const std::string mode(UpperName(cursor_.text()).view());
  cursor_.advance();
  if (mode == "IC") {
    w.mode = ir::WordMode::incremental;
  } else if (mode == "AC" || mode == "DC" || mode == "ACP" || mode == "ACN") {
    w.mode = ir::WordMode::absolute;
    if (mode != "AC" && w.address != ir::Address::other) w.name = program_.strings.add(mode);
  } else {
    w.name = program_.strings.add(mode);
    w.address = ir::Address::other;
  }
  return parenthesized();
}

void Parser::named_word(const Keyword& keyword) {
  const text::Span head = cursor_.span();
  cursor_.advance();
  if (keyword.name == "PO") return polynomial_of_axis(head);
  ir::StringId name = program_.strings.add(keyword.name);
  if (keyword.address != ir::Address::other) name = ir::StringId::none;
  if (keyword.name == "MEAW") name = program_.strings.add(keyword.name);
  if (cursor_.is_symbol('[')) {
    ir::Variable index;  // POS[X]: the index is a part of the name
    index_list(index, false);
    const std::string_view written = to_here(head).in(cursor_.whole());
    name = lower_.name(written);
    constexpr std::string_view kWithoutValue[] = {"SCC", "FOCON", "FOCOF"};
    if (!cursor_.is_symbol('=') && std::ranges::find(kWithoutValue, keyword.name) != std::end(kWithoutValue))
      return native(keyword.name, false, head);
    if (is_list_here()) return native(keyword.name, false, head);  // MEASA[X]=(1,2), POSP[Z]=(10,2,0)
    if (keyword.name == "POS" || keyword.name == "POSA") return positioning(keyword, name, index.index, head);
    if (keyword.name == "SPOS" || keyword.name == "SPOSA") return orientation(name, head, index.index);
    if (keyword.name == "FA") {  // how fast POS[X]= moves
      word(Address::other, 0, name, head);
      if (!faulty_ && !lower_.is_native()) lower_.last_word_is(ir::kPacesAxis);
      return;
    }
    const bool usual = keyword.address == ir::Address::spindle_limit && same_name(written, "LIMS[1]");
    return word(usual ? keyword.address : ir::Address::other, 0, name, head);
  }
  if (keyword.name == "SPOS" || keyword.name == "SPOSA") return orientation(name, head, ir::ExpressionId::none);
  word(keyword.address, 0, name, head);
}

bool Parser::is_list_here() const {
  if (!cursor_.is_symbol('=') || !cursor_.after().is_symbol('(')) return false;
  TokenCursor probe = cursor_.after().after();
  for (int open = 1; open > 0 && !probe.at_block_end(); probe.advance()) {
    if (open == 1 && probe.is_symbol(',')) return true;
    open += probe.is_symbol('(') ? 1 : probe.is_symbol(')') ? -1 : 0;
  }
  return false;
}

// POS[X]=10: the axis goes there by itself, at its own feed (FA), which is stated; the block ends when it has arrived.
// After POSA the next blocks do not wait for it, and that is stated as well. (PG, "Positioning axes".)
void Parser::positioning(const Keyword& keyword, ir::StringId name, ir::ExpressionId axis, text::Span head) {
  const ir::Expression* named = axis == ir::ExpressionId::none ? nullptr : &program_.at(axis);
  if (named == nullptr || !cursor_.is_symbol('=')) return word(Address::other, 0, name, head);
  const std::string written(named->op == ir::Operator::string ? program_.strings.at(named->string) : "");
  if (!written.empty() && (written.size() != 1 || !ir::kAxisLetters.contains(written.front())))
    return word(Address::other, 0, name, head);
  const bool letter = !written.empty();
  cursor_.advance();
  operator_ = {head.begin, cursor_.previous_end()};
  const Address address = letter ? letter_address(written.front()) : Address::named_axis;
  ir::Word w;
  w.address = address;
  if (!letter) w.axis = axis;
  w.value = word_value(w);
  w.span = to_here(head);
  const bool coded = w.address == Address::other;
  ir::Word made = w;
  made.address = Address::other;
  made.axis = ir::ExpressionId::none;
  if (!coded) made.name = name;
  lower_.add_word(made);
  if (!coded && keyword.name == "POS") lower_.last_word_is(ir::kCarriedOut);
  ir::Code code{.function = ir::Function::rapid, .group = ir::ModalGroup::non_modal, .span = w.span};
  if (coded) code = {.function = ir::Function::not_modelled, .group = code.group, .name = w.name, .span = w.span};
  w.address = address;
  w.name = ir::StringId::none;
  lower_.add_aside(code, w);
}

// AX[A1]=…: the axis is computed.
void Parser::named_axis_word(text::Span head) {
  cursor_.advance();
  ir::Variable index;
  index_list(index, false);
  if (index.index == ir::ExpressionId::none) return native("AX", false, head);
  word(ir::Address::named_axis, 0, ir::StringId::none, to_here(head), index.index);
}

void Parser::g_code(text::Span head) {
  if (group_by_number(head)) return;
  if (cursor_.is_symbol('[') || cursor_.is_symbol('=')) return native("G[]", false, head);
  if (cursor_.kind() != TokenKind::number) {
    return give_up(DiagnosticId::address_without_value, head, {"G"});
  }
  const std::uint32_t n = whole_number(cursor_.text());
  cursor_.advance();
  const text::Span span = to_here(head);
  const GCode* code = find_g_code(n);
  if (code == nullptr) {
    // It may be a macro of the machine (DEFINE G301 AS … in its definition files).
    report(DiagnosticId::unknown_code, span, {std::string(span.in(cursor_.whole()))});
    operator_ = head;
    ir::Word value;
    if (cursor_.take('=')) (void)word_value(value);  // DEFINE G92 AS LIMS: G92=2000
    return lower_.keep_as_native("unknown code", false, to_here(head), true);
  }
  if (n == 75 && reference_approach(head)) return;
  if (code->row.name == "G291" && in_macro_) return native(code->row.name, false, span);
  if (code->row.name == "G291") {
    const bool is_alone = cursor_.at_block_end() && lower_.is_first_in_line();
    if (!is_alone) return give_up(DiagnosticId::statement_not_alone, span, {"G291"});
    begin_iso_mode(lower_.first_statement(), cursor_.line_end());
    return lower_.keep_as_native(kInIsoMode, false, span, true);
  }
  lower_.add_code(*code, span);
}

// G[6]=1 is G17: the codes of the usual groups in the order of the list of G functions (PG). Others are stated.
bool Parser::group_by_number(text::Span head) {
  struct Group {
    std::uint32_t number;
    std::array<std::string_view, 7> codes;
  };
  static constexpr Group kGroups[] = {
      {1, {"G0", "G1", "G2", "G3", "CIP"}},
      {6, {"G17", "G18", "G19"}},
      {7, {"G40", "G41", "G42"}},
      {8, {"G500", "G54", "G55", "G56", "G57"}},
      {10, {"G60", "G64", "G641", "G642", "G643", "G644", "G645"}},
      {13, {"G70", "G71", "G700", "G710"}},
      {14, {"G90", "G91"}},
      {15, {"G93", "G94", "G95", "G96", "G97"}},
      {29, {"DIAMOF", "DIAMON", "DIAM90"}},
  };
  if (!cursor_.is_symbol('[')) return false;
  TokenCursor probe = cursor_.after();
  const std::uint32_t group = probe.kind() == TokenKind::number ? whole_number(probe.text()) : kNoNumber;
  probe.advance();
  if (!probe.is_symbol(']') || !probe.after().is_symbol('=')) return false;
  probe.advance();
  probe.advance();
  const std::uint32_t number = probe.kind() == TokenKind::number ? whole_number(probe.text()) : kNoNumber;
  probe.advance();
  const auto* const row = std::ranges::find(kGroups, group, &Group::number);
  const bool goes_on = probe.kind() == TokenKind::symbol;  // G[6]=1+R1
  if (row == std::end(kGroups) || goes_on || number == 0 || number > row->codes.size()) return false;
  const GCode* code = row->codes[number - 1].empty() ? nullptr : find_code_as_written(row->codes[number - 1]);
  if (code == nullptr) return false;
  cursor_.go_to(probe.index());
  lower_.add_code(*code, to_here(head));
  return true;
}

void Parser::m_function(std::uint32_t extension, text::Span head) {
  ir::ExpressionId value = ir::ExpressionId::none;
  if (cursor_.take('=')) {
    operator_ = head;
    ir::Word w;
    w.address = ir::Address::m;
    value = word_value(w);
    const ir::Expression& e = program_.at(value);
    if (e.op != ir::Operator::constant) return lower_.add_computed_m_code(value, to_here(head));
    return numbered_m_function(e.value, extension, to_here(head));
  }
  if (cursor_.is_symbol('[')) return native("M[]", false, head);
  if (!signed_constant(value)) return give_up(DiagnosticId::address_without_value, head, {"M"});
  numbered_m_function(program_.at(value).value, extension, to_here(head));
}

void Parser::numbered_m_function(double number, std::uint32_t extension, text::Span span) {
  if (number < 0 || number > 999'999'999 || number != static_cast<double>(static_cast<std::uint32_t>(number))) {
    report(DiagnosticId::unknown_code, span, {std::string(span.in(cursor_.whole()))});
    return lower_.keep_as_native("M", false, span);
  }
  lower_.add_m_code(static_cast<std::uint32_t>(number), extension, span);
}

// SPLINEPATH(1,X,Y,Z): the axes that go along a spline. All of X Y Z that the machine has are what it is without it.
bool Parser::names_the_usual_axes() const {
  constexpr std::string_view kUsual = "XYZ";
  std::string named;
  TokenCursor probe = cursor_.after();
  if (!probe.is_symbol('(')) return false;
  for (probe.advance(); !probe.is_symbol(')') && !probe.at_block_end(); probe.advance()) {
    const std::string_view text = probe.text();
    if (probe.kind() == TokenKind::number || text == ",") continue;
    if (text.size() != 1 || !kUsual.contains(to_upper(text.front()))) return false;
    named += to_upper(text.front());
  }
  return std::ranges::all_of(kUsual, [&](char c) { return named.contains(c) || !control_.axes.contains(c); });
}

}  // namespace dripfeed::sinumerik
