// Definitions and what they make possible: texts longer than their variable, frames with a value in DEF, arrays without
// their indices, chains of operators that have no meaning together.
#include <algorithm>
#include <set>
#include <string>

#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;
using text::DiagnosticId;

constexpr std::size_t kLongestString = 200;

class Definitions {
 public:
  explicit Definitions(const Check& check) : check_(check), program_(check.program) {}

  void run() {
    for (const ir::Symbol& symbol : program_.symbols) symbol_value(symbol);
    for (const ir::Expression& e : program_.expressions) expression(e);
    for (const ir::Statement& s : program_.statements)
      if (s.kind == StatementKind::assign) assignment(program_.assigns[s.payload]);
  }

 private:
  void symbol_value(const ir::Symbol& symbol) {
    if (symbol.span.empty() || symbol.initial == ExpressionId::none) return;
    if (symbol.type == ir::ValueType::frame)
      check_.report(DiagnosticId::initial_value_not_allowed, symbol.span, {name_of(symbol)}).alarm = "12261";
    text_fits(symbol, symbol.initial);
  }

  void assignment(const ir::Assign& assign) {
    if (assign.target == ir::VariableId::none || assign.value == ExpressionId::none) return;
    const ir::Variable& target = program_.at(assign.target);
    if (target.bank == ir::Bank::named && target.symbol != ir::SymbolId::none)
      text_fits(program_.at(target.symbol), assign.value);
    element(target);
  }

  void text_fits(const ir::Symbol& symbol, ExpressionId value) {
    const ir::Expression& e = program_.at(value);
    if (e.op != Operator::string || symbol.type != ir::ValueType::string || symbol.string_length == 0) return;
    const std::size_t length = program_.strings.at(e.string).size();
    if (length > symbol.string_length && length <= kLongestString) too_long(e, length, symbol.string_length);
  }

  void too_long(const ir::Expression& e, std::size_t length, std::size_t most) {
    check_.report(DiagnosticId::string_too_long, e.span, {std::to_string(length), std::to_string(most)}).alarm =
        "12210";
  }

  void expression(const ir::Expression& e) {
    if (e.op == Operator::string && !e.span.empty()) {
      const std::size_t length = program_.strings.at(e.string).size();
      if (length > kLongestString) too_long(e, length, kLongestString);
    }
    if (e.op == Operator::frame_chain) {
      for (const ExpressionId side : {e.a, e.b}) frame_operand(side);
    }
    // The whole array may be handed on by reference: a variable alone is reported where it is calculated with.
    if (is_arithmetic(e.op)) {
      for (const ExpressionId side : {e.a, e.b})
        if (side != ExpressionId::none && program_.at(side).op == Operator::variable)
          element(program_.at(program_.at(side).variable));
    }
  }

  // CTRANS(X,1):CROT(Z,45)+1
  void frame_operand(ExpressionId side) {
    if (side == ExpressionId::none) return;
    const ir::Expression& e = program_.at(side);
    const std::string_view word = word_of(e.op);
    if (word.empty()) return;
    check_.report(DiagnosticId::operators_do_not_chain, e.span, {":", std::string(word)}).alarm = "12180";
  }

  static bool is_arithmetic(Operator op) { return !word_of(op).empty(); }
  static std::string_view word_of(Operator op) {
    struct Row {
      Operator op;
      std::string_view word;
    };
    static constexpr Row kRows[] = {
        {Operator::add, "+"}, {Operator::subtract, "-"}, {Operator::multiply, "*"}, {Operator::divide, "/"}};
    const auto* const row = std::ranges::find(kRows, op, &Row::op);
    return row == std::end(kRows) ? std::string_view() : row->word;
  }

  void element(const ir::Variable& v) {
    if (v.bank != ir::Bank::named || v.symbol == ir::SymbolId::none || v.index != ExpressionId::none) return;
    const ir::Symbol& symbol = program_.at(v.symbol);
    // Of a parameter the caller decides, and an array in an axis' or a string's place has an index of another kind.
    if (symbol.span.empty() || symbol.dimension1 == 0 || symbol.is_parameter) return;
    if (!reported_.insert(v.span.begin).second) return;
    check_.report(DiagnosticId::array_element_missing, v.span, {std::string(check_.text_of(v.span)), name_of(symbol)})
        .alarm = "12400";
  }

  [[nodiscard]] std::string name_of(const ir::Symbol& symbol) const {
    return std::string(program_.strings.at(symbol.name));
  }

  const Check& check_;
  const ir::Program& program_;
  std::set<std::uint32_t> reported_;
};

}  // namespace

void check_definitions(const Check& check) { Definitions(check).run(); }

}  // namespace dripfeed::sinumerik
