// Values. Operators are read by their rank, strongest first, equal ranks from left to right; a comparison is the
// weakest of all, weaker than AND and OR, and where it meets one of them without parentheses there is a warning.
#include <algorithm>
#include <numbers>

#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/system_variables.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Operator;
using ir::TokenKind;
using text::DiagnosticId;

constexpr double kLongestString = 200.0;

bool is_comparison(Operator op) { return op >= Operator::equal && op <= Operator::greater_equal; }
bool is_logic(Operator op) {
  return op == Operator::logic_and || op == Operator::logic_or || op == Operator::logic_xor ||
         op == Operator::logic_not;
}

Operator symbol_operator(std::string_view symbol) {
  struct Row {
    std::string_view spelling;
    Operator op;
  };
  static constexpr Row kRows[] = {
      {"+", Operator::add},          {"-", Operator::subtract},
      {"*", Operator::multiply},     {"/", Operator::divide},
      {"==", Operator::equal},       {"<>", Operator::not_equal},
      {"<", Operator::less},         {">", Operator::greater},
      {"<=", Operator::less_equal},  {">=", Operator::greater_equal},
      {"<<", Operator::concatenate},
  };
  for (const Row& row : kRows)
    if (row.spelling == symbol) return row.op;
  return Operator::constant;
}

double based_value(std::string_view token) {
  const char base = to_upper(token[1]);
  const double radix = base == 'H' ? 16.0 : base == 'B' ? 2.0 : 10.0;
  double value = 0.0;
  for (const char c : token.substr(2, token.size() - 3)) {
    const int digit = is_digit(c) ? c - '0' : to_upper(c) - 'A' + 10;
    value = value * radix + digit;
  }
  return value;
}

bool is_based(std::string_view token) {
  const std::string_view digits = token.substr(2, token.size() - 3);
  switch (to_upper(token[1])) {
    case 'H':
      return std::ranges::all_of(digits,
                                 [](char c) { return is_digit(c) || (to_upper(c) >= 'A' && to_upper(c) <= 'F'); });
    case 'B': return std::ranges::all_of(digits, [](char c) { return c == '0' || c == '1'; });
    case 'D': return std::ranges::all_of(digits, is_digit);
    default: return false;
  }
}

}  // namespace

ir::ExpressionId Parser::constant(double value, text::Span span) { return program_.add_constant(value, span, false); }

ir::ExpressionId Parser::expression() {
  in_parentheses_ = false;
  const ir::ExpressionId value = binary(kWeakestRank);
  return frame_chain(value);
}

// The operator at the cursor; constant when there is none.
Operator Parser::infix_here(std::uint8_t& rank) const {
  Operator op = Operator::constant;
  if (cursor_.kind() == TokenKind::symbol) {
    op = symbol_operator(cursor_.text());
  } else if (cursor_.kind() == TokenKind::name) {
    const Keyword* keyword = find_keyword(cursor_.text());
    if (keyword != nullptr && keyword->role == Role::infix) {
      rank = keyword->rank;
      return keyword->op;
    }
  }
  if (op != Operator::constant) rank = rank_of(op);
  return op;
}

ir::ExpressionId Parser::binary(std::uint8_t weakest) {
  ir::ExpressionId left = unary();
  bool left_in_parentheses = in_parentheses_;
  std::uint8_t rank = 0;
  for (Operator op = infix_here(rank); op != Operator::constant && rank <= weakest; op = infix_here(rank)) {
    operator_ = cursor_.span();
    const text::Span sign = operator_;
    if (++operators_ > kMostOperators) {
      give_up(DiagnosticId::syntax_error, sign,
              {"a block of more than " + std::to_string(kMostOperators) + " operators"});
      return left;
    }
    cursor_.advance();
    ir::ExpressionId right = binary(static_cast<std::uint8_t>(rank - 1));
    if (is_comparison(op)) {
      if (is_character(left)) right = character_code(right);
      if (is_character(right)) left = character_code(left);
      warn_of_rank(left, left_in_parentheses, sign);
      warn_of_rank(right, in_parentheses_, sign);
    }
    const text::Span span = join(program_.at(left).span, program_.at(right).span);
    left = program_.add_operator(op, left, right, span);
    left_in_parentheses = false;
    in_parentheses_ = false;
  }
  return left;
}

void Parser::warn_of_rank(ir::ExpressionId operand, bool in_parentheses, text::Span span) {
  const Operator op = program_.at(operand).op;
  if (!in_parentheses && is_logic(op))
    report(DiagnosticId::comparison_with_logic, span, {std::string(spelling_of(op))});
}

ir::ExpressionId Parser::unary() {
  const text::Span head = cursor_.span();
  const bool sign = cursor_.is_symbol('-') || cursor_.is_symbol('+');
  const Keyword* keyword = cursor_.kind() == TokenKind::name ? find_keyword(cursor_.text()) : nullptr;
  const bool prefix = keyword != nullptr && keyword->role == Role::prefix;
  if (cursor_.is_symbol("<<")) return text_of_value(head);
  if (!sign && !prefix) return primary();
  ir::ExpressionId value = ir::ExpressionId::none;
  if (sign && signed_constant(value)) {
    in_parentheses_ = false;
    return value;
  }
  if (nesting_ >= kDeepestNesting) return missing_operand();
  ++nesting_;
  const bool plus = cursor_.is_symbol('+');
  operator_ = head;
  cursor_.advance();
  value = unary();
  --nesting_;
  in_parentheses_ = false;
  if (plus) return value;
  return program_.add_operator(sign ? Operator::negate : keyword->op, value, ir::ExpressionId::none,
                               join(head, program_.at(value).span));
}

ir::ExpressionId Parser::primary() {
  in_parentheses_ = false;
  switch (cursor_.kind()) {
    case TokenKind::number: return number();
    case TokenKind::string: return string_literal();
    case TokenKind::name: return name_value();
    case TokenKind::variable: {
      if (same_name(cursor_.text(), "$PI")) {
        const text::Span span = cursor_.span();
        cursor_.advance();
        return program_.add_constant(std::numbers::pi, span, true);
      }
      const ir::VariableId id = variable();
      ir::Expression e;
      e.op = Operator::variable;
      e.variable = id;
      e.span = program_.at(id).span;
      return program_.add(e);
    }
    case TokenKind::address:
      // AXIVAR=C and AXIVAR=X1 at the end of a block are axes, X=- F=1 is not.
      return brackets_ > 0 || is_axis_at_end() ? axis_name() : missing_operand();
    case TokenKind::symbol:
      if (cursor_.is_symbol('(')) {
        const ir::ExpressionId value = parenthesized();
        in_parentheses_ = true;
        return value;
      }
      return missing_operand();
    case TokenKind::white:
    case TokenKind::eob:
    case TokenKind::comment:
    case TokenKind::tape_mark:
    case TokenKind::skip:
    case TokenKind::invalid: return missing_operand();
  }
  return missing_operand();
}

bool Parser::is_axis_at_end() const {
  TokenCursor after = cursor_.after();
  const bool joined = after.kind() == TokenKind::number && after.span().begin == cursor_.span().end;
  if (joined && std::ranges::all_of(after.text(), is_digit)) after.advance();
  return after.at_block_end();
}

// Nothing is taken: what stands here may begin the next word.
ir::ExpressionId Parser::missing_operand() {
  const text::Span span = operator_.empty() ? cursor_.span() : operator_;
  report(DiagnosticId::missing_operand, span, {std::string(span.in(cursor_.whole()))});
  return constant(0.0, span);
}

ir::ExpressionId Parser::parenthesized() {
  const text::Span before = operator_;
  const text::Span head = cursor_.span();
  if (nesting_ >= kDeepestNesting) {
    give_up(DiagnosticId::bracket_nesting_too_deep, head, {std::to_string(nesting_), std::to_string(kDeepestNesting)});
    return constant(0.0, head);
  }
  expect('(');
  if (cursor_.is_symbol(')')) {
    cursor_.advance();
    const text::Span span = to_here(head);
    const std::string_view of = (before.empty() ? span : before).in(cursor_.whole());
    report(DiagnosticId::missing_operand, span, {std::string(of)});
    return constant(0.0, span);
  }
  ++nesting_;
  ++brackets_;
  ir::ExpressionId value = binary(kWeakestRank);
  if (const auto known_to_control = macro_operator()) value = *known_to_control;
  --brackets_;
  --nesting_;
  expect(')');
  operator_ = before;
  return value;
}

ir::ExpressionId Parser::number() {
  const text::Span span = cursor_.span();
  const std::string_view token = cursor_.text();
  cursor_.advance();
  if (token.front() == '\'') {
    if (!is_based(token)) {
      report(DiagnosticId::malformed_number, span, {std::string(token)});
      return constant(0.0, span);
    }
    return constant(based_value(token), span);
  }
  const auto decimal = text::read_decimal(token);
  double value = decimal ? decimal->value : 0.0;
  if (decimal && decimal->length < token.size()) {
    // 1.5EX-3: what JSON and C write with a plain e
    const std::string exponent =
        std::string(token.substr(0, decimal->length)) + "e" + std::string(token.substr(decimal->length + 2));
    const auto scaled = text::parse_number(exponent);
    if (!scaled) report(DiagnosticId::malformed_number, span, {std::string(token)});
    value = scaled.value_or(0.0);
  }
  return program_.add_constant(value, span, decimal && decimal->has_point);
}

ir::ExpressionId Parser::string_literal() {
  const text::Span span = cursor_.span();
  std::string_view content = cursor_.text().substr(1);
  if (content.empty() || content.back() != '"') {
    report(DiagnosticId::unterminated_string, span);
    faulty_ = true;
  } else {
    content.remove_suffix(1);
  }
  cursor_.advance();
  ir::Expression e;
  e.op = Operator::string;
  e.string = program_.strings.add(content);
  e.span = span;
  return program_.add(e);
}

// A letter or X1 as a value: the name of an axis or spindle, as a string.
ir::ExpressionId Parser::axis_name() {
  text::Span span = cursor_.span();
  cursor_.advance();
  if (cursor_.kind() == TokenKind::number && cursor_.span().begin == span.end) {
    span.end = cursor_.span().end;
    cursor_.advance();
  }
  ir::Expression e;
  e.op = Operator::string;
  e.string = lower_.name(span.in(cursor_.whole()));
  e.span = span;
  return program_.add(e);
}

ir::ExpressionId Parser::name_value() {
  const text::Span span = cursor_.span();
  const std::string_view name = cursor_.text();
  if (const auto value = macro_value()) return *value;
  const bool declared = is_variable(name);
  const Keyword* keyword = declared ? nullptr : find_keyword(name);
  if (keyword != nullptr) {
    switch (keyword->role) {
      case Role::constant: cursor_.advance(); return constant(same_name(name, "TRUE") ? 1.0 : 0.0, span);
      case Role::function:
        cursor_.advance();
        if (keyword->name == "CRPL") return frame_in_plane(*keyword, span);
        return is_frame_of_axes(keyword->op) ? frame_of_axes(*keyword, span) : function_call(*keyword, span);
      case Role::foreign: cursor_.advance(); return foreign_call(span);
      // Words of later versions and options, which elsewhere may be names: a value that only the control knows.
      case Role::procedure:
      case Role::cycle:
      case Role::address:
        if (!cursor_.after().is_symbol('(')) break;
        cursor_.advance();
        return foreign_call(span);
      case Role::infix:
      case Role::prefix:
      case Role::word_mode:
      case Role::statement:
      case Role::type:
      case Role::attribute: return missing_operand();
    }
  }
  const TokenCursor next = cursor_.after();
  if (brackets_ == 0 && !in_condition_ && next.is_symbol('=')) return missing_operand();
  if (next.is_symbol('(') && !declared) {
    report(DiagnosticId::unknown_name, span, {std::string(name)});
    cursor_.advance();
    return foreign_call(span);
  }
  const ir::VariableId id = variable();
  if (const auto character = character_of(id)) return *character;
  ir::Expression e;
  e.op = Operator::variable;
  e.variable = id;
  e.span = program_.at(id).span;
  return program_.add(e);
}

ir::ExpressionId Parser::function_call(const Keyword& keyword, text::Span name) {
  operator_ = name;
  ir::Expression e;
  e.op = keyword.op;
  const int wanted = ir::operand_count(keyword.op);
  ir::ExpressionId operands[3] = {ir::ExpressionId::none, ir::ExpressionId::none, ir::ExpressionId::none};
  int given = 0;
  if (nesting_ >= kDeepestNesting) return missing_operand();
  expect('(');
  ++brackets_;
  ++nesting_;
  do {
    operator_ = name;
    const ir::ExpressionId value = binary(kWeakestRank);
    if (given < 3) operands[given] = value;
    ++given;
  } while (cursor_.take(','));
  --nesting_;
  --brackets_;
  expect(')');
  e.span = to_here(name);
  // SUBSTR(text, first): to the end.
  if (keyword.op == Operator::substring && given == 2) {
    operands[2] = constant(kLongestString, e.span);
    given = 3;
  }
  if (given != wanted) {
    report(DiagnosticId::wrong_argument_count, e.span,
           {std::string(keyword.name), std::to_string(wanted), std::to_string(given)});
    for (ir::ExpressionId& operand : operands)
      if (operand == ir::ExpressionId::none) operand = constant(0.0, e.span);
  }
  e.a = operands[0];
  if (wanted > 1) e.b = operands[1];
  if (wanted > 2) e.c = operands[2];
  in_parentheses_ = false;
  return program_.add(e);
}

// INDEX(…), AX[…]: the arguments are read, so that the names in them count as used; the value is a system variable that
// no run can answer.
ir::ExpressionId Parser::foreign_call(text::Span name) {
  ir::Variable value;
  value.bank = ir::Bank::system;
  value.number = find_system_variable(name.in(cursor_.whole()));
  const bool square = cursor_.is_symbol('[');
  if (nesting_ >= kDeepestNesting) return missing_operand();
  if (square || cursor_.is_symbol('(')) {
    ++brackets_;
    ++nesting_;
    operator_ = name;
    cursor_.advance();
    const char end = square ? ']' : ')';
    while (!cursor_.is_symbol(end) && !cursor_.at_block_end()) {
      const std::uint32_t before = cursor_.index();
      if (!cursor_.is_symbol(',')) (void)binary(kWeakestRank);
      if (!cursor_.take(',') && cursor_.index() == before) break;
    }
    --nesting_;
    --brackets_;
    expect(end);
  }
  value.span = to_here(name);
  in_parentheses_ = false;
  return program_.add_variable(value);
}

}  // namespace dripfeed::sinumerik
