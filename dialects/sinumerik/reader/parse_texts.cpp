// Texts in values: a value as a text, and the characters of a text (PGA, "String operations").
#include "dialects/sinumerik/reader/parse.h"

namespace dripfeed::sinumerik {

using ir::Operator;

// TEXT=<<R1: the value as a text, as if an empty one stood before it.
ir::ExpressionId Parser::text_of_value(text::Span head) {
  if (nesting_ >= kDeepestNesting) return missing_operand();
  ++nesting_;
  operator_ = head;
  cursor_.advance();
  ir::Expression empty;
  empty.op = Operator::string;
  empty.string = program_.strings.add("");
  empty.span = {head.begin, head.begin};
  const ir::ExpressionId before = program_.add(empty);
  const ir::ExpressionId value = binary(static_cast<std::uint8_t>(rank_of(Operator::concatenate) - 1));
  --nesting_;
  in_parentheses_ = false;
  return program_.add_operator(Operator::concatenate, before, value, join(head, program_.at(value).span));
}

bool Parser::is_character(ir::ExpressionId id) const {
  const ir::Expression& e = program_.at(id);
  if (e.op != Operator::variable) return false;
  const ir::Variable& v = program_.at(e.variable);
  return v.bank == ir::Bank::named && lower_.is_declared(v.symbol) &&
         program_.at(v.symbol).type == ir::ValueType::character;
}

// IF LETTER=="C": next to a CHAR a text of one character is its code.
ir::ExpressionId Parser::character_code(ir::ExpressionId id) {
  const ir::Expression& e = program_.at(id);
  const std::string_view text = e.op == Operator::string ? program_.strings.at(e.string) : std::string_view();
  return text.size() == 1 ? constant(static_cast<unsigned char>(text.front()), e.span) : id;
}

// The index that picks a character of a text, one more than the array has; nullptr where it is none.
ir::ExpressionId* Parser::character_index(ir::Variable& v) const {
  if (v.bank != ir::Bank::named || !lower_.is_declared(v.symbol)) return nullptr;
  const ir::Symbol& symbol = program_.at(v.symbol);
  if (symbol.type != ir::ValueType::string) return nullptr;
  ir::ExpressionId* const index = symbol.dimension1 == 0 ? &v.index : symbol.dimension2 == 0 ? &v.index2 : &v.index3;
  return *index == ir::ExpressionId::none ? nullptr : index;
}

// TEXT[2]: its third character (PGA, "Reading and writing of individual characters").
std::optional<ir::ExpressionId> Parser::character_of(ir::VariableId id) {
  ir::Variable whole = program_.at(id);
  ir::ExpressionId* const index = character_index(whole);
  if (index == nullptr) return std::nullopt;
  ir::Expression part;
  part.op = Operator::substring;
  part.span = whole.span;
  part.b = *index;
  *index = ir::ExpressionId::none;
  part.a = program_.add_variable(whole);
  part.c = constant(1.0, whole.span);
  return program_.add(part);
}

}  // namespace dripfeed::sinumerik
