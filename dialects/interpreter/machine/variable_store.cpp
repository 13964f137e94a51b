// Assigning: each bank has its own rules.
#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/bytecode/expression_compiler.h"
#include "dialects/interpreter/bytecode/variable_compiler.h"
#include "dialects/interpreter/bytecode/variable_registers.h"

namespace dripfeed::interpreter {

namespace {

using ir::Bank;
using ir::ValueType;
using text::DiagnosticId;

}  // namespace

void VariableCompiler::assign(const ir::Variable& target, ir::ExpressionId value, text::Span span) {
  if (is_unknown(target)) {
    failure(span, DiagnosticId::unknown_name, {"here"});
    return;
  }
  count_write(target);
  const bool takes_text =
      target.bank == Bank::named && !is_shared(target) && builder_.source().at(target.symbol).type == ValueType::string;
  if (takes_text)
    if (const auto text = text_of_unknown_type(value)) return store_string(target, *text, span);
  // A plain register takes the result directly, unless the type converts.
  const bool converts = target.bank == Bank::named && !is_part_of_frame(target) &&
                        builder_.source().at(target.symbol).type != ValueType::real;
  const bool writable =
      target.bank == Bank::named ||
      (target.bank != Bank::system && builder_.context().variables.find(target.bank, target.number).writable);
  const Operand at = converts || !writable ? Operand::none : direct(target);
  store(target, expressions_.compile(value, at), span);
}

// Data of the control without a definition, and functions that are not interpreted, may give a text: it is not known.
std::optional<Value> VariableCompiler::text_of_unknown_type(ir::ExpressionId value) {
  const ir::Expression* e = builder_.find(value);
  if (e == nullptr || e->op != ir::Operator::variable) return std::nullopt;
  const ir::Variable& variable = builder_.source().at(e->variable);
  if (is_shared(variable)) return load_shared_text(variable);
  if (variable.bank != Bank::system) return std::nullopt;
  load(variable, Operand::none);
  return Value{builder_.text_constant(kUnknownText), ValueType::string, std::nullopt};
}

void VariableCompiler::store(const ir::Variable& target, const Value& value, text::Span span) {
  if (const auto frame = frame_kind(target)) return store_frame(target, *frame, value, span);
  if (value.type == ValueType::frame && !is_shared(target) &&
      (target.bank != Bank::named || builder_.source().at(target.symbol).type != ValueType::frame)) {
    failure(span, DiagnosticId::wrong_type, {"the value", "FRAME", "REAL"});
    return;
  }
  if (is_shared(target)) return store_shared(target, value, span);
  if (is_part_of_frame(target))
    return store_part(make_operand(Space::frame, slot_of(target.symbol).slot), target.index, target.index2, value,
                      span);
  if (target.bank == Bank::named) return store_symbol(target, value, span);
  if (value.is_string()) {
    failure(span, DiagnosticId::wrong_type,
            {name_of(builder_.source(), builder_.context().control, target), "REAL", "STRING"});
    return;
  }
  if (target.bank != Bank::system) return store_numbered(target, value, span);
  builder_.emit(Opcode::store_system, span, target.number, raw_of(system_index(target)), raw_of(value.operand));
}

Value VariableCompiler::convert(ValueType type, const Value& value, Operand target, text::Span span) {
  if (type == ValueType::axis && value.is_string()) return expressions_.as_axis(value, span);
  if (value.is_string()) {
    const Operand to = target == Operand::none ? builder_.take() : target;
    builder_.emit(Opcode::string_to_value, span, raw_of(to), raw_of(value.operand), 0, static_cast<std::uint8_t>(type));
    return {to, type, std::nullopt};
  }
  if (type == ValueType::real || type == ValueType::axis || type == ValueType::frame) return value;
  // A sum of INTs may be out of range; BOOL and CHAR come from where they were checked.
  if (type == value.type && type != ValueType::integer) return value;
  if (value.constant.has_value()) {
    const Outcome known = builder_.context().arithmetic.convert(type, *value.constant);
    if (known.fault == Fault::none) return {builder_.constant(known.value), type, known.value};
  }
  const Operand to = target == Operand::none ? builder_.take() : target;
  builder_.emit(Opcode::convert, span, raw_of(to), raw_of(value.operand), 0, static_cast<std::uint8_t>(type));
  return {to, type, std::nullopt};
}

void VariableCompiler::store_symbol(const ir::Variable& target, const Value& value, text::Span span) {
  const ir::Symbol& symbol = builder_.source().at(target.symbol);
  const std::string_view name = builder_.source().strings.at(symbol.name);
  if (symbol.type == ValueType::string) return store_string(target, value, span);
  const bool takes_text =
      symbol.type == ValueType::axis || symbol.type == ValueType::character || symbol.type == ValueType::boolean;
  if (value.is_string() && !takes_text) {
    failure(span, DiagnosticId::wrong_type, {"the value for " + std::string(name), "STRING", "a number"});
    return;
  }
  if (symbol.type == ValueType::frame && value.constant.has_value()) {
    failure(span, DiagnosticId::wrong_type, {"the value for " + std::string(name), "REAL", "FRAME"});
    return;
  }
  const SymbolSlot& slot = slot_of(target.symbol);
  const Operand at = direct(target);
  const Value converted = convert(symbol.type, value, at, span);
  if (at != Operand::none) {
    if (converted.operand != at) builder_.emit(Opcode::copy, span, raw_of(at), raw_of(converted.operand));
    return slot.array == kNoArray ? report_variable(at, name, span) : report_element(target, at, span);
  }
  if (slot.array == kNoArray) {
    builder_.emit(Opcode::store_reference, span, raw_of(make_operand(Space::frame, slot.slot)),
                  raw_of(converted.operand));
    return report_variable(converted.operand, name, span);
  }
  if (const Operand index = one_index(target); index != Operand::none)
    builder_.emit(Opcode::store_in_row, span, slot.array, raw_of(index), raw_of(converted.operand));
  else
    builder_.emit(Opcode::store_element, span, slot.array, raw_of(index_registers(target)), raw_of(converted.operand));
  report_element(target, converted.operand, span);
}

void VariableCompiler::report_element(const ir::Variable& target, Operand value, text::Span span) {
  if (builder_.context().reported != Changes::all) return;
  builder_.emit(Opcode::report_element, span, slot_of(target.symbol).array, raw_of(index_registers(target)),
                raw_of(value));
}

void VariableCompiler::store_string(const ir::Variable& target, const Value& value, text::Span span) {
  const ir::Symbol& symbol = builder_.source().at(target.symbol);
  const SymbolSlot& slot = slot_of(target.symbol);
  if (!value.is_string()) {
    failure(span, DiagnosticId::wrong_type,
            {"the value for " + std::string(builder_.source().strings.at(symbol.name)), "REAL", "STRING"});
    return;
  }
  Operand from = value.operand;
  if (symbol.string_length > 0) {
    from = builder_.take_string();
    builder_.emit(Opcode::string_fit, span, raw_of(from), raw_of(value.operand), symbol.string_length);
  }
  if (slot.array == kNoArray)
    builder_.emit(Opcode::string_copy, span, raw_of(make_operand(Space::frame, slot.slot)), raw_of(from));
  else
    builder_.emit(Opcode::string_store_element, span, slot.array, raw_of(index_registers(target)), raw_of(from));
}

void VariableCompiler::store_numbered(const ir::Variable& target, const Value& value, text::Span span) {
  if (target.index != ir::ExpressionId::none) {
    const Value index = expressions_.compile_number(target.index);
    builder_.emit(Opcode::store_number, span, raw_of(index.operand), raw_of(value.operand), 0, extra_of(target.bank));
    if (builder_.context().reported != Changes::none)
      builder_.emit(Opcode::report_number, span, raw_of(index.operand), raw_of(value.operand), 0,
                    extra_of(target.bank));
    return;
  }
  const std::string name = variable_name(target.bank, target.number);
  const Slot slot = builder_.context().variables.find(target.bank, target.number);
  if (slot.kind == SlotKind::none) {
    failure(span, DiagnosticId::variable_out_of_range, {name});
  } else if (!slot.writable) {
    failure(span, DiagnosticId::variable_write_protected, {name});
  } else if (slot.kind == SlotKind::system) {
    builder_.emit(Opcode::store_system, span, slot.index, raw_of(builder_.constant(target.number)),
                  raw_of(value.operand));
  } else {
    const Operand at = register_of(slot);
    builder_.out().named_variables.emplace_back(target.bank, target.number);
    if (value.operand != at) builder_.emit(Opcode::copy, span, raw_of(at), raw_of(value.operand));
    report_variable(at, name, span);
  }
}

void VariableCompiler::initialise(ir::SymbolId symbol, ir::ExpressionId value, text::Span span) {
  const ir::Symbol& declared = builder_.source().at(symbol);
  if (declared.is_global) return;  // a definition file's: it is set when the control starts for the first time
  const SymbolSlot& slot = slot_of(symbol);
  if (slot.array == kNoArray || declared.type == ValueType::string) {
    ir::Variable variable;
    variable.bank = Bank::named;
    variable.symbol = symbol;
    variable.span = span;
    return assign(variable, value, span);
  }
  const Value filled = convert(declared.type, expressions_.compile_number(value), Operand::none, span);
  builder_.emit(Opcode::fill_array, span, slot.array, raw_of(filled.operand));
}

}  // namespace dripfeed::interpreter
