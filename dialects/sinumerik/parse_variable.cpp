// Variables: R parameters, names, system variables, and the lists in their brackets.
#include "dialects/sinumerik/parse.h"
#include "dialects/sinumerik/system_variables.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

using ir::TokenKind;
using text::DiagnosticId;

ir::VariableId Parser::variable() {
  if (cursor_.kind() == TokenKind::variable && to_upper(cursor_.first()) == 'R') return r_variable();
  ir::Variable v;
  const text::Span head = cursor_.span();
  if (cursor_.kind() == TokenKind::variable) {
    v.bank = ir::Bank::system;
    v.number = find_system_variable(cursor_.text());
    cursor_.advance();
    if (cursor_.is_symbol('[')) index_list(v, true);
  } else {
    v.bank = ir::Bank::named;
    v.symbol = lower_.symbol_used(cursor_.text());
    cursor_.advance();
    if (cursor_.is_symbol('[')) index_list(v, false);
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

// [a], [a,b]; further indices are read and dropped, which no array of a program has. Axis letters of system variables
// become the axis' number in the order of the trace.
void Parser::index_list(ir::Variable& v, bool axes_are_numbers) {
  static constexpr std::string_view kAxes = "XYZABCUVW";
  const text::Span head = cursor_.span();
  expect('[');
  ++brackets_;
  operator_ = head;
  std::uint32_t count = 0;
  do {
    ir::ExpressionId value = ir::ExpressionId::none;
    const std::size_t axis = cursor_.kind() == TokenKind::address && cursor_.span().size() == 1
                                 ? kAxes.find(to_upper(cursor_.first()))
                                 : kAxes.npos;
    if (axes_are_numbers && axis != kAxes.npos) {
      value = constant(static_cast<double>(axis), cursor_.span());
      cursor_.advance();
    } else if (nesting_ < kDeepestNesting && !cursor_.is_symbol(']')) {
      ++nesting_;
      value = binary(kWeakestRank);
      --nesting_;
    } else {
      value = missing_operand();
    }
    if (count == 0) v.index = value;
    if (count == 1) v.index2 = value;
    ++count;
  } while (cursor_.take(','));
  --brackets_;
  expect(']');
  if (count > 2 && v.bank == ir::Bank::named) foreign_chain_ = true;
}

}  // namespace dripfeed::sinumerik
