// Small programs built by hand, and what running them leaves in their variables.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/ir.h"

namespace dripfeed::passes {

class Building {
 public:
  ir::Program program;

  ir::SymbolId symbol(const std::string& name, ir::ValueType type = ir::ValueType::real, std::uint16_t dimension = 0) {
    ir::Symbol s;
    s.name = program.strings.add(name);
    s.type = type;
    s.dimension1 = dimension;
    return program.add(s);
  }
  static ir::Variable named(ir::SymbolId id, ir::ExpressionId index = ir::ExpressionId::none) {
    ir::Variable v;
    v.bank = ir::Bank::named;
    v.symbol = id;
    v.index = index;
    return v;
  }
  static ir::Variable numbered(ir::Bank bank, std::uint32_t number) {
    ir::Variable v;
    v.bank = bank;
    v.number = number;
    return v;
  }
  ir::ExpressionId value(double v) { return program.add_constant(v); }
  ir::ExpressionId value(const ir::Variable& v) { return program.add_variable(v); }
  ir::ExpressionId op(ir::Operator o, ir::ExpressionId a, ir::ExpressionId b = ir::ExpressionId::none) {
    return program.add_operator(o, a, b);
  }

  void statement(ir::StatementKind kind, std::size_t payload) {
    ir::Statement s;
    s.kind = kind;
    s.payload = static_cast<std::uint32_t>(payload);
    s.line = static_cast<std::uint32_t>(program.statements.size() + 1);
    program.statements.push_back(s);
  }
  void assign(const ir::Variable& target, ir::ExpressionId v) {
    program.assigns.push_back({program.add(target), v});
    statement(ir::StatementKind::assign, program.assigns.size() - 1);
  }
  void structure(ir::StatementKind kind, const ir::Structure& s = {}) {
    program.structures.push_back(s);
    statement(kind, program.structures.size() - 1);
  }
  void condition(ir::StatementKind kind, ir::ExpressionId c) {
    ir::Structure s;
    s.condition = c;
    structure(kind, s);
  }
  void jump(const ir::Jump& j) {
    program.jumps.push_back(j);
    statement(ir::StatementKind::go_to, program.jumps.size() - 1);
  }
  ir::Jump to_name(const std::string& name, ir::JumpSearch search = ir::JumpSearch::both) {
    ir::Jump j;
    j.label = program.strings.add(name);
    j.search = search;
    return j;
  }
  // At the next statement.
  void label(const std::string& name) {
    program.labels.push_back(
        {program.strings.add(name), ir::kNoIndex, static_cast<std::uint32_t>(program.statements.size()), {}});
  }
  void label(std::uint32_t number) {
    program.labels.push_back({ir::StringId::none, number, static_cast<std::uint32_t>(program.statements.size()), {}});
  }
  void end() {
    ir::Code code;
    code.function = ir::Function::program_end_rewind;
    program.codes.push_back(code);
    ir::Block block;
    block.first_code = static_cast<std::uint32_t>(program.codes.size() - 1);
    block.code_count = 1;
    program.blocks.push_back(block);
    statement(ir::StatementKind::program_end, program.blocks.size() - 1);
    ir::match_structures(program);
  }
};

// A control with #100-#(100+count-1), #1-#3 and R0-R9.
inline ir::Control control_with(std::uint32_t count) {
  ir::Control c;
  c.title = "test";
  c.semantics.has_vacant = false;
  c.variables = {{ir::Bank::hash, 1, 3, ir::VariableUse::local, true},
                 {ir::Bank::hash, 100, 100 + count - 1, ir::VariableUse::common, true},
                 {ir::Bank::r, 0, 9, ir::VariableUse::common, true}};
  return c;
}

// Values by name after the run; "ended" holds how it ended.
inline std::map<std::string, double> run(const ir::Program& program, const ir::Control& control) {
  class NoMotions final : public ir::MotionSink {
   public:
    void consume(std::span<const ir::Motion>) override {}
  } sink;
  interpreter::RunOptions options;
  options.want_variables = true;
  options.limits.blocks = 100'000;
  const interpreter::RunResult result = interpreter::run(program, control, interpreter::no_programs(), sink, options);
  std::map<std::string, double> values;
  for (const interpreter::VariableValue& v : result.variables) {
    if (v.value) values[v.name] = *v.value;
  }
  values["ended"] = static_cast<double>(result.ended);
  return values;
}

}  // namespace dripfeed::passes
