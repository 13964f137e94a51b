// Variables: R parameters, names, system variables, and the lists in their brackets.
#include "dialects/ir/axis_letters.h"
#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/tables/system_variables.h"
#include "dialects/sinumerik/tables/vocabulary.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

using ir::TokenKind;
using text::DiagnosticId;

namespace {

// AX1 … AX31, and what builders call axes: two letters at most, then digits (X1, MX1, AX12).
bool is_machine_axis(std::string_view name) {
  std::size_t letters = 0;
  while (letters < name.size() && is_letter(name[letters])) ++letters;
  return letters >= 1 && letters <= 2 && letters < name.size() &&
         name.find_first_not_of("0123456789", letters) == std::string_view::npos;
}

}  // namespace

ir::VariableId Parser::variable() {
  if (cursor_.kind() == TokenKind::variable && to_upper(cursor_.first()) == 'R') return r_variable();
  ir::Variable v;
  const text::Span head = cursor_.span();
  if (cursor_.kind() == TokenKind::variable) {
    v.bank = ir::Bank::system;
    v.number = find_system_variable(cursor_.text());
    v.name = lower_.name(cursor_.text());
    cursor_.advance();
    if (cursor_.is_symbol('[')) index_list(v, true);
  } else {
    v.bank = ir::Bank::named;
    v.symbol = lower_.symbol_used(cursor_.text());
    const bool frame = lower_.is_declared(v.symbol) && program_.at(v.symbol).type == ir::ValueType::frame;
    cursor_.advance();
    if (cursor_.is_symbol('[')) index_list(v, frame);
  }
  v.span = to_here(head);
  return program_.add(v);
}

// R5, R[expression], and R 5 with a blank.
ir::VariableId Parser::r_variable() {
  ir::Variable v;
  v.bank = ir::Bank::r;
  const text::Span head = cursor_.span();
  std::string_view digits = cursor_.text().substr(1);
  cursor_.advance();
  if (digits.empty() && cursor_.is_symbol('[')) {
    index_list(v, false);
  } else {
    if (digits.empty() && cursor_.kind() == TokenKind::number) {
      digits = cursor_.text();
      cursor_.advance();
    }
    const auto number = text::parse_integer(digits);
    if (number && *number >= 0 && *number < 0xFFFFFFFF) {
      v.number = static_cast<std::uint32_t>(*number);
    } else {
      report(DiagnosticId::address_without_value, head, {"R"});
    }
  }
  v.span = to_here(head);
  return program_.add(v);
}

// An index of a system variable: an axis letter becomes the axis' number in the order of the trace, TR FI RT SC MI the
// part of a frame, and a name that is nowhere defined is the name of an axis of the machine. None for a plain value.
ir::ExpressionId Parser::system_index() {
  static constexpr std::string_view kParts[] = {"TR", "FI", "RT", "SC", "MI"};
  const bool letter = cursor_.kind() == TokenKind::address && cursor_.span().size() == 1;
  const std::size_t axis = letter ? ir::kAxisLetters.find(to_upper(cursor_.first())) : ir::kAxisLetters.npos;
  const text::Span span = cursor_.span();
  if (axis != ir::kAxisLetters.npos) {
    cursor_.advance();
    return constant(static_cast<double>(axis), span);
  }
  const TokenCursor next = cursor_.after();
  if (cursor_.kind() != TokenKind::name || !(next.is_symbol(',') || next.is_symbol(']'))) return ir::ExpressionId::none;
  for (std::size_t i = 0; i < std::size(kParts); ++i) {
    if (!same_name(cursor_.text(), kParts[i])) continue;
    cursor_.advance();
    return constant(static_cast<double>(i), span);
  }
  const bool free_name = !is_word_of_control(cursor_.text()) && !is_variable(cursor_.text());
  return free_name && is_machine_axis(cursor_.text()) ? axis_name() : ir::ExpressionId::none;
}

// [a], [a,b], [a,b,c]; further indices are read and dropped, which nothing has.
void Parser::index_list(ir::Variable& v, bool of_system) {
  const text::Span head = cursor_.span();
  expect('[');
  ++brackets_;
  operator_ = head;
  std::uint32_t count = 0;
  do {
    ir::ExpressionId value = ir::ExpressionId::none;
    if (of_system) value = system_index();
    if (value != ir::ExpressionId::none) {
      // an axis, or a part of a frame
    } else if (nesting_ < kDeepestNesting && !cursor_.is_symbol(']')) {
      ++nesting_;
      value = binary(kWeakestRank);
      --nesting_;
    } else {
      value = missing_operand();
    }
    if (count == 0) v.index = value;
    if (count == 1) v.index2 = value;
    if (count == 2) v.index3 = value;
    ++count;
  } while (cursor_.take(','));
  --brackets_;
  expect(']');
  if (count > 3 && v.bank == ir::Bank::named) foreign_chain_ = true;
}

}  // namespace dripfeed::sinumerik
