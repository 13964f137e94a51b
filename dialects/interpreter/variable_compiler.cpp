// Every bank has its own way: numbers are looked up in the control's ranges, names in the program's symbols, system
// variables in the control's table.
#include "dialects/interpreter/variable_compiler.h"

#include <array>
#include <cmath>

#include "dialects/interpreter/expression_compiler.h"
#include "dialects/interpreter/unknown.h"

namespace dripfeed::interpreter {

namespace {

using ir::Bank;
using ir::ValueType;
using text::DiagnosticId;

constexpr std::uint32_t kNoArray = 0xFFFFFFFFU;

std::uint8_t extra_of(Bank bank) { return static_cast<std::uint8_t>(bank); }

// A name that the reader could not resolve.
bool is_unknown(const ir::Variable& variable) {
  return variable.bank == Bank::named && variable.symbol == ir::SymbolId::none;
}

Operand register_of(Slot slot) {
  if (slot.kind == SlotKind::global) return make_operand(Space::global, slot.index);
  if (slot.kind == SlotKind::local) return make_operand(Space::local, slot.index);
  return Operand::none;
}

}  // namespace

std::string name_of(const ir::Program& program, const ir::Control& control, const ir::Variable& variable) {
  if (variable.bank == Bank::named) return std::string(program.strings.at(program.at(variable.symbol).name));
  if (variable.bank == Bank::system && variable.name != ir::StringId::none)
    return std::string(program.strings.at(variable.name));
  if (variable.bank == Bank::system)
    return variable.number < control.system_variables.size()
               ? std::string(control.system_variables[variable.number].name)
               : "$";
  if (variable.index != ir::ExpressionId::none) return variable.bank == Bank::r ? "R[…]" : "#[…]";
  return variable_name(variable.bank, variable.number);
}

Value VariableCompiler::failure(text::Span span, DiagnosticId id, std::vector<std::string> arguments) {
  builder_.emit_failure(span, id, std::move(arguments));
  return {builder_.constant(0.0), ValueType::real, std::nullopt};
}

const SymbolSlot& VariableCompiler::slot_of(ir::SymbolId symbol) const {
  return builder_.out().symbols[static_cast<std::uint32_t>(symbol)];
}

Operand VariableCompiler::direct(const ir::Variable& variable) const {
  if (variable.bank == Bank::named) {
    const ir::Symbol& symbol = builder_.source().at(variable.symbol);
    const SymbolSlot& slot = slot_of(variable.symbol);
    if (symbol.is_global) return Operand::none;
    const bool plain = slot.array == kNoArray && !symbol.by_reference && symbol.type != ValueType::string;
    return plain ? make_operand(Space::frame, slot.slot) : Operand::none;
  }
  if (variable.bank == Bank::system || variable.index != ir::ExpressionId::none) return Operand::none;
  return register_of(builder_.context().variables.find(variable.bank, variable.number));
}

Operand VariableCompiler::index_registers(const ir::Variable& variable) {
  const std::array<Operand, 3> to{builder_.take(), builder_.take(), builder_.take()};
  const std::array<ir::ExpressionId, 3> ids{variable.index, variable.index2, variable.index3};
  for (std::size_t n = 0; n < to.size(); ++n) {
    const Value value = ids[n] == ir::ExpressionId::none ? Value{builder_.constant(0.0), ValueType::integer, 0.0}
                                                         : expressions_.compile_index(ids[n], to[n]);
    if (value.operand != to[n]) builder_.emit(Opcode::copy, variable.span, raw_of(to[n]), raw_of(value.operand));
  }
  return to.front();
}

std::uint8_t VariableCompiler::index_count(const ir::Variable& variable) {
  if (variable.index3 != ir::ExpressionId::none) return 3;
  if (variable.index2 != ir::ExpressionId::none) return 2;
  return variable.index != ir::ExpressionId::none ? 1 : 0;
}

bool VariableCompiler::is_shared(const ir::Variable& variable) const {
  if (variable.bank == Bank::system) return variable.name != ir::StringId::none;
  return variable.bank == Bank::named && variable.symbol != ir::SymbolId::none &&
         builder_.source().at(variable.symbol).is_global;
}

std::uint32_t VariableCompiler::shared_id(const ir::Variable& variable) const {
  const ir::Program& program = builder_.source();
  SharedData& shared = builder_.context().shared;
  const std::uint32_t id = shared.id_of(
      program.strings.at(variable.bank == Bank::system ? variable.name : program.at(variable.symbol).name));
  shared.note_indices(id, index_count(variable));
  return id;
}

ValueType VariableCompiler::shared_type(const ir::Variable& variable) const {
  if (variable.bank == Bank::system) return ValueType::real;
  const SharedDefinition* definition = builder_.context().shared.definition_of(shared_id(variable));
  return definition == nullptr ? builder_.source().at(variable.symbol).type : definition->type;
}

// The instruction that reads, writes or refers to a value of the control; the operands stand as its opcode says.
void VariableCompiler::emit_shared(Opcode op, const ir::Variable& variable, Operand value, text::Span span) {
  const bool writes = op == Opcode::store_shared || op == Opcode::store_shared_text;
  const std::uint32_t id = shared_id(variable);
  const std::uint8_t count = index_count(variable);
  const std::uint32_t indices = count == 0 ? 0 : raw_of(index_registers(variable));
  const std::uint32_t at = writes ? builder_.emit(op, span, id, indices, raw_of(value), count)
                                  : builder_.emit(op, span, raw_of(value), id, indices, count);
  if (variable.bank == Bank::system) builder_.at(at).detail = static_cast<std::uint16_t>(variable.number + 1);
}

Value VariableCompiler::load_shared(const ir::Variable& variable, Operand target) {
  const ValueType type = shared_type(variable);
  if (type == ValueType::string) return load_shared_text(variable);
  const Operand to = target == Operand::none ? builder_.take() : target;
  emit_shared(Opcode::load_shared, variable, to, variable.span);
  return {to, type, std::nullopt};
}

Value VariableCompiler::load_shared_text(const ir::Variable& variable) {
  const Operand to = builder_.take_string();
  emit_shared(Opcode::load_shared_text, variable, to, variable.span);
  return {to, ValueType::string, std::nullopt};
}

void VariableCompiler::store_shared(const ir::Variable& target, const Value& value, text::Span span) {
  const ValueType type = shared_type(target);
  const bool declared =
      target.bank == Bank::named && builder_.context().shared.definition_of(shared_id(target)) != nullptr;
  if (declared && value.is_string() != (type == ValueType::string) && type != ValueType::axis) {
    failure(span, DiagnosticId::wrong_type,
            {name_of(builder_.source(), builder_.context().control, target),
             type == ValueType::string ? "STRING" : "REAL", value.is_string() ? "STRING" : "REAL"});
    return;
  }
  if (value.is_string() && type != ValueType::axis)
    return emit_shared(Opcode::store_shared_text, target, value.operand, span);
  emit_shared(Opcode::store_shared, target, convert(type, value, Operand::none, span).operand, span);
}

Operand VariableCompiler::system_index(const ir::Variable& variable) {
  return variable.index == ir::ExpressionId::none ? builder_.constant(0.0)
                                                  : expressions_.compile_number(variable.index).operand;
}

// --- reading
// ----------------------------------------------------------------------------------------------------------

Value VariableCompiler::load(const ir::Variable& variable, Operand target) {
  if (is_unknown(variable)) return failure(variable.span, DiagnosticId::unknown_name, {"here"});
  const bool numbered = variable.bank == Bank::hash || variable.bank == Bank::r;
  ++(numbered ? builder_.work.number_reads : builder_.work.named_reads);
  if (const auto frame = frame_kind(variable)) return load_frame(variable, *frame, target);
  if (const auto given = load_given(variable, target)) return *given;
  if (is_shared(variable)) return load_shared(variable, target);
  if (is_part_of_frame(variable))
    return load_part(make_operand(Space::frame, slot_of(variable.symbol).slot), variable.index, variable.index2,
                     variable.span, target);
  if (variable.bank == Bank::named) return load_symbol(variable, target);
  if (numbered) return load_numbered(variable, target);
  const Operand index = system_index(variable);
  const Operand to = target == Operand::none ? builder_.take() : target;
  builder_.emit(Opcode::load_system, variable.span, raw_of(to), variable.number, raw_of(index));
  return {to, ValueType::real, std::nullopt};
}

// $P_SUBPAR[n]: whether the n-th parameter of this program was given.
std::optional<Value> VariableCompiler::load_given(const ir::Variable& variable, Operand target) {
  if (variable.bank != Bank::system || variable.name == ir::StringId::none) return std::nullopt;
  if (builder_.source().strings.at(variable.name) != "$P_SUBPAR") return std::nullopt;
  const ir::Expression* number = builder_.find(variable.index);
  if (number == nullptr || number->op != ir::Operator::constant || number->value < 1.0) return std::nullopt;
  const Operand to = target == Operand::none ? builder_.take() : target;
  const auto parameter = static_cast<std::uint32_t>(std::fmin(number->value, 1e6)) - 1;
  builder_.emit(Opcode::load_given, variable.span, raw_of(to), parameter);
  return Value{to, ValueType::boolean, std::nullopt};
}

Value VariableCompiler::load_symbol(const ir::Variable& variable, Operand target) {
  const ir::Symbol& symbol = builder_.source().at(variable.symbol);
  const SymbolSlot& slot = slot_of(variable.symbol);
  if (symbol.type == ValueType::string) {
    if (slot.array == kNoArray) return {make_operand(Space::frame, slot.slot), ValueType::string, std::nullopt};
    const Operand indices = index_registers(variable);
    const Operand to = builder_.take_string();
    builder_.emit(Opcode::string_load_element, variable.span, raw_of(to), slot.array, raw_of(indices));
    return {to, ValueType::string, std::nullopt};
  }
  if (const Operand at = direct(variable); at != Operand::none) return {at, symbol.type, std::nullopt};
  const Operand indices = slot.array == kNoArray ? Operand::none : index_registers(variable);
  const Operand to = target == Operand::none ? builder_.take() : target;
  if (slot.array == kNoArray)
    builder_.emit(Opcode::load_reference, variable.span, raw_of(to), raw_of(make_operand(Space::frame, slot.slot)));
  else
    builder_.emit(Opcode::load_element, variable.span, raw_of(to), slot.array, raw_of(indices));
  return {to, symbol.type, std::nullopt};
}

Value VariableCompiler::load_numbered(const ir::Variable& variable, Operand target) {
  if (variable.index != ir::ExpressionId::none) {
    const Value index = expressions_.compile_number(variable.index);
    const Operand to = target == Operand::none ? builder_.take() : target;
    builder_.emit(Opcode::load_number, variable.span, raw_of(to), raw_of(index.operand), 0, extra_of(variable.bank));
    return {to, ValueType::real, std::nullopt};
  }
  const Slot slot = builder_.context().variables.find(variable.bank, variable.number);
  if (slot.kind == SlotKind::vacant) return {builder_.constant(kVacant), ValueType::real, kVacant};
  if (const Operand at = register_of(slot); at != Operand::none) {
    builder_.out().named_variables.emplace_back(variable.bank, variable.number);
    return {at, ValueType::real, std::nullopt};
  }
  if (slot.kind == SlotKind::none)
    return failure(variable.span, DiagnosticId::variable_out_of_range, {variable_name(variable.bank, variable.number)});
  const Operand to = target == Operand::none ? builder_.take() : target;
  builder_.emit(Opcode::load_system, variable.span, raw_of(to), slot.index, raw_of(builder_.constant(variable.number)));
  return {to, ValueType::real, std::nullopt};
}

// --- assigning
// --------------------------------------------------------------------------------------------------------

void VariableCompiler::assign(const ir::Variable& target, ir::ExpressionId value, text::Span span) {
  if (is_unknown(target)) {
    failure(span, DiagnosticId::unknown_name, {"here"});
    return;
  }
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

// Data of the control without a definition, and functions that are not interpreted, may give a text: nobody knows.
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
    return tell(at, name, span);
  }
  if (slot.array == kNoArray) {
    builder_.emit(Opcode::store_reference, span, raw_of(make_operand(Space::frame, slot.slot)),
                  raw_of(converted.operand));
    return tell(converted.operand, name, span);
  }
  const Operand indices = index_registers(target);
  builder_.emit(Opcode::store_element, span, slot.array, raw_of(indices), raw_of(converted.operand));
  if (builder_.context().observed)
    builder_.emit(Opcode::tell_element, span, slot.array, raw_of(indices), raw_of(converted.operand));
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
    if (builder_.context().observed)
      builder_.emit(Opcode::tell_number, span, raw_of(index.operand), raw_of(value.operand), 0, extra_of(target.bank));
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
    tell(at, name, span);
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

// --- references and observers
// -----------------------------------------------------------------------------------------

Operand VariableCompiler::refer(const ir::Variable& variable) {
  if (is_unknown(variable)) return Operand::none;
  if (is_shared(variable)) {
    if (shared_type(variable) == ValueType::string) return Operand::none;
    const Operand to = builder_.take();
    emit_shared(Opcode::refer_shared, variable, to, variable.span);
    return to;
  }
  if (variable.bank == Bank::system) return Operand::none;
  const Operand at = direct(variable);
  if (at == Operand::none && variable.bank == Bank::named) {
    const SymbolSlot& slot = slot_of(variable.symbol);
    if (builder_.source().at(variable.symbol).type == ValueType::string) return Operand::none;
    // A parameter by reference is a reference itself.
    if (slot.array == kNoArray) return make_operand(Space::frame, slot.slot);
    const Operand indices = index_registers(variable);
    const Operand to = builder_.take();
    builder_.emit(Opcode::refer_element, variable.span, raw_of(to), slot.array, raw_of(indices));
    return to;
  }
  if (at == Operand::none && variable.index == ir::ExpressionId::none) return Operand::none;
  if (at != Operand::none) {
    const Operand to = builder_.take();
    builder_.emit(Opcode::refer, variable.span, raw_of(to), raw_of(at));
    return to;
  }
  const Value index = expressions_.compile_number(variable.index);
  const Operand to = builder_.take();
  builder_.emit(Opcode::refer_number, variable.span, raw_of(to), raw_of(index.operand), 0, extra_of(variable.bank));
  return to;
}

void VariableCompiler::tell(Operand operand, std::string_view name, text::Span span) {
  if (builder_.context().observed)
    builder_.emit(Opcode::tell, span, raw_of(operand), builder_.variable_name_index(name));
}

}  // namespace dripfeed::interpreter
