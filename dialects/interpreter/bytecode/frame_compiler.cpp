// Frames of the control and parts of frames, as a part of compiling variables.
#include "dialects/interpreter/bytecode/expression_compiler.h"
#include "dialects/interpreter/bytecode/variable_compiler.h"

namespace dripfeed::interpreter {

using ir::Bank;
using ir::SystemValue;
using ir::ValueType;
using text::DiagnosticId;

// A part of a settable frame is a number of the control's memory like others; all else that names a frame is one.
std::optional<SystemValue> VariableCompiler::frame_kind(const ir::Variable& variable) const {
  if (variable.bank != Bank::system || variable.name == ir::StringId::none || variable.number == 0) return std::nullopt;
  const auto rows = builder_.context().control.system_variables;
  if (variable.number >= rows.size()) return std::nullopt;
  const SystemValue kind = rows[variable.number].kind;
  if (kind < SystemValue::programmable_frame || kind > SystemValue::total_frame) return std::nullopt;
  const bool part_of_settable = kind == SystemValue::settable_frame && variable.index2 != ir::ExpressionId::none;
  return part_of_settable ? std::nullopt : std::optional(kind);
}

bool VariableCompiler::is_part_of_frame(const ir::Variable& variable) const {
  if (variable.bank != Bank::named || variable.index2 == ir::ExpressionId::none || is_shared(variable)) return false;
  const ir::Symbol& symbol = builder_.source().at(variable.symbol);
  return symbol.type == ValueType::frame && symbol.dimension1 == 0 && !symbol.by_reference;
}

Operand VariableCompiler::part_registers(ir::ExpressionId axis, ir::ExpressionId part, text::Span span) {
  const Operand first = builder_.take();
  const Operand second = builder_.take();
  const Value a = expressions_.compile_index(axis, first);
  if (a.operand != first) builder_.emit(Opcode::copy, span, raw_of(first), raw_of(a.operand));
  const Value b = expressions_.compile_number(part, second);
  if (b.operand != second) builder_.emit(Opcode::copy, span, raw_of(second), raw_of(b.operand));
  return first;
}

Value VariableCompiler::load_part(Operand frame, ir::ExpressionId axis, ir::ExpressionId part, text::Span span,
                                  Operand target) {
  const Operand row = part_registers(axis, part, span);
  const Operand to = target == Operand::none ? builder_.take() : target;
  builder_.emit(Opcode::frame_part, span, raw_of(to), raw_of(frame), raw_of(row));
  return {to, ValueType::real, std::nullopt};
}

void VariableCompiler::store_part(Operand frame, ir::ExpressionId axis, ir::ExpressionId part, const Value& value,
                                  text::Span span) {
  const Operand row = part_registers(axis, part, span);
  builder_.emit(Opcode::frame_set_part, span, raw_of(frame), raw_of(row), raw_of(value.operand));
}

Value VariableCompiler::load_frame(const ir::Variable& variable, SystemValue kind, Operand target) {
  const bool numbered = kind == SystemValue::settable_frame;
  const bool part = !numbered && variable.index2 != ir::ExpressionId::none;
  const Operand index = numbered ? system_index(variable) : builder_.constant(0.0);
  const Operand to = target == Operand::none || part ? builder_.take() : target;
  builder_.emit(Opcode::load_frame, variable.span, raw_of(to), raw_of(index), 0, static_cast<std::uint8_t>(kind));
  if (part) return load_part(to, variable.index, variable.index2, variable.span, target);
  return {to, ValueType::frame, std::nullopt};
}

void VariableCompiler::store_frame(const ir::Variable& target, SystemValue kind, const Value& value, text::Span span) {
  if (kind == SystemValue::total_frame) {
    failure(span, DiagnosticId::variable_write_protected,
            {std::string(builder_.context().control.system_variables[target.number].name)});
    return;
  }
  const bool numbered = kind == SystemValue::settable_frame;
  const bool part = !numbered && target.index2 != ir::ExpressionId::none;
  if (!part && (value.is_string() || value.constant.has_value())) {
    failure(span, DiagnosticId::wrong_type,
            {"the value for the frame", value.is_string() ? "STRING" : "REAL", "FRAME"});
    return;
  }
  const Operand index = numbered ? system_index(target) : builder_.constant(0.0);
  Operand from = value.operand;
  if (part) {
    from = builder_.take();
    builder_.emit(Opcode::load_frame, span, raw_of(from), raw_of(index), 0, static_cast<std::uint8_t>(kind));
    store_part(from, target.index, target.index2, value, span);
  }
  builder_.emit(Opcode::store_frame, span, raw_of(from), raw_of(index), 0, static_cast<std::uint8_t>(kind));
}

}  // namespace dripfeed::interpreter
