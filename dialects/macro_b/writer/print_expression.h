// print: expressions and numbers in the spelling of Custom Macro B, with as few brackets as read back to the same tree.
#pragma once

#include <cstdint>
#include <string>

#include "dialects/ir/program.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::macro_b {

class ExpressionPrinter {
 public:
  ExpressionPrinter(const ir::Program& program, const Grammar& grammar) : program_(program), grammar_(grammar) {}

  // As it stands after '=' or inside brackets.
  [[nodiscard]] std::string expression(ir::ExpressionId id) const;
  // In brackets of its own: after IF and WHILE.
  [[nodiscard]] std::string condition(ir::ExpressionId id) const { return "[" + expression(id) + "]"; }
  // After an address, constants excepted: #1, -#1, [#1+1.].
  [[nodiscard]] std::string word_value(ir::ExpressionId id) const;
  [[nodiscard]] std::string variable(const ir::Variable& variable) const;
  // A constant in an expression; whole numbers that were written without a point stay so.
  [[nodiscard]] std::string constant(double value, bool has_point) const;

  // Brackets that the printed expression nests, functions included; 0 for a number.
  [[nodiscard]] std::uint32_t depth(ir::ExpressionId id) const;

 private:
  [[nodiscard]] bool is_parameter(const ir::Variable& v) const;
  [[nodiscard]] std::string parameter(const ir::Variable& variable) const;
  [[nodiscard]] std::string operand(ir::ExpressionId id, int least_rank, bool first) const;
  [[nodiscard]] std::string function(const ir::Expression& e) const;
  [[nodiscard]] std::string infix(const ir::Expression& e) const;
  [[nodiscard]] bool ends_with_atan(ir::ExpressionId id) const;
  [[nodiscard]] ir::ExpressionId rounded_operand(const ir::Expression& e) const;

  const ir::Program& program_;
  const Grammar& grammar_;
  bool in_word_ = false;  // ROUND rounds to the increment of the address
};

// False for operators that have no spelling: they are to be rewritten before.
bool can_print(const Grammar& grammar, ir::Operator op);

}  // namespace dripfeed::macro_b
