// FOR and REPEAT. The counter is renamed at each use, because passes change variables in place.
#include <utility>

#include "dialects/passes/rewrite.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/passes/structures.h"

namespace dripfeed::passes {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

ExpressionId copy_variable(ir::Program& program, ir::VariableId id) {
  return program.add_variable(ir::Variable(program.at(id)));
}

class CountedLoops {
 public:
  CountedLoops(ir::Program& program, FreeNumbers& numbers) : program_(program), numbers_(numbers), out_(program) {}

  StructureReport run() {
    out_.visit_all([this](std::uint32_t i) { statement(i); });
    return std::move(report_);
  }

 private:
  void statement(std::uint32_t i) {
    const StatementKind kind = program_.statements[i].kind;
    if (kind == StatementKind::for_begin) return begin_for(i);
    if (kind == StatementKind::for_end) return end_for(i);
    if (kind == StatementKind::repeat_begin) return begin_repeat();
    if (kind == StatementKind::repeat_end) return end_repeat(i);
    out_.keep();
  }

  void begin_for(std::uint32_t i) {
    ++report_.changed;
    const ir::Structure loop = structure_at(program_, i);
    out_.emit_assign(program_.add(ir::Variable(program_.at(loop.counter))), loop.first);
    ir::Structure opened;
    opened.condition = program_.add_operator(Operator::less_equal, copy_variable(program_, loop.counter), loop.last);
    out_.emit_structure(StatementKind::while_begin, opened);
  }

  void end_for(std::uint32_t i) {
    const std::uint32_t begin = structure_at(program_, i).partner;
    if (begin == ir::kNoIndex) return out_.keep();
    const ir::VariableId counter = structure_at(program_, begin).counter;
    const ExpressionId next =
        program_.add_operator(Operator::add, copy_variable(program_, counter), program_.add_constant(1.0));
    out_.emit_assign(program_.add(ir::Variable(program_.at(counter))), next);
    out_.emit_structure(StatementKind::while_end, {});
  }

  void begin_repeat() {
    ++report_.changed;
    out_.emit_structure(StatementKind::loop_begin, {});
  }

  void end_repeat(std::uint32_t i) {
    const std::uint32_t after = numbers_.next();
    out_.emit_jump(jump_to(after, structure_at(program_, i).condition));
    out_.emit_structure(StatementKind::loop_end, {});
    out_.label_next(after);
  }

  ir::Program& program_;
  FreeNumbers& numbers_;
  Rewrite out_;
  StructureReport report_;
};

}  // namespace

StructureReport lower_counted_loops(ir::Program& program, FreeNumbers& numbers) {
  return CountedLoops(program, numbers).run();
}

}  // namespace dripfeed::passes
