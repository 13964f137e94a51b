// PO[X]=(xe,a2,a3) and X=PO(xe,a2,a3,a4,a5) (PGA, "Polynomial interpolation"): the end is the axis word itself, what
// follows are the coefficients of the powers from the second on. What is left out at the end is 0. A denominator,
// PO[]=(…), and the polynomials of other axes are kept as written, and reported.
#include "dialects/ir/polynomial_words.h"
#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/name_index.h"

namespace dripfeed::sinumerik {

using ir::Address;

void Parser::polynomial_of_axis(text::Span head) {
  TokenCursor probe = cursor_;
  if (!probe.take('[') || probe.kind() != ir::TokenKind::address || probe.span().size() != 1)
    return native("PO", false, head);
  const char letter = to_upper(probe.first());
  probe.advance();
  if (!probe.take(']') || !probe.take('=') || !probe.is_symbol('(')) return native("PO", false, head);
  cursor_ = probe;
  polynomial(static_cast<Address>(letter - 'A'), head);
}

// At its list. AC() and IC() around the end are not in the manual; they are taken as around the end of a straight move.
void Parser::polynomial(Address axis, text::Span head) {
  const auto is_empty = [this] { return cursor_.is_symbol(',') || cursor_.is_symbol(')'); };
  operator_ = to_here(head);
  if (axis < Address::x || axis > Address::z || cursor_.after().is_symbol(',') || cursor_.after().is_symbol(')'))
    return native("PO", false, head);
  cursor_.advance();
  ++brackets_;
  ir::Word end = ir::word(axis, ir::ExpressionId::none);
  end.value = word_value(end);
  end.span = to_here(head);
  lower_.add_word(end);
  bool is_read = end.address == axis;
  std::size_t power = ir::kFirstPower;
  const std::size_t number = static_cast<std::size_t>(axis) - static_cast<std::size_t>(Address::x);
  const auto add = [&](ir::ExpressionId value, text::Span span) {
    ir::Word coefficient = ir::word(ir::coefficient_of(number, power), value);
    coefficient.span = span;
    lower_.add_word(coefficient);
  };
  for (; is_read && cursor_.take(','); ++power) {
    is_read = power <= ir::kLastPower && !is_empty();
    if (!is_read) break;
    const text::Span at = cursor_.span();
    const ir::ExpressionId value = expression();
    add(value, to_here(at));
  }
  --brackets_;
  if (!is_read) return native("PO", false, head);
  // PO[X]=(10): that it was one is to be seen, though it bends nothing.
  if (power == ir::kFirstPower) add(constant(0.0, end.span), end.span);
  expect(')');
}

}  // namespace dripfeed::sinumerik
