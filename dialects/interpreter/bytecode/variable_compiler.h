// Variables to instructions: reading, assigning with the type's conversion, and references for parameters. Where a
// number or a name is a fixed register, no instruction is needed to read it.
#pragma once

#include <optional>
#include <string>

#include "dialects/interpreter/bytecode/code_builder.h"

namespace dripfeed::interpreter {

class ExpressionCompiler;

// A compiled expression: the register that holds its value when the code before has run.
struct Value {
  Operand operand = Operand::none;
  ir::ValueType type = ir::ValueType::real;  // string: a string register
  std::optional<double> constant;            // known now
  [[nodiscard]] bool is_string() const { return type == ir::ValueType::string; }
};

class VariableCompiler {
 public:
  VariableCompiler(CodeBuilder& builder, ExpressionCompiler& expressions)
      : builder_(builder), expressions_(expressions) {}

  Value load(const ir::Variable& variable, Operand target);
  // One more write, in the block's work.
  void count_write(const ir::Variable& variable);
  // variable = expression, converted to the variable's type.
  void assign(const ir::Variable& target, ir::ExpressionId value, text::Span span);
  void store(const ir::Variable& target, const Value& value, text::Span span);
  // Initialises a declared name with an expression; an array with the same value in every element.
  void initialise(ir::SymbolId symbol, ir::ExpressionId value, text::Span span);
  // A register with a reference to the variable, for a parameter by reference; none for what cannot be referred to.
  Operand refer(const ir::Variable& variable);
  // Data of the control: global user data, a system variable by name.
  [[nodiscard]] bool is_shared(const ir::Variable& variable) const;
  // … read as a text, whatever it was set to.
  Value load_shared_text(const ir::Variable& variable);

 private:
  std::optional<Value> load_given(const ir::Variable& variable, Operand target);
  Value load_symbol(const ir::Variable& variable, Operand target);
  Value load_numbered(const ir::Variable& variable, Operand target);
  void store_symbol(const ir::Variable& target, const Value& value, text::Span span);
  void store_string(const ir::Variable& target, const Value& value, text::Span span);
  std::optional<Value> text_of_unknown_type(ir::ExpressionId value);
  // The frames of the control and the parts of frames.
  [[nodiscard]] std::optional<ir::SystemValue> frame_kind(const ir::Variable& variable) const;
  [[nodiscard]] bool is_part_of_frame(const ir::Variable& variable) const;
  Value load_frame(const ir::Variable& variable, ir::SystemValue kind, Operand target);
  void store_frame(const ir::Variable& target, ir::SystemValue kind, const Value& value, text::Span span);
  Operand part_registers(ir::ExpressionId axis, ir::ExpressionId part, text::Span span);
  Value load_part(Operand frame, ir::ExpressionId axis, ir::ExpressionId part, text::Span span, Operand target);
  void store_part(Operand frame, ir::ExpressionId axis, ir::ExpressionId part, const Value& value, text::Span span);
  void store_numbered(const ir::Variable& target, const Value& value, text::Span span);
  Value convert(ir::ValueType type, const Value& value, Operand target, text::Span span);
  // The register that the variable is, when it is one.
  [[nodiscard]] Operand direct(const ir::Variable& variable) const;
  // Three registers in a row with the indices of an array element.
  Operand index_registers(const ir::Variable& variable);
  [[nodiscard]] Operand fixed_element(const ir::Variable& variable) const;
  Operand one_index(const ir::Variable& variable);
  static std::uint8_t index_count(const ir::Variable& variable);
  [[nodiscard]] std::uint32_t shared_id(const ir::Variable& variable) const;
  [[nodiscard]] ir::ValueType shared_type(const ir::Variable& variable) const;
  void emit_shared(Opcode op, const ir::Variable& variable, Operand value, text::Span span);
  Value load_shared(const ir::Variable& variable, Operand target);
  void store_shared(const ir::Variable& target, const Value& value, text::Span span);
  Operand system_index(const ir::Variable& variable);
  Value failure(text::Span span, text::DiagnosticId id, std::vector<std::string> arguments);
  void report_element(const ir::Variable& target, Operand value, text::Span span);
  void report_variable(Operand operand, std::string_view name, text::Span span);
  [[nodiscard]] const SymbolSlot& slot_of(ir::SymbolId symbol) const;

  CodeBuilder& builder_;
  ExpressionCompiler& expressions_;
};

// How the control writes the variable: "#100", "R5", "COUNTER"; "#[…]" when its number is computed.
std::string name_of(const ir::Program& program, const ir::Control& control, const ir::Variable& variable);

}  // namespace dripfeed::interpreter
