// Expressions to instructions: where a value is after it was computed. Opcodes are chosen by the control's semantics
// here, once, so that the machine never asks. Variables are read by variable_compiler.h.
#pragma once

#include "dialects/interpreter/bytecode/code_builder.h"
#include "dialects/interpreter/bytecode/variable_compiler.h"

namespace dripfeed::interpreter {

class ExpressionCompiler {
 public:
  explicit ExpressionCompiler(CodeBuilder& builder) : builder_(builder) {}

  // `target`: where the value had best be; it may come to be elsewhere.
  Value compile(ir::ExpressionId id, Operand target = Operand::none);
  // … as a number or a string; an alarm when it is neither and cannot become it.
  Value compile_number(ir::ExpressionId id, Operand target = Operand::none);
  Value compile_string(ir::ExpressionId id);
  // An index: a number, or an axis by its name.
  Value compile_index(ir::ExpressionId id, Operand target = Operand::none);
  // The axis of a name.
  Value as_axis(const Value& name, text::Span span);
  // A word's value: a sign before a vacant variable leaves it vacant.
  Value compile_word(ir::ExpressionId id);
  // a op b of two numbers that are compiled.
  Value combine(ir::Operator op, const Value& a, const Value& b, text::Span span, Operand target = Operand::none);
  [[nodiscard]] VariableCompiler& variables() { return variables_; }

 private:
  Value compile_node(const ir::Expression& e, Operand target);
  Value compile_unary(const ir::Expression& e, Operand target);
  Value compile_binary(const ir::Expression& e, Operand target);
  Value compile_frame(const ir::Expression& e, Operand target);
  Value compile_bound(const ir::Expression& e, Operand target);
  Value compile_string_operator(const ir::Expression& e, Operand target);
  Value compile_string_comparison(const ir::Expression& e, const Value& a, const Value& b, Operand target);
  Value compile_is_variable(const ir::Expression& e);
  Value compile_search(const ir::Expression& e, Operand target);
  Value compile_substring(const ir::Expression& e);
  [[nodiscard]] bool is_shared_variable(ir::ExpressionId id) const;
  Value as_string(const Value& value, text::Span span);
  Value as_number(const Value& value, text::Span span);

  Operand result(Operand target) { return target == Operand::none ? builder_.take() : target; }
  Value constant(double value, ir::ValueType type = ir::ValueType::real);
  [[nodiscard]] text::Span span_of(ir::ExpressionId id) const;
  Value failure(text::Span span, text::DiagnosticId id, std::vector<std::string> arguments);

  CodeBuilder& builder_;
  std::uint32_t depth_ = 0;  // of the expression that is being compiled
  VariableCompiler variables_{builder_, *this};
};

}  // namespace dripfeed::interpreter
