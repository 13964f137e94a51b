// Appending to the arenas; which statement a verb becomes is build's.
#include "dialects/family/emitter.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace dripfeed::family {

namespace {

using ir::Function;
using ir::ModalGroup;

struct GroupRow {
  Function function;
  ModalGroup group;
};
constexpr auto kGroups = std::to_array<GroupRow>({
    {Function::rapid, ModalGroup::motion},
    {Function::linear, ModalGroup::motion},
    {Function::arc_cw, ModalGroup::motion},
    {Function::arc_ccw, ModalGroup::motion},
    {Function::dwell, ModalGroup::non_modal},
    {Function::plane_xy, ModalGroup::plane},
    {Function::plane_zx, ModalGroup::plane},
    {Function::unit_mm, ModalGroup::unit},
    {Function::unit_inch, ModalGroup::unit},
    {Function::absolute, ModalGroup::distance},
    {Function::feed_per_min, ModalGroup::feed},
    {Function::feed_per_rev, ModalGroup::feed},
    {Function::comp_off, ModalGroup::comp},
    {Function::comp_left, ModalGroup::comp},
    {Function::comp_right, ModalGroup::comp},
    {Function::thread, ModalGroup::motion},
    {Function::thread_changing, ModalGroup::motion},
    {Function::feed_inverse_time, ModalGroup::feed},
    {Function::plane_yz, ModalGroup::plane},
    {Function::machine_coordinates, ModalGroup::non_modal},
    {Function::exact_stop_once, ModalGroup::non_modal},
    {Function::length_offset_plus, ModalGroup::length_offset},
    {Function::length_offset_minus, ModalGroup::length_offset},
    {Function::length_offset_off, ModalGroup::length_offset},
    {Function::diameter_on, ModalGroup::diameter},
    {Function::diameter_off, ModalGroup::diameter},
    {Function::work_offset, ModalGroup::work_offset},
    {Function::surface_speed_on, ModalGroup::surface_speed},
    {Function::surface_speed_off, ModalGroup::surface_speed},
    {Function::spindle_cw, ModalGroup::spindle},
    {Function::spindle_ccw, ModalGroup::spindle},
    {Function::spindle_stop, ModalGroup::spindle},
    {Function::coolant_mist, ModalGroup::coolant},
    {Function::coolant_flood, ModalGroup::coolant},
    {Function::coolant_off, ModalGroup::coolant},
    {Function::program_stop, ModalGroup::flow},
    {Function::optional_stop, ModalGroup::flow},
    {Function::program_end_rewind, ModalGroup::flow},
});

}  // namespace

ModalGroup group_of(Function function) {
  const auto row = std::ranges::find(kGroups, function, &GroupRow::function);
  return row == kGroups.end() ? ModalGroup::none : row->group;
}

void Emitter::statement(ir::StatementKind kind, std::size_t payload) {
  ir::Statement out;
  out.kind = kind;
  out.payload = static_cast<std::uint32_t>(payload);
  out.line = line_;
  program_.statements.push_back(out);
}

void Emitter::block(std::span<const EmittedCode> codes, std::span<const EmittedWord> words) {
  ir::Block block;
  block.first_code = static_cast<std::uint32_t>(program_.codes.size());
  block.code_count = static_cast<std::uint32_t>(codes.size());
  block.first_word = static_cast<std::uint32_t>(program_.words.size());
  block.word_count = static_cast<std::uint32_t>(words.size());
  for (const EmittedCode& emitted : codes) {
    ir::Code code;
    code.function = emitted.function;
    code.argument = emitted.argument;
    code.group = group_of(emitted.function);
    if (emitted.function == Function::machine_function) code.letter = 'M';
    program_.codes.push_back(code);
  }
  for (const EmittedWord& emitted : words) {
    ir::Word word;
    word.address = emitted.address;
    word.value = emitted.value;
    word.mode = emitted.mode;
    program_.words.push_back(word);
  }
  program_.blocks.push_back(block);
  statement(ir::StatementKind::block, program_.blocks.size() - 1);
}

void Emitter::block(std::initializer_list<Function> functions, std::span<const EmittedWord> words) {
  std::vector<EmittedCode> codes;
  for (const Function function : functions) codes.push_back({function});
  block(codes, words);
}

void Emitter::assign(ir::SymbolId target, ir::ExpressionId value, ir::ExpressionId index) {
  ir::Variable variable;
  variable.bank = ir::Bank::named;
  variable.symbol = target;
  variable.index = index;
  program_.assigns.push_back({program_.add(variable), value});
  statement(ir::StatementKind::assign, program_.assigns.size() - 1);
}

void Emitter::open(ir::StatementKind kind, ir::ExpressionId condition) {
  ir::Structure structure;
  structure.condition = condition;
  program_.structures.push_back(structure);
  statement(kind, program_.structures.size() - 1);
}

void Emitter::close(ir::StatementKind kind) { open(kind, ir::ExpressionId::none); }

void Emitter::message(std::string_view text) {
  ir::Message message;
  if (!text.empty()) {
    ir::Expression expression;
    expression.op = ir::Operator::string;
    expression.string = program_.strings.add(text);
    message.text = program_.add(expression);
  }
  program_.messages.push_back(message);
  statement(ir::StatementKind::message, program_.messages.size() - 1);
}

// The statement's payload is a block that holds the code alone.
void Emitter::program_end() {
  block({Function::program_end_rewind}, {});
  program_.statements.back().kind = ir::StatementKind::program_end;
}

void Emitter::subprogram_return() { statement(ir::StatementKind::subprogram_return, ir::kNoIndex); }

ir::ExpressionId Emitter::variable(ir::SymbolId symbol, ir::ExpressionId index) {
  ir::Variable out;
  out.bank = ir::Bank::named;
  out.symbol = symbol;
  out.index = index;
  return program_.add_variable(out);
}

ir::SymbolId Emitter::new_symbol(std::string_view stem) {
  std::string name(stem);
  for (int i = 2; program_.strings.find(name) != ir::StringId::none; ++i) name = fmt::format("{}{}", stem, i);
  ir::Symbol symbol;
  symbol.name = program_.strings.add(name);
  return program_.add(symbol);
}

}  // namespace dripfeed::family
