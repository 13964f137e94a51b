// Operators. Constants are folded; in double precision the frequent operators have opcodes of their own, the rest goes
// through Arithmetic.
#include "dialects/interpreter/bytecode/expression_compiler.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dripfeed::interpreter {

namespace {

using ir::Operator;
using ir::ValueType;
using text::DiagnosticId;

// Deeper trees would take the stack of the compiler itself.
constexpr std::uint32_t kDepthAtMost = 1000;

struct OpcodeRow {
  Operator op;
  Opcode opcode;
};
constexpr OpcodeRow kFastArithmetic[] = {
    {Operator::add, Opcode::add},       {Operator::subtract, Opcode::subtract}, {Operator::multiply, Opcode::multiply},
    {Operator::divide, Opcode::divide}, {Operator::sin, Opcode::sin},           {Operator::cos, Opcode::cos},
    {Operator::sqrt, Opcode::sqrt},
};
constexpr OpcodeRow kExactComparisons[] = {
    {Operator::equal, Opcode::equal},     {Operator::not_equal, Opcode::not_equal},
    {Operator::less, Opcode::less},       {Operator::less_equal, Opcode::less_equal},
    {Operator::greater, Opcode::greater}, {Operator::greater_equal, Opcode::greater_equal},
};

std::optional<Opcode> find_opcode(std::span<const OpcodeRow> rows, Operator op) {
  for (const OpcodeRow& row : rows)
    if (row.op == op) return row.opcode;
  return std::nullopt;
}
std::optional<Opcode> fast_opcode(const ir::Semantics& semantics, Operator op) {
  if (semantics.number_format == ir::NumberFormat::double_precision)
    if (const auto opcode = find_opcode(kFastArithmetic, op)) return opcode;
  if (semantics.comparison == ir::ComparisonMode::exact) return find_opcode(kExactComparisons, op);
  return std::nullopt;
}

constexpr bool is_comparison(Operator op) { return op >= Operator::equal && op <= Operator::greater_equal; }
constexpr bool is_string_operator(Operator op) {
  return (op >= Operator::string_length && op <= Operator::to_lower) || op == Operator::concatenate;
}
constexpr bool is_search(Operator op) {
  return op == Operator::find_text || op == Operator::find_text_last || op == Operator::find_any;
}
constexpr bool is_frame(Operator op) {
  return op == Operator::frame_mirror || (op >= Operator::frame_shift && op <= Operator::frame_chain);
}
constexpr bool is_logic(Operator op) {
  return op == Operator::logic_not || (op >= Operator::logic_and && op <= Operator::logic_xor);
}
// What a control bills as an operator; the others are functions.
constexpr bool costs_operator(Operator op) {
  return op == Operator::negate || op == Operator::logic_not || op == Operator::bit_not ||
         (op >= Operator::add && op <= Operator::concatenate);
}
constexpr bool keeps_integers(Operator op) {
  return op == Operator::add || op == Operator::subtract || op == Operator::multiply ||
         op == Operator::integer_divide || op == Operator::modulo || op == Operator::minimum || op == Operator::maximum;
}
constexpr bool gives_integer(Operator op) {
  return op == Operator::round || op == Operator::truncate || op == Operator::round_up ||
         (op >= Operator::bit_and && op <= Operator::bit_xor) || op == Operator::bit_not;
}
ValueType type_of_result(Operator op, ValueType a, ValueType b) {
  if (is_comparison(op) || is_logic(op)) return ValueType::boolean;
  if (gives_integer(op)) return ValueType::integer;
  const bool integers = a == ValueType::integer && b == ValueType::integer;
  return integers && keeps_integers(op) ? ValueType::integer : ValueType::real;
}

}  // namespace

Value ExpressionCompiler::constant(double value, ValueType type) { return {builder_.constant(value), type, value}; }

text::Span ExpressionCompiler::span_of(ir::ExpressionId id) const {
  const ir::Expression* e = builder_.find(id);
  return e == nullptr ? text::Span() : e->span;
}

Value ExpressionCompiler::failure(text::Span span, DiagnosticId id, std::vector<std::string> arguments) {
  builder_.emit_failure(span, id, std::move(arguments));
  Value value = constant(0.0);
  value.constant.reset();  // not to be folded: the alarm has to be reached
  return value;
}

Value ExpressionCompiler::compile(ir::ExpressionId id, Operand target) {
  if (id == ir::ExpressionId::none) return failure({}, DiagnosticId::missing_operand, {"the expression"});
  const ir::Expression& e = builder_.source().at(id);
  if (depth_ == kDepthAtMost) return failure(e.span, DiagnosticId::limit_reached, {"expression depth"});
  ++depth_;
  const Value value = compile_node(e, target);
  --depth_;
  return value;
}

Value ExpressionCompiler::compile_node(const ir::Expression& e, Operand target) {
  if (costs_operator(e.op))
    ++builder_.work.operators;
  else if (ir::operand_count(e.op) > 0)
    ++builder_.work.functions;
  if (e.op == Operator::constant) {
    const bool whole = !e.has_point && e.value == std::trunc(e.value);
    return constant(e.value, whole ? ValueType::integer : ValueType::real);
  }
  if (e.op == Operator::vacant) return constant(builder_.context().control.semantics.has_vacant ? kVacant : 0.0);
  if (e.op == Operator::variable) return variables_.load(builder_.source().at(e.variable), target);
  if (e.op == Operator::string)
    return {builder_.text_constant(builder_.source().strings.at(e.string)), ValueType::string, std::nullopt};
  if (e.op == Operator::is_variable) return compile_is_variable(e);
  if (e.op == Operator::bound) return compile_bound(e, target);
  if (is_string_operator(e.op)) return compile_string_operator(e, target);
  if (is_search(e.op)) return compile_search(e, target);
  if (e.op == Operator::substring) return compile_substring(e);
  if (is_frame(e.op)) return compile_frame(e, target);
  return ir::operand_count(e.op) == 1 ? compile_unary(e, target) : compile_binary(e, target);
}

Value ExpressionCompiler::compile_number(ir::ExpressionId id, Operand target) {
  const Value value = compile(id, target);
  return value.is_string() ? as_number(value, span_of(id)) : value;
}

Value ExpressionCompiler::compile_index(ir::ExpressionId id, Operand target) {
  const Value value = compile(id, target);
  return value.is_string() ? as_axis(value, span_of(id)) : value;
}

Value ExpressionCompiler::as_axis(const Value& name, text::Span span) {
  if (!name.is_string()) return name;
  const Operand to = builder_.take();
  builder_.emit(Opcode::string_to_axis, span, raw_of(to), raw_of(name.operand));
  return {to, ValueType::axis, std::nullopt};
}

Value ExpressionCompiler::compile_string(ir::ExpressionId id) {
  // What global data holds is known when it is read.
  const ir::Expression* e = builder_.find(id);
  if (e != nullptr && e->op == Operator::variable) {
    const ir::Variable& variable = builder_.source().at(e->variable);
    if (variables_.is_shared(variable)) return variables_.load_shared_text(variable);
  }
  const Value value = compile(id);
  return value.is_string() ? value : as_string(value, span_of(id));
}

Value ExpressionCompiler::compile_word(ir::ExpressionId id) {
  const ir::Expression* e = builder_.find(id);
  const ir::Expression* operand_node = e != nullptr && e->op == Operator::negate ? builder_.find(e->a) : nullptr;
  const bool signed_variable = operand_node != nullptr && operand_node->op == Operator::variable;
  if (!signed_variable || !builder_.context().control.semantics.has_vacant) return compile(id);
  ++builder_.work.operators;
  const Value operand = compile_number(e->a);
  if (operand.constant.has_value()) return constant(is_vacant(*operand.constant) ? kVacant : -*operand.constant);
  const Operand to = builder_.take();
  builder_.emit(Opcode::negate_word, e->span, raw_of(to), raw_of(operand.operand));
  return {to, ValueType::real, std::nullopt};
}

Value ExpressionCompiler::compile_unary(const ir::Expression& e, Operand target) {
  const Value a = compile_number(e.a);
  const ValueType type =
      e.op == Operator::negate || e.op == Operator::abs ? a.type : type_of_result(e.op, a.type, a.type);
  if (a.constant.has_value()) {
    const Outcome folded = builder_.context().arithmetic.unary(e.op, *a.constant);
    if (folded.fault == Fault::none) return constant(folded.value, type);
  }
  const Operand to = result(target);
  if (const auto opcode = fast_opcode(builder_.context().control.semantics, e.op))
    builder_.emit(*opcode, e.span, raw_of(to), raw_of(a.operand));
  else
    builder_.emit(Opcode::unary, e.span, raw_of(to), raw_of(a.operand), 0, static_cast<std::uint8_t>(e.op));
  return {to, type, std::nullopt};
}

// A value that is not known when compiling (global data) may be a frame.
Value ExpressionCompiler::compile_frame(const ir::Expression& e, Operand target) {
  const auto is_none = [](const Value& value) { return value.is_string() || value.constant.has_value(); };
  Value a = e.op == Operator::frame_chain ? compile(e.a) : compile_index(e.a);
  const Value b = e.op == Operator::frame_mirror  ? constant(1.0)
                  : e.op == Operator::frame_chain ? compile(e.b)
                                                  : compile_number(e.b);
  const Operand to = result(target);
  if (e.op != Operator::frame_chain) {
    builder_.emit(Opcode::frame_make, e.span, raw_of(to), raw_of(a.operand), raw_of(b.operand),
                  static_cast<std::uint8_t>(e.op));
  } else if (is_none(a) || is_none(b)) {
    return failure(e.span, DiagnosticId::wrong_type, {"the operand", "REAL", "FRAME"});
  } else {
    builder_.emit(Opcode::frame_chain, e.span, raw_of(to), raw_of(a.operand), raw_of(b.operand));
  }
  return {to, ValueType::frame, std::nullopt};
}

Value ExpressionCompiler::compile_binary(const ir::Expression& e, Operand target) {
  Value a = compile(e.a);
  Value b = compile(e.b);
  if (is_comparison(e.op) && a.is_string() != b.is_string()) {
    // An axis next to its name, or global data next to a text.
    if (a.type == ValueType::axis || b.type == ValueType::axis)
      return combine(e.op, as_axis(a, span_of(e.a)), as_axis(b, span_of(e.b)), e.span, target);
    if (!a.is_string() && is_shared_variable(e.a)) a = compile_string(e.a);
    if (!b.is_string() && is_shared_variable(e.b)) b = compile_string(e.b);
  }
  if (a.type == ValueType::frame || b.type == ValueType::frame)
    return failure(e.span, DiagnosticId::wrong_type, {"the operand", "FRAME", "REAL"});
  if (is_comparison(e.op) && (a.is_string() || b.is_string())) return compile_string_comparison(e, a, b, target);
  return combine(e.op, as_number(a, span_of(e.a)), as_number(b, span_of(e.b)), e.span, target);
}

Value ExpressionCompiler::combine(Operator op, const Value& a, const Value& b, text::Span span, Operand target) {
  const ir::Semantics& semantics = builder_.context().control.semantics;
  const bool whole = op == Operator::divide && !semantics.integer_division_is_real && a.type == ValueType::integer &&
                     b.type == ValueType::integer;
  const ValueType type = whole ? ValueType::integer : type_of_result(op, a.type, b.type);
  if (a.constant.has_value() && b.constant.has_value()) {
    const Arithmetic& arithmetic = builder_.context().arithmetic;
    const Outcome folded =
        whole ? arithmetic.integer_quotient(*a.constant, *b.constant) : arithmetic.binary(op, *a.constant, *b.constant);
    if (folded.fault == Fault::none) return constant(folded.value, type);
  }
  const Operand to = result(target);
  const auto opcode = fast_opcode(semantics, op);
  if (whole)
    builder_.emit(Opcode::integer_quotient, span, raw_of(to), raw_of(a.operand), raw_of(b.operand));
  else if (opcode.has_value())
    builder_.emit(*opcode, span, raw_of(to), raw_of(a.operand), raw_of(b.operand));
  else
    builder_.emit(Opcode::binary, span, raw_of(to), raw_of(a.operand), raw_of(b.operand),
                  static_cast<std::uint8_t>(op));
  return {to, type, std::nullopt};
}

Value ExpressionCompiler::compile_bound(const ir::Expression& e, Operand target) {
  const std::array<ir::ExpressionId, 3> ids{e.a, e.b, e.c};
  const std::array<Operand, 3> row{builder_.take(), builder_.take(), builder_.take()};
  ValueType type = ValueType::integer;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Value value = compile_number(ids[i], row[i]);
    if (value.operand != row[i]) builder_.emit(Opcode::copy, e.span, raw_of(row[i]), raw_of(value.operand));
    if (value.type != ValueType::integer) type = ValueType::real;
  }
  const Operand to = result(target);
  builder_.emit(Opcode::bound, e.span, raw_of(to), raw_of(row[0]));
  return {to, type, std::nullopt};
}

// --- strings
// ----------------------------------------------------------------------------------------------------------

Value ExpressionCompiler::compile_string_operator(const ir::Expression& e, Operand target) {
  const Value a = compile_string(e.a);
  if (e.op == Operator::to_string) return a;
  struct Row {
    Operator op;
    Opcode opcode;
    ValueType type;
  };
  static constexpr Row kToNumber[] = {
      {Operator::string_length, Opcode::string_length, ValueType::integer},
      {Operator::to_number, Opcode::string_to_number, ValueType::real},
      {Operator::is_number, Opcode::string_is_number, ValueType::boolean},
      {Operator::to_axis, Opcode::string_to_axis, ValueType::axis},
  };
  for (const Row& row : kToNumber) {
    if (row.op != e.op) continue;
    const Operand to = result(target);
    builder_.emit(row.opcode, e.span, raw_of(to), raw_of(a.operand));
    return {to, row.type, std::nullopt};
  }
  const Operand to = builder_.take_string();
  if (e.op == Operator::concatenate) {
    const Value b = compile_string(e.b);
    builder_.emit(Opcode::string_join, e.span, raw_of(to), raw_of(a.operand), raw_of(b.operand));
  } else {
    builder_.emit(e.op == Operator::to_upper ? Opcode::string_upper : Opcode::string_lower, e.span, raw_of(to),
                  raw_of(a.operand));
  }
  return {to, ValueType::string, std::nullopt};
}

Value ExpressionCompiler::compile_search(const ir::Expression& e, Operand target) {
  const Value text = compile_string(e.a);
  const Value wanted = compile_string(e.b);
  const Operand to = result(target);
  builder_.emit(Opcode::string_find, e.span, raw_of(to), raw_of(text.operand), raw_of(wanted.operand),
                static_cast<std::uint8_t>(e.op));
  return {to, ValueType::integer, std::nullopt};
}

Value ExpressionCompiler::compile_substring(const ir::Expression& e) {
  const Value text = compile_string(e.a);
  const std::array<Operand, 2> row{builder_.take(), builder_.take()};
  for (std::size_t i = 0; i < row.size(); ++i) {
    const Value value = compile_number(i == 0 ? e.b : e.c, row[i]);
    if (value.operand != row[i]) builder_.emit(Opcode::copy, e.span, raw_of(row[i]), raw_of(value.operand));
  }
  const Operand to = builder_.take_string();
  builder_.emit(Opcode::string_part, e.span, raw_of(to), raw_of(text.operand), raw_of(row.front()));
  return {to, ValueType::string, std::nullopt};
}

Value ExpressionCompiler::compile_string_comparison(const ir::Expression& e, const Value& a, const Value& b,
                                                    Operand target) {
  const bool equality = e.op == Operator::equal || e.op == Operator::not_equal;
  if (!equality || !a.is_string() || !b.is_string())
    return failure(e.span, DiagnosticId::wrong_type,
                   {"an operand of the comparison", "STRING", equality ? "STRING on both sides" : "REAL"});
  const Operand to = result(target);
  builder_.emit(Opcode::string_equal, e.span, raw_of(to), raw_of(a.operand), raw_of(b.operand));
  if (e.op == Operator::not_equal)
    builder_.emit(Opcode::unary, e.span, raw_of(to), raw_of(to), 0, static_cast<std::uint8_t>(Operator::logic_not));
  return {to, ValueType::boolean, std::nullopt};
}

// ISVAR("NAME"): names are known when the program is compiled.
Value ExpressionCompiler::compile_is_variable(const ir::Expression& e) {
  const ir::Program& program = builder_.source();
  const ir::Expression* operand = builder_.find(e.a);
  if (operand != nullptr && operand->op != Operator::string && builder_.context().control.semantics.unset_is_unknown) {
    compile_string(e.a);  // for what it reads; which names there are is known for written names only
    return {builder_.constant(kVacant), ValueType::boolean, std::nullopt};
  }
  if (operand == nullptr || operand->op != Operator::string)
    return failure(e.span, DiagnosticId::not_interpreted, {"ISVAR of a computed name"});
  std::string name(program.strings.at(operand->string));
  name.resize(std::min(name.size(), name.find('[')));
  std::ranges::transform(name, name.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  SharedData& shared = builder_.context().shared;
  for (const ir::Symbol& symbol : program.symbols)
    if (program.strings.at(symbol.name) == name && !symbol.is_global) return constant(1.0, ValueType::boolean);
  if (shared.definition_of(shared.id_of(name)) != nullptr) return constant(1.0, ValueType::boolean);
  for (const ir::SystemVariableRow& row : builder_.context().control.system_variables)
    if (!row.name.empty() && row.name == name) return constant(1.0, ValueType::boolean);
  // Without the definition files no one knows the control's names.
  const bool unknown = builder_.context().control.semantics.unset_is_unknown && !shared.has_definitions();
  if (!unknown) return constant(0.0, ValueType::boolean);
  return {builder_.constant(kVacant), ValueType::boolean, std::nullopt};
}

bool ExpressionCompiler::is_shared_variable(ir::ExpressionId id) const {
  const ir::Expression* e = builder_.find(id);
  return e != nullptr && e->op == Operator::variable && variables_.is_shared(builder_.source().at(e->variable));
}

Value ExpressionCompiler::as_string(const Value& value, text::Span span) {
  if (value.is_string()) return value;
  if (value.type == ValueType::axis) {
    const Operand name = builder_.take_string();
    builder_.emit(Opcode::axis_name, span, raw_of(name), raw_of(value.operand));
    return {name, ValueType::string, std::nullopt};
  }
  const Operand to = builder_.take_string();
  builder_.emit(Opcode::string_from_number, span, raw_of(to), raw_of(value.operand), 0,
                static_cast<std::uint8_t>(value.type));
  return {to, ValueType::string, std::nullopt};
}

Value ExpressionCompiler::as_number(const Value& value, text::Span span) {
  if (!value.is_string()) return value;
  return failure(span, DiagnosticId::wrong_type, {"the operand", "STRING", "REAL"});
}

}  // namespace dripfeed::interpreter
