// The statements that are no control flow, and the frame around all of them.
#include "dialects/interpreter/bytecode/statement_compiler.h"

#include <algorithm>

namespace dripfeed::interpreter {

using ir::StatementKind;

constexpr StatementCompiler::Row StatementCompiler::kRows[] = {
    {StatementKind::block, &StatementCompiler::compile_block},
    {StatementKind::assign, &StatementCompiler::compile_assign},
    {StatementKind::define, &StatementCompiler::compile_define},
    {StatementKind::procedure, &StatementCompiler::compile_procedure},
    {StatementKind::call, &StatementCompiler::compile_call},
    {StatementKind::subprogram_return, &StatementCompiler::compile_return},
    {StatementKind::return_to, &StatementCompiler::compile_return_to},
    {StatementKind::modal_call, &StatementCompiler::compile_modal_call},
    {StatementKind::modal_call_end, &StatementCompiler::compile_modal_call_end},
    {StatementKind::output, &StatementCompiler::compile_output},
    {StatementKind::program_end, &StatementCompiler::compile_program_end},
    {StatementKind::message, &StatementCompiler::compile_message},
    {StatementKind::alarm, &StatementCompiler::compile_alarm},
    {StatementKind::native, &StatementCompiler::compile_native},
    {StatementKind::repeat_section, &StatementCompiler::compile_repeat},
    {StatementKind::execute_text, &StatementCompiler::compile_text},
    {StatementKind::declaration, &StatementCompiler::compile_nothing},
};

StatementCompiler::StatementCompiler(CodeBuilder& builder)
    : builder_(builder),
      expressions_(builder),
      blocks_(builder, expressions_),
      flow_(builder, expressions_),
      calls_(builder, expressions_) {}

void StatementCompiler::compile(std::uint32_t returns_after) {
  const ir::Program& program = builder_.source();
  const bool whole = program.sections.empty();
  const std::uint32_t first = whole ? 0 : program.sections[builder_.out().section].first;
  const std::uint32_t last =
      whole ? static_cast<std::uint32_t>(program.statements.size()) : program.sections[builder_.out().section].last;
  compile_statements(first, last, returns_after);
  builder_.emit(Opcode::text_end, ir::span_of_last(program, first, last), 0, program.is_data ? kNothingMissing : 0);
  flow_.resolve(code_, first);
}

void StatementCompiler::compile_part(std::uint32_t first, std::uint32_t last) {
  compile_statements(first, last, ir::kNoIndex);
  builder_.emit(Opcode::back, ir::span_of_last(builder_.source(), first, last), 0, 1);
  flow_.resolve(code_, first);
}

void StatementCompiler::compile_statements(std::uint32_t first, std::uint32_t last, std::uint32_t returns_after) {
  builder_.out().works.push_back({.blocks = 1});  // a block without anything to compute
  const ir::Program& program = builder_.source();
  builder_.reserve(last - first);
  if (!program.repeats.empty()) repeated_ = ir::repeated_parts(program);
  code_.resize(last - first);
  for (std::uint32_t i = first; i < last; ++i) {
    compile_stretches(i);
    code_[i - first].begin = builder_.here();
    if (!begin_foreign_part(i)) compile_statement(i);
    end_foreign_part(i);
    code_[i - first].end = builder_.here();  // a loop that ends here leads to the end of the part, too
    for (std::uint32_t id = 0; id < repeated_.size(); ++id)
      if (repeated_[id].last == i) flow_.compile_section_end(repeated_[id].repeat, id);
    if (i == returns_after) builder_.emit(Opcode::back, program.statements[i].span);
  }
  end_block();
}

void StatementCompiler::compile_stretches(std::uint32_t statement) {
  const ir::PlainStretches* stretches = builder_.context().stretches;
  if (stretches == nullptr || builder_.out().index != 0) return;
  for (; next_stretch_ < stretches->all.size() && stretches->all[next_stretch_].statement <= statement;
       ++next_stretch_) {
    end_block();
    builder_.emit(Opcode::plain_stretch, builder_.source().statements[statement].span, next_stretch_);
  }
}

// True when the statement does nothing else.
bool StatementCompiler::begin_foreign_part(std::uint32_t statement) {
  const auto& parts = builder_.source().foreign_parts;
  while (next_part_ < parts.size() && parts[next_part_].last <= statement) ++next_part_;
  if (next_part_ == parts.size() || parts[next_part_].first != statement) return false;
  const ir::Statement& first = builder_.source().statements[statement];
  const bool switches = first.span.begin < parts[next_part_].text.begin;  // it is no block of the part
  if (switches && is_left_out(first)) return true;
  if (switches) begin_block(first);
  part_instruction_ = builder_.emit(Opcode::foreign_part, first.span, next_part_);
  return switches;
}

void StatementCompiler::end_foreign_part(std::uint32_t statement) {
  if (part_instruction_ == ir::kNoIndex || builder_.source().foreign_parts[next_part_].last != statement + 1) return;
  end_block();
  builder_.at(part_instruction_).b = builder_.here();
  part_instruction_ = ir::kNoIndex;
  const auto& statements = builder_.source().statements;
  const bool is_switch =
      builder_.source().foreign_parts[next_part_].ends_by_switch && statement + 1 < statements.size();
  if (is_switch && is_left_out(statements[statement + 1]))
    builder_.emit(
        Opcode::report, statements[statement + 1].span,
        builder_.add_report("a switch of the language that block skip leaves out", ir::Function::not_modelled, false),
        1);
}

// Structures have no skip: a control refuses it, and half of one would be another program.
bool StatementCompiler::is_left_out(const ir::Statement& statement) const {
  return builder_.context().skips(statement.skip_level) && !ir::is_structure(statement.kind);
}

void StatementCompiler::compile_statement(std::uint32_t index) {
  const ir::Statement& statement = builder_.source().statements[index];
  if (statement.kind == StatementKind::empty || is_left_out(statement)) return;
  if (ir::begins_block(builder_.source(), index) || block_instruction_ == ir::kNoIndex) begin_block(statement);
  const CodeBuilder::Mark mark = builder_.mark();
  if (!flow_.compile(index)) {
    const auto row = std::ranges::find(kRows, statement.kind, &Row::kind);
    (this->*row->compile)(statement);
  }
  builder_.release(mark);
}

void StatementCompiler::begin_block(const ir::Statement& statement) {
  end_block();
  block_instruction_ = builder_.emit(Opcode::block, statement.span, statement.line);
  // A control that comes to the end of a WHILE or LOOP goes back without reading a block (G. Nikiel, table 5: WHILE is
  // no slower than IF … GOTOB); that of a FOR steps and tests as its head does.
  closes_round_ = statement.kind == StatementKind::while_end || statement.kind == StatementKind::loop_end;
  if (closes_round_ || statement.kind == StatementKind::for_end) ++builder_.work.rounds;
}

void StatementCompiler::end_block() {
  Work& work = builder_.work;
  work.blocks += closes_round_ ? 0U : 1U;
  if (block_instruction_ != ir::kNoIndex && work != builder_.out().works.front()) {
    builder_.at(block_instruction_).b = static_cast<std::uint32_t>(builder_.out().works.size());
    builder_.out().works.push_back(work);
  }
  closes_round_ = false;
  builder_.work = {};
  block_instruction_ = ir::kNoIndex;
}

void StatementCompiler::compile_repeat(const ir::Statement& statement) {
  const auto index = static_cast<std::uint32_t>(&statement - builder_.source().statements.data());
  const auto part = std::ranges::find(repeated_, index, &ir::RepeatedPart::repeat);
  const ir::Repeat& repeat = builder_.source().repeats[statement.payload];
  if (!part->is_found()) {
    const bool first = part->first == ir::kNoIndex;
    const ir::StringId name = first ? repeat.first : repeat.last;
    builder_.emit_failure(
        statement.span, text::DiagnosticId::jump_target_missing,
        {name != ir::StringId::none ? std::string(builder_.source().strings.at(name))
                                    : "N" + std::to_string(first ? repeat.first_number : repeat.last_number)});
    return;
  }
  const Operand times = repeat.times == ir::ExpressionId::none ? builder_.constant(1.0)
                                                               : expressions_.compile_number(repeat.times).operand;
  const auto id = static_cast<std::uint32_t>(part - repeated_.begin());
  flow_.compile_section_begin(part->first, times, id, statement.span);
}

void StatementCompiler::compile_text(const ir::Statement& statement) {
  const ir::Message& message = builder_.source().messages[statement.payload];
  builder_.emit(Opcode::execute_text, statement.span, raw_of(expressions_.compile_string(message.text).operand));
}

void StatementCompiler::compile_nothing(const ir::Statement&) {}

void StatementCompiler::compile_block(const ir::Statement& statement) {
  blocks_.compile(builder_.source().blocks[statement.payload], statement.span);
}

void StatementCompiler::compile_assign(const ir::Statement& statement) {
  const ir::Assign& assign = builder_.source().assigns[statement.payload];
  if (assign.target == ir::VariableId::none || assign.value == ir::ExpressionId::none) {
    builder_.emit_failure(statement.span, text::DiagnosticId::missing_operand, {"the assignment"});
    return;
  }
  expressions_.variables().assign(builder_.source().at(assign.target), assign.value, statement.span);
}

void StatementCompiler::compile_define(const ir::Statement& statement) {
  const ir::Structure& list = builder_.source().structures[statement.payload];
  for (std::uint32_t i = 0; i < list.symbol_count; ++i) {
    const auto symbol = static_cast<ir::SymbolId>(list.first_symbol + i);
    const ir::ExpressionId initial = builder_.source().at(symbol).initial;
    if (initial != ir::ExpressionId::none) expressions_.variables().initialise(symbol, initial, statement.span);
  }
}

// The head gives the parameters that were left out their defaults.
void StatementCompiler::compile_procedure(const ir::Statement& statement) {
  const ir::Structure& head = builder_.source().structures[statement.payload];
  std::uint32_t parameter = 0;
  for (std::uint32_t i = 0; i < head.symbol_count; ++i) {
    const auto id = static_cast<ir::SymbolId>(head.first_symbol + i);
    const ir::Symbol& symbol = builder_.source().at(id);
    if (!symbol.is_parameter) continue;
    const std::uint32_t number = parameter++;
    if (symbol.initial == ir::ExpressionId::none || symbol.by_reference) continue;
    const std::uint32_t given = builder_.emit(Opcode::skip_given, statement.span, number);
    expressions_.variables().initialise(id, symbol.initial, statement.span);
    builder_.at(given).b = builder_.here();
  }
}

void StatementCompiler::compile_call(const ir::Statement& statement) {
  calls_.compile(builder_.source().calls[statement.payload], statement.span);
}

void StatementCompiler::compile_return(const ir::Statement& statement) { builder_.emit(Opcode::back, statement.span); }

void StatementCompiler::compile_return_to(const ir::Statement& statement) {
  flow_.compile_return_jump(builder_.source().jumps[statement.payload], statement.span);
}

void StatementCompiler::compile_modal_call(const ir::Statement& statement) {
  calls_.compile_modal(builder_.source().calls[statement.payload], statement.span);
}

void StatementCompiler::compile_modal_call_end(const ir::Statement& statement) {
  builder_.emit(Opcode::modal_end, statement.span);
}

// The values of the parts stand in registers in a row.
void StatementCompiler::compile_output(const ir::Statement& statement) {
  const ir::Program& program = builder_.source();
  const ir::Output& output = program.outputs[statement.payload];
  std::vector<Operand> registers;
  registers.reserve(output.part_count);
  for (std::uint32_t i = 0; i < output.part_count; ++i) registers.push_back(builder_.take());
  for (std::uint32_t i = 0; i < output.part_count; ++i) {
    const ir::OutputPart& part = program.output_parts[output.first_part + i];
    if (part.value == ir::ExpressionId::none) continue;
    const Value value = expressions_.compile_number(part.value);
    builder_.emit(Opcode::copy, statement.span, raw_of(registers[i]), raw_of(value.operand));
  }
  builder_.emit(Opcode::output, statement.span, statement.payload, registers.empty() ? 0 : raw_of(registers.front()));
}

void StatementCompiler::compile_program_end(const ir::Statement& statement) {
  builder_.emit(Opcode::program_end, statement.span);
}

void StatementCompiler::compile_message(const ir::Statement& statement) {
  const ir::Message& message = builder_.source().messages[statement.payload];
  const Operand text =
      message.text == ir::ExpressionId::none ? Operand::none : expressions_.compile_string(message.text).operand;
  builder_.emit(Opcode::message, statement.span, raw_of(text));
}

void StatementCompiler::compile_alarm(const ir::Statement& statement) {
  const ir::Message& message = builder_.source().messages[statement.payload];
  const Operand number =
      message.number == ir::ExpressionId::none ? Operand::none : expressions_.compile_number(message.number).operand;
  const Operand text =
      message.text == ir::ExpressionId::none ? Operand::none : expressions_.compile_string(message.text).operand;
  builder_.emit(Opcode::alarm, statement.span, raw_of(number), raw_of(text));
}

void StatementCompiler::compile_native(const ir::Statement& statement) {
  const ir::Native& native = builder_.source().natives[statement.payload];
  const std::string_view name = builder_.source().strings.at(native.name);
  const ir::Function function = native.smooths ? ir::Function::continuous_path
                                : native.paces ? ir::Function::feed_per_min
                                               : ir::Function::not_modelled;
  builder_.emit(Opcode::report, statement.span, builder_.add_report(name, function, native.effects_known),
                (native.moves ? kReportMoves : 0U) | (native.shifts ? kReportShifts : 0U));
  if (name == "RET") builder_.emit(Opcode::back, statement.span);  // whatever else it does
}

}  // namespace dripfeed::interpreter
