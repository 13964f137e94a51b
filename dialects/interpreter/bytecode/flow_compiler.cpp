// Structures and jumps.
//
//   WHILE c          IF c              FOR v = a TO b        REPEAT
//     not c: -> (1)    not c: -> else    v = a; v > b: -> (1)   …
//     …                … ; -> (1)        …                   UNTIL c
//   END: -> WHILE    ELSE …            ENDFOR: v = v + 1        not c: -> REPEAT
//   (1)              ENDIF (1)           v <= b: -> body     (1)
#include "dialects/interpreter/bytecode/flow_compiler.h"

#include <algorithm>

#include "dialects/interpreter/bytecode/jump_target.h"

namespace dripfeed::interpreter {

namespace {

using ir::Operator;
using ir::StatementKind;
using text::DiagnosticId;

constexpr bool is_opener(StatementKind kind) {
  return kind == StatementKind::if_begin || kind == StatementKind::while_begin || kind == StatementKind::repeat_begin ||
         kind == StatementKind::for_begin || kind == StatementKind::loop_begin || kind == StatementKind::else_begin;
}

}  // namespace

constexpr FlowCompiler::Row FlowCompiler::kRows[] = {
    {StatementKind::go_to, &FlowCompiler::compile_jump, StatementKind::go_to, "GOTO"},
    {StatementKind::if_begin, &FlowCompiler::compile_if, StatementKind::if_end, "IF"},
    {StatementKind::else_begin, &FlowCompiler::compile_else, StatementKind::if_end, "ELSE"},
    {StatementKind::if_end, &FlowCompiler::compile_nothing, StatementKind::if_begin, "the end of IF"},
    {StatementKind::while_begin, &FlowCompiler::compile_while, StatementKind::while_end, "WHILE"},
    {StatementKind::while_end, &FlowCompiler::compile_while_end, StatementKind::while_begin, "the end of WHILE"},
    {StatementKind::repeat_begin, &FlowCompiler::compile_nothing, StatementKind::repeat_end, "REPEAT"},
    {StatementKind::repeat_end, &FlowCompiler::compile_repeat_end, StatementKind::repeat_begin, "UNTIL"},
    {StatementKind::for_begin, &FlowCompiler::compile_for, StatementKind::for_end, "FOR"},
    {StatementKind::for_end, &FlowCompiler::compile_for_end, StatementKind::for_begin, "the end of FOR"},
    {StatementKind::loop_begin, &FlowCompiler::compile_nothing, StatementKind::loop_end, "the loop"},
    {StatementKind::loop_end, &FlowCompiler::compile_loop_end, StatementKind::loop_begin, "the end of the loop"},
};

const FlowCompiler::Row* FlowCompiler::find_row(StatementKind kind) {
  const auto row = std::ranges::find(kRows, kind, &Row::kind);
  return row == std::end(kRows) ? nullptr : &*row;
}

const ir::Statement& FlowCompiler::statement(std::uint32_t index) const { return builder_.source().statements[index]; }
const ir::Structure& FlowCompiler::structure(std::uint32_t index) const {
  return builder_.source().structures[statement(index).payload];
}

bool FlowCompiler::compile(std::uint32_t index) {
  const Row* row = find_row(statement(index).kind);
  if (row == nullptr) return false;
  if (row->partner != row->kind && structure(index).partner == ir::kNoIndex) {
    const bool opens = is_opener(row->kind);
    const std::string partner = opens ? "end" : std::string(find_row(row->partner)->name);
    builder_.emit_failure(statement(index).span, opens ? DiagnosticId::missing_end : DiagnosticId::end_without_begin,
                          {std::string(row->name), partner});
  } else {
    (this->*row->compile)(index);
  }
  return true;
}

void FlowCompiler::branch_unless(ir::ExpressionId condition, text::Span span, std::uint32_t to, Edge edge) {
  if (condition == ir::ExpressionId::none) return;
  const Value value = expressions_.compile_number(condition);
  branches_.push_back({builder_.emit(Opcode::branch_false, span, raw_of(value.operand)), to, edge});
}

void FlowCompiler::jump_to(Opcode op, text::Span span, std::uint32_t to, Edge edge) {
  branches_.push_back({builder_.emit(op, span), to, edge});
}

void FlowCompiler::compile_nothing(std::uint32_t) {}

void FlowCompiler::compile_if(std::uint32_t index) {
  const std::uint32_t partner = structure(index).partner;
  const Edge edge = statement(partner).kind == StatementKind::else_begin ? Edge::after : Edge::begin;
  branch_unless(structure(index).condition, statement(index).span, partner, edge);
}

void FlowCompiler::compile_else(std::uint32_t index) {
  jump_to(Opcode::jump, statement(index).span, structure(index).partner, Edge::begin);
}

void FlowCompiler::compile_while(std::uint32_t index) {
  branch_unless(structure(index).condition, statement(index).span, structure(index).partner, Edge::after);
}

void FlowCompiler::compile_while_end(std::uint32_t index) {
  jump_to(Opcode::jump_back, statement(index).span, structure(index).partner, Edge::begin);
}

void FlowCompiler::compile_loop_end(std::uint32_t index) {
  jump_to(Opcode::jump_back, statement(index).span, structure(index).partner, Edge::after);
}

void FlowCompiler::compile_repeat_end(std::uint32_t index) {
  const ir::Structure& end = structure(index);
  const ir::ExpressionId until =
      end.condition != ir::ExpressionId::none ? end.condition : structure(end.partner).condition;
  const text::Span span = statement(index).span;
  if (until != ir::ExpressionId::none) {
    const Value done = expressions_.compile_number(until);
    // Whether it is done may not be known: then it is.
    const std::uint32_t test = builder_.emit(Opcode::branch_false, span, raw_of(done.operand), 0, 0, 1);
    jump_to(Opcode::jump, span, index, Edge::after);
    builder_.at(test).b = builder_.here();
  }
  jump_to(Opcode::jump_back, span, end.partner, Edge::after);
  builder_.at(builder_.here() - 1).c = 1;
}

// counter <= last, with the last value as it is at this pass. The control has the counter at hand then: no reading.
Operand FlowCompiler::compile_for_test(const ir::Structure& loop, text::Span span) {
  const Work before = builder_.work;
  const Value counter = expressions_.variables().load(builder_.source().at(loop.counter), Operand::none);
  builder_.work = before;
  ++builder_.work.operators;
  const Value last = expressions_.compile_number(loop.last);
  return expressions_.combine(Operator::less_equal, counter, last, span).operand;
}

void FlowCompiler::compile_for(std::uint32_t index) {
  const ir::Structure& loop = structure(index);
  const text::Span span = statement(index).span;
  if (loop.counter == ir::VariableId::none) {
    builder_.emit_failure(span, DiagnosticId::missing_operand, {"FOR"});
    return;
  }
  expressions_.variables().assign(builder_.source().at(loop.counter), loop.first, span);
  const Operand goes_on = compile_for_test(loop, span);
  branches_.push_back({builder_.emit(Opcode::branch_false, span, raw_of(goes_on)), loop.partner, Edge::after});
}

void FlowCompiler::compile_for_end(std::uint32_t index) {
  const std::uint32_t opener = structure(index).partner;
  const ir::Structure& loop = structure(opener);
  if (loop.counter == ir::VariableId::none) return;  // its FOR is an alarm
  const text::Span span = statement(index).span;
  const ir::Variable& counter = builder_.source().at(loop.counter);
  const Value one{builder_.constant(1.0), ir::ValueType::integer, 1.0};
  const Value value = expressions_.variables().load(counter, Operand::none);
  expressions_.variables().count_write(counter);
  expressions_.variables().store(counter, expressions_.combine(Operator::add, value, one, span), span);
  const Operand goes_on = compile_for_test(loop, span);
  branches_.push_back({builder_.emit(Opcode::branch_false, span, raw_of(goes_on)), index, Edge::after});
  jump_to(Opcode::jump_back, span, opener, Edge::after);
}

// --- jumps
// ------------------------------------------------------------------------------------------------------------

void FlowCompiler::compile_jump(std::uint32_t index) {
  const ir::Jump& jump = builder_.source().jumps[statement(index).payload];
  const text::Span span = statement(index).span;
  std::uint32_t test = ir::kNoIndex;
  if (jump.condition != ir::ExpressionId::none) {
    const Value condition = expressions_.compile_number(jump.condition);
    test = builder_.emit(Opcode::branch_false, span, raw_of(condition.operand));
  }
  if (jump.restart) {
    jump_to(Opcode::jump_back, span, 0, Edge::begin);
    builder_.at(builder_.here() - 1).c = 1;
  } else if (jump.computed != ir::ExpressionId::none) {
    const Value target = expressions_.compile(jump.computed);
    builder_.emit(target.is_string() ? Opcode::jump_text : Opcode::jump_number, span, raw_of(target.operand), 0,
                  jump.tolerant ? 1 : 0, static_cast<std::uint8_t>(jump.search));
  } else {
    jumps_.push_back({builder_.emit(Opcode::jump, span, 0, 0, 1), &jump});
  }
  if (test != ir::kNoIndex) builder_.at(test).b = builder_.here();
}

void FlowCompiler::compile_section_begin(std::uint32_t first, Operand times, std::uint32_t section, text::Span span) {
  jump_to(Opcode::repeat_section, span, first, Edge::begin);
  Instruction& made = builder_.at(builder_.here() - 1);
  made.b = raw_of(times);
  made.c = section;
}

void FlowCompiler::compile_section_end(std::uint32_t repeat, std::uint32_t section) {
  jump_to(Opcode::section_end, statement(repeat).span, repeat, Edge::begin);
  builder_.at(builder_.here() - 1).c = section;
}

void FlowCompiler::compile_return_jump(const ir::Jump& jump, text::Span span) {
  const std::uint32_t further = jump.levels - 1U;
  if (jump.computed == ir::ExpressionId::none) {
    if (jump.number == ir::kNoIndex)
      builder_.emit(Opcode::back, span, further);
    else
      builder_.emit(Opcode::back_to, span, raw_of(builder_.constant(jump.number)), further);
    return;
  }
  const Value to = expressions_.compile(jump.computed);
  builder_.emit(Opcode::back_to, span, raw_of(to.operand), further, 0,
                to.is_string() ? std::uint8_t{1} : std::uint8_t{0});
}

void FlowCompiler::resolve(std::span<const StatementCode> code, std::uint32_t first) {
  CompiledProgram& out = builder_.out();
  const auto& labels = builder_.source().labels;
  const auto all = static_cast<std::uint32_t>(builder_.source().statements.size());
  const std::uint32_t last = first + static_cast<std::uint32_t>(code.size());
  const auto take = [&](const ir::Label& label, std::uint32_t at) {
    if (label.name == ir::StringId::none)
      out.numbers[label.number].push_back(at);
    else
      out.labels[std::string(builder_.source().strings.at(label.name))].push_back(at);
  };
  // A text may have thousands of foreign parts; its labels stand in order, as they were read.
  auto label = out.is_foreign ? std::ranges::lower_bound(labels, first, {}, &ir::Label::statement) : labels.begin();
  for (; label != labels.end() && !(out.is_foreign && label->statement >= last); ++label) {
    if (first <= label->statement && label->statement < last) take(*label, code[label->statement - first].begin);
    if (label->statement >= all) take(*label, builder_.here());  // after the last one
  }
  for (auto& entry : out.numbers) std::ranges::sort(entry.second);
  for (auto& entry : out.labels) std::ranges::sort(entry.second);
  for (const Branch& branch : branches_) resolve_branch(branch, code, first);
  for (const LabelJump& jump : jumps_) resolve_jump(jump);
}

void FlowCompiler::resolve_branch(const Branch& branch, std::span<const StatementCode> code, std::uint32_t first) {
  Instruction& instruction = builder_.at(branch.instruction);
  const bool is_here = branch.statement >= first && branch.statement - first < code.size();
  const StatementCode range = is_here ? code[branch.statement - first] : StatementCode{};
  const std::uint32_t to = branch.edge == Edge::begin ? range.begin : range.end;
  (instruction.op == Opcode::branch_false ? instruction.b : instruction.a) = to;
}

const std::vector<std::uint32_t>* FlowCompiler::targets_of(const ir::Jump& jump) const {
  const CompiledProgram& out = builder_.out();
  if (jump.label == ir::StringId::none) {
    const auto found = out.numbers.find(jump.number);
    return found == out.numbers.end() ? nullptr : &found->second;
  }
  const auto found = out.labels.find(std::string(builder_.source().strings.at(jump.label)));
  return found == out.labels.end() ? nullptr : &found->second;
}

void FlowCompiler::resolve_jump(const LabelJump& pending) {
  const ir::Jump& jump = *pending.jump;
  Instruction& instruction = builder_.at(pending.instruction);
  const std::uint32_t to = find_target(targets_of(jump), pending.instruction, jump.search);
  if (to != kNoTarget) {
    instruction.op = to <= pending.instruction ? Opcode::jump_back : Opcode::jump;
    instruction.a = to;
  } else if (jump.tolerant) {
    instruction.a = pending.instruction + 1;
    instruction.c = 0;
  } else {
    const std::string name = jump.label == ir::StringId::none ? "N" + std::to_string(jump.number)
                                                              : std::string(builder_.source().strings.at(jump.label));
    instruction.op = Opcode::fail;
    instruction.a = builder_.add_failure(DiagnosticId::jump_target_missing, {name});
  }
}

}  // namespace dripfeed::interpreter
