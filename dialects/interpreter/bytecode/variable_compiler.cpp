// Every bank has its own rules: numbers are looked up in the control's ranges, names in the program's symbols, system
// variables in the control's table.
#include "dialects/interpreter/bytecode/variable_compiler.h"

#include <array>
#include <cmath>

#include "dialects/interpreter/bytecode/expression_compiler.h"
#include "dialects/interpreter/bytecode/variable_registers.h"

namespace dripfeed::interpreter {

namespace {

using ir::Bank;
using ir::ValueType;
using text::DiagnosticId;

bool is_numbered(const ir::Variable& variable) { return variable.bank == Bank::hash || variable.bank == Bank::r; }
// An index of the control's own data names an axis or a place of a table that it has at hand.
bool is_indexed(const ir::Variable& variable) {
  return variable.bank != Bank::system && variable.index != ir::ExpressionId::none;
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

void VariableCompiler::count_write(const ir::Variable& variable) {
  ++(is_numbered(variable) ? builder_.work.number_writes : builder_.work.named_writes);
  builder_.work.indexed += is_indexed(variable) ? 1U : 0U;
}

const SymbolSlot& VariableCompiler::slot_of(ir::SymbolId symbol) const {
  return builder_.out().symbols[static_cast<std::uint32_t>(symbol)];
}

Operand VariableCompiler::direct(const ir::Variable& variable) const {
  if (variable.bank == Bank::named) {
    const ir::Symbol& symbol = builder_.source().at(variable.symbol);
    const SymbolSlot& slot = slot_of(variable.symbol);
    if (symbol.is_global || symbol.by_reference || symbol.type == ValueType::string) return Operand::none;
    return slot.array == kNoArray ? make_operand(Space::frame, slot.slot) : fixed_element(variable);
  }
  if (variable.bank == Bank::system || variable.index != ir::ExpressionId::none) return Operand::none;
  return register_of(builder_.context().variables.find(variable.bank, variable.number));
}

// The register of an element whose one index is a number of the text.
Operand VariableCompiler::fixed_element(const ir::Variable& variable) const {
  const Array& array = builder_.out().arrays[slot_of(variable.symbol).array];
  const ir::Expression* index = builder_.find(variable.index);
  if (index_count(variable) != 1 || index == nullptr || index->op != ir::Operator::constant || array.dimension2 != 1 ||
      array.dimension3 != 1)
    return Operand::none;
  if (!(index->value >= 0.0 && index->value < array.dimension1) || index->value != std::floor(index->value))
    return Operand::none;
  return make_operand(Space::frame, array.first_slot + static_cast<std::uint32_t>(index->value));
}

// The register of its one index, where it has no more.
Operand VariableCompiler::one_index(const ir::Variable& variable) {
  if (index_count(variable) != 1) return Operand::none;
  const Array& array = builder_.out().arrays[slot_of(variable.symbol).array];
  if (array.dimension2 != 1 || array.dimension3 != 1) return Operand::none;
  return expressions_.compile_index(variable.index, Operand::none).operand;
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
  // A text of one character is one (CHAR), and the name of an axis is an axis.
  const bool takes_text = type == ValueType::axis || type == ValueType::character;
  if (declared && value.is_string() != (type == ValueType::string) && !takes_text) {
    failure(span, DiagnosticId::wrong_type,
            {name_of(builder_.source(), builder_.context().control, target),
             type == ValueType::string ? "STRING" : "REAL", value.is_string() ? "STRING" : "REAL"});
    return;
  }
  if (value.is_string() && !takes_text) return emit_shared(Opcode::store_shared_text, target, value.operand, span);
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
  const bool numbered = is_numbered(variable);
  ++(numbered ? builder_.work.number_reads : builder_.work.named_reads);
  builder_.work.indexed += is_indexed(variable) ? 1U : 0U;
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

// Whether the n-th parameter of this program was given.
std::optional<Value> VariableCompiler::load_given(const ir::Variable& variable, Operand target) {
  const auto rows = builder_.context().control.system_variables;
  const bool has_row =
      variable.bank == Bank::system && variable.name != ir::StringId::none && variable.number < rows.size();
  if (!has_row || rows[variable.number].kind != ir::SystemValue::parameter_given) return std::nullopt;
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
  const Operand index = slot.array == kNoArray ? Operand::none : one_index(variable);
  const Operand indices = slot.array == kNoArray || index != Operand::none ? Operand::none : index_registers(variable);
  const Operand to = target == Operand::none ? builder_.take() : target;
  if (slot.array == kNoArray)
    builder_.emit(Opcode::load_reference, variable.span, raw_of(to), raw_of(make_operand(Space::frame, slot.slot)));
  else if (index != Operand::none)
    builder_.emit(Opcode::load_of_row, variable.span, raw_of(to), slot.array, raw_of(index));
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

void VariableCompiler::report_variable(Operand operand, std::string_view name, text::Span span) {
  if (builder_.context().reported != Changes::none)
    builder_.emit(Opcode::report_variable, span, raw_of(operand), builder_.variable_name_index(name));
}

}  // namespace dripfeed::interpreter
