// Expressions are changed where they are: each stands in one place of the program.
#include "dialects/macro_b/writer/raise_passed.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "dialects/passes/walk.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

class Passed {
 public:
  Passed(ir::Program& program, const ir::Control& from) : program_(program), from_(from) {}

  void run() {
    std::vector<ExpressionId> nodes;
    std::vector<ExpressionId> conditions;
    for (const ir::Statement& s : program_.statements) {
      const auto root = [&](ExpressionId id) {
        passes::for_each_node(program_, id, [&](ExpressionId node) { nodes.push_back(node); });
      };
      passes::for_each_root(program_, s, root, [&](ir::VariableId target) { root(program_.at(target).index); });
      if (s.kind == StatementKind::go_to) conditions.push_back(program_.jumps[s.payload].condition);
      if (ir::is_structure(s.kind) && s.payload != ir::kNoIndex)
        conditions.push_back(program_.structures[s.payload].condition);
    }
    // Conditions and comparisons first, while the variables in them are still there.
    for (const ExpressionId id : conditions) truth(id);
    for (const ExpressionId id : nodes) comparison(id);
    for (const ExpressionId id : nodes) value(id);
  }

 private:
  // The number of the local variable.
  [[nodiscard]] std::optional<std::uint32_t> local_of(ExpressionId id, ir::SystemValue kind) const {
    const ir::Expression& e = program_.at(id);
    if (e.op != Operator::variable) return std::nullopt;
    const ir::Variable& v = program_.at(e.variable);
    if (v.bank != ir::Bank::system || v.number >= from_.system_variables.size()) return std::nullopt;
    const ir::SystemVariableRow& row = from_.system_variables[v.number];
    const bool first = v.index == ExpressionId::none || is_number(v.index, 0.0);
    return row.kind == kind && first ? std::optional(row.first) : std::nullopt;
  }
  [[nodiscard]] bool is_number(ExpressionId id, double value) const {
    const ir::Expression& e = program_.at(id);
    return e.op == Operator::constant && e.value == value;
  }

  // IF $C_X_PROG, IF NOT $C_X_PROG AND …
  void truth(ExpressionId id) {
    if (id == ExpressionId::none) return;
    const ir::Expression e = program_.at(id);
    if (const auto local = local_of(id, ir::SystemValue::call_argument_given)) return compare(id, *local, false);
    if (e.op != Operator::logic_and && e.op != Operator::logic_or && e.op != Operator::logic_not) return;
    truth(e.a);
    truth(e.b);
  }

  void comparison(ExpressionId id) {
    const ir::Expression e = program_.at(id);
    if (e.op != Operator::equal && e.op != Operator::not_equal) return;
    for (const auto& [variable, other] : {std::pair(e.a, e.b), std::pair(e.b, e.a)}) {
      const auto local = local_of(variable, ir::SystemValue::call_argument_given);
      if (!local || (!is_number(other, 0.0) && !is_number(other, 1.0))) continue;
      return compare(id, *local, is_number(other, 0.0) == (e.op == Operator::equal));
    }
  }

  void compare(ExpressionId id, std::uint32_t local, bool vacant) {
    ir::Expression nothing;
    nothing.op = Operator::vacant;
    const ExpressionId a = local_variable(local, program_.at(id).span);
    const ExpressionId b = program_.add(nothing);
    ir::Expression& e = program_.expressions[static_cast<std::uint32_t>(id)];
    e = {.op = vacant ? Operator::equal : Operator::not_equal, .a = a, .b = b, .span = e.span};
  }

  void value(ExpressionId id) {
    const auto local = local_of(id, ir::SystemValue::call_argument);
    if (!local) return;
    const ExpressionId a = local_variable(*local, program_.at(id).span);
    const ExpressionId b = program_.add_constant(0.0, {}, false);
    ir::Expression& e = program_.expressions[static_cast<std::uint32_t>(id)];
    e = {.op = Operator::add, .a = a, .b = b, .span = e.span};
  }

  ExpressionId local_variable(std::uint32_t number, text::Span span) {
    ir::Variable v;
    v.bank = ir::Bank::hash;
    v.number = number;
    v.span = span;
    return program_.add_variable(v);
  }

  ir::Program& program_;
  const ir::Control& from_;
};

}  // namespace

void raise_passed(ir::Program& program, const ir::Control& from) {
  const bool is_called = std::ranges::any_of(program.statements, [](const ir::Statement& s) {
    return s.kind == StatementKind::procedure || s.kind == StatementKind::subprogram_return ||
           s.kind == StatementKind::return_to;
  });
  if (is_called) Passed(program, from).run();
}

}  // namespace dripfeed::macro_b
