// Appending to a program's code and tables.
#include "dialects/interpreter/bytecode/code_builder.h"

#include <algorithm>
#include <bit>

namespace dripfeed::interpreter {

CodeBuilder::CodeBuilder(CompiledProgram& out, const CompileContext& context)
    : out_(out), context_(context), next_number_(out.frame_slots), next_string_(out.string_slots) {}

const ir::Expression* CodeBuilder::find_literal(ir::ExpressionId id) const {
  const ir::Expression* e = find(id);
  if (e != nullptr && e->op == ir::Operator::negate) e = find(e->a);
  return e != nullptr && e->op == ir::Operator::constant ? e : nullptr;
}

void CodeBuilder::reserve(std::uint32_t statements) {
  const ir::Program& program = source();
  out_.code.reserve(2 * std::size_t{statements} + 1);
  out_.spans.reserve(2 * std::size_t{statements} + 1);
  if (statements < program.statements.size()) return;  // a part: it is not known how much of the rest is its own
  out_.blocks.reserve(program.blocks.size());
  out_.words.reserve(program.words.size());
  out_.codes.reserve(program.codes.size());
}

std::uint32_t CodeBuilder::emit(Opcode op, text::Span span, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                std::uint8_t extra) {
  out_.code.push_back({.op = op, .extra = extra, .a = a, .b = b, .c = c});
  out_.spans.push_back(span);
  return here() - 1;
}

Operand CodeBuilder::constant(double value) {
  const auto next = make_operand(Space::constant, static_cast<std::uint32_t>(out_.constants.size()));
  const auto [entry, added] = constants_.try_emplace(std::bit_cast<std::uint64_t>(value), next);
  if (added) out_.constants.push_back(value);
  return entry->second;
}

Operand CodeBuilder::text_constant(std::string_view text) {
  const auto next = make_operand(Space::constant, static_cast<std::uint32_t>(out_.texts.size()));
  const auto [entry, added] = texts_.try_emplace(std::string(text), next);
  if (added) out_.texts.emplace_back(text);
  return entry->second;
}

Operand CodeBuilder::take() {
  const std::uint32_t slot = next_number_++;
  out_.frame_slots = std::max(out_.frame_slots, next_number_);
  return make_operand(Space::frame, slot);
}

Operand CodeBuilder::take_string() {
  const std::uint32_t slot = next_string_++;
  out_.string_slots = std::max(out_.string_slots, next_string_);
  return make_operand(Space::frame, slot);
}

std::uint32_t CodeBuilder::add_failure(text::DiagnosticId id, std::vector<std::string> arguments,
                                       ir::AlarmDetail detail) {
  out_.failures.push_back({id, std::move(arguments), detail});
  return static_cast<std::uint32_t>(out_.failures.size() - 1);
}

std::uint32_t CodeBuilder::emit_failure(text::Span span, text::DiagnosticId id, std::vector<std::string> arguments,
                                        ir::AlarmDetail detail) {
  return emit(Opcode::fail, span, add_failure(id, std::move(arguments), detail));
}

std::uint32_t CodeBuilder::add_report(std::string_view name, ir::Function function, bool effects_known) {
  const auto next = static_cast<std::uint32_t>(out_.reports.size());
  const auto [entry, added] = reports_.try_emplace(std::string(name), next);
  if (added) out_.reports.push_back({std::string(name), function, effects_known});
  return entry->second;
}

std::uint32_t CodeBuilder::variable_name_index(std::string_view name) {
  std::vector<std::string>& names = context_.names.variables;
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<std::uint32_t>(found - names.begin());
  names.emplace_back(name);
  return static_cast<std::uint32_t>(names.size() - 1);
}

}  // namespace dripfeed::interpreter
