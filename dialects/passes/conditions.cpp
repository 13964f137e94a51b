// IF with ELSE, or around more than one statement. Labels are chosen at the IF, where it is known whether ELSE follows.
#include <utility>
#include <vector>

#include "dialects/passes/rewrite.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/passes/structures.h"

namespace dripfeed::passes {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

class Conditions {
 public:
  Conditions(ir::Program& program, FreeNumbers& numbers) : program_(program), numbers_(numbers), out_(program) {}

  StructureReport run() {
    out_.visit_all([this](std::uint32_t i) { statement(i); });
    return std::move(report_);
  }

 private:
  struct Parts {
    std::uint32_t other = 0;  // label of the ELSE part, or of the end when there is none
    std::uint32_t end = 0;
  };

  void statement(std::uint32_t i) {
    const StatementKind kind = program_.statements[i].kind;
    if (kind == StatementKind::if_begin && !stays(i)) return begin(i);
    if (kind == StatementKind::else_begin && !open_.empty()) return middle();
    if (kind == StatementKind::if_end && is_lowered(i)) return end();
    out_.keep();
  }

  // One comparison before one assignment or alarm.
  [[nodiscard]] bool stays(std::uint32_t i) const {
    const ir::Structure head = structure_at(program_, i);
    if (head.partner == ir::kNoIndex) return true;  // the reader has reported
    if (head.partner != i + 2 || program_.statements[i + 2].kind != StatementKind::if_end) return false;
    const StatementKind inner = program_.statements[i + 1].kind;
    if (program_.statements[i + 1].is_label) return false;  // a jump into it
    return (inner == StatementKind::assign || inner == StatementKind::alarm) && is_comparison(program_, head.condition);
  }
  [[nodiscard]] bool is_lowered(std::uint32_t i) const {
    const std::uint32_t partner = structure_at(program_, i).partner;
    return partner != ir::kNoIndex && !stays(partner) && !open_.empty();
  }

  void begin(std::uint32_t i) {
    ++report_.changed;
    const ir::Structure head = structure_at(program_, i);
    const bool has_else = program_.statements[head.partner].kind == StatementKind::else_begin;
    Parts parts;
    parts.other = numbers_.next();
    parts.end = has_else ? numbers_.next() : parts.other;
    open_.push_back(parts);
    out_.emit_jump(jump_to(parts.other, negated(program_, head.condition)));
  }

  void middle() {
    out_.emit_jump(jump_to(open_.back().end));
    out_.label_next(open_.back().other);
  }

  void end() {
    out_.label_next(open_.back().end);
    open_.pop_back();
  }

  ir::Program& program_;
  FreeNumbers& numbers_;
  Rewrite out_;
  StructureReport report_;
  std::vector<Parts> open_;
};

}  // namespace

StructureReport lower_conditions(ir::Program& program, FreeNumbers& numbers) {
  return Conditions(program, numbers).run();
}

}  // namespace dripfeed::passes
