// AND, OR and NOT in conditions, as short-circuit jumps; and the opposite of a condition.
#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>
#include <utility>

#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/passes/structures.h"

namespace dripfeed::passes {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

struct Opposite {
  Operator op;
  Operator opposite;
};
constexpr auto kOpposites = std::to_array<Opposite>({
    {Operator::equal, Operator::not_equal},
    {Operator::not_equal, Operator::equal},
    {Operator::less, Operator::greater_equal},
    {Operator::greater_equal, Operator::less},
    {Operator::greater, Operator::less_equal},
    {Operator::less_equal, Operator::greater},
});

bool is_logic(Operator op) {
  return op == Operator::logic_and || op == Operator::logic_or || op == Operator::logic_xor ||
         op == Operator::logic_not;
}

void cannot(StructureReport& report, const ir::Statement& statement, passes::Refusal what) {
  report.diagnostics.push_back(passes::diagnose(std::move(what), statement.span, "this control"));
}

class Logic {
 public:
  Logic(ir::Program& program, FreeNumbers& numbers) : program_(program), numbers_(numbers), out_(program) {}

  StructureReport run() {
    out_.visit_all([this](std::uint32_t i) { statement(i); });
    return std::move(report_);
  }

 private:
  void statement(std::uint32_t i) {
    at_ = i;
    const ir::Statement& s = program_.statements[i];
    if (s.kind == StatementKind::go_to && program_.jumps[s.payload].condition != ExpressionId::none) {
      const ir::Jump jump = program_.jumps[s.payload];
      if (is_comparison(program_, jump.condition)) return out_.keep();
      ++report_.changed;
      return jump_if(jump.condition, jump);
    }
    if (s.kind == StatementKind::while_begin) return begin_while(i);
    if (s.kind == StatementKind::while_end) return end_while(i);
    out_.keep();
  }

  // Jumps when the condition holds, otherwise goes on with what is emitted next.
  void jump_if(ExpressionId condition, ir::Jump jump) {
    const ir::Expression e = program_.at(condition);
    if (e.op == Operator::logic_or) {
      jump_if(e.a, jump);
      return jump_if(e.b, jump);
    }
    if (e.op == Operator::logic_and) {
      const std::uint32_t after = numbers_.next();
      jump_if(negated(program_, e.a), jump_to(after));
      jump_if(e.b, jump);
      return out_.label_next(after);
    }
    if (e.op == Operator::logic_not) return jump_if(negated(program_, e.a), jump);
    if (e.op == Operator::logic_xor)
      cannot(report_, program_.statements[at_], passes::of_value("XOR between conditions"));
    if (e.op == Operator::constant) {
      jump.condition = ExpressionId::none;
      if (e.value != 0.0) out_.emit_jump(jump);
      return;
    }
    jump.condition = is_comparison(program_, condition) ? condition : unequal_zero(condition);
    out_.emit_jump(jump);
  }

  ExpressionId unequal_zero(ExpressionId value) {
    return program_.add_operator(Operator::not_equal, value, program_.add_constant(0.0));
  }

  void begin_while(std::uint32_t i) {
    const ir::Structure head = structure_at(program_, i);
    if (head.condition == ExpressionId::none || head.partner == ir::kNoIndex ||
        is_comparison(program_, head.condition)) {
      return out_.keep();
    }
    ++report_.changed;
    ir::Structure opened;
    opened.loop_number = head.loop_number;
    const ir::Expression e = program_.at(head.condition);
    if (!is_logic(e.op) && e.op != Operator::constant) {
      opened.condition = unequal_zero(head.condition);
      return out_.emit_structure(StatementKind::while_begin, opened);
    }
    const bool always = e.op == Operator::constant && e.value != 0.0;
    out_.emit_structure(StatementKind::loop_begin, opened);
    label_after_[i] = always ? 0 : numbers_.next();
    if (!always) jump_if(negated(program_, head.condition), jump_to(label_after_[i]));
  }

  void end_while(std::uint32_t i) {
    const ir::Structure tail = structure_at(program_, i);
    const auto after = label_after_.find(tail.partner);
    if (after == label_after_.end()) return out_.keep();
    ir::Structure closed;
    closed.loop_number = tail.loop_number;
    out_.emit_structure(StatementKind::loop_end, closed);
    if (after->second != 0) out_.label_next(after->second);
  }

  ir::Program& program_;
  FreeNumbers& numbers_;
  Rewrite out_;
  StructureReport report_;
  std::uint32_t at_ = 0;
  std::unordered_map<std::uint32_t, std::uint32_t> label_after_;  // opener -> label after its end; 0: none needed
};

}  // namespace

ir::Operator opposite_comparison(ir::Operator op) {
  const auto row = std::ranges::find(kOpposites, op, &Opposite::op);
  return row == kOpposites.end() ? Operator::constant : row->opposite;
}

StructureReport lower_logic(ir::Program& program, FreeNumbers& numbers) { return Logic(program, numbers).run(); }

ExpressionId negated(ir::Program& program, ExpressionId condition) {
  const ir::Expression e = program.at(condition);
  if (const Operator opposite = opposite_comparison(e.op); opposite != Operator::constant) {
    return program.add_operator(opposite, e.a, e.b, e.span);
  }
  if (e.op == Operator::logic_not) return e.a;
  if (e.op == Operator::logic_and || e.op == Operator::logic_or) {
    const ExpressionId a = negated(program, e.a);
    const ExpressionId b = negated(program, e.b);
    return program.add_operator(e.op == Operator::logic_and ? Operator::logic_or : Operator::logic_and, a, b, e.span);
  }
  if (e.op == Operator::constant) return program.add_constant(e.value == 0.0 ? 1.0 : 0.0, e.span);
  return program.add_operator(Operator::equal, condition, program.add_constant(0.0), e.span);
}

}  // namespace dripfeed::passes
