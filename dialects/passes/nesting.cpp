// Depth of loops. A loop that is too high above its innermost one becomes a label and a jump back.
#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "dialects/passes/rewrite.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/passes/structures.h"

namespace dripfeed::passes {

namespace {

using ir::ExpressionId;
using ir::StatementKind;

class Nesting {
 public:
  Nesting(ir::Program& program, FreeNumbers& numbers, std::uint32_t limit)
      : program_(program), numbers_(numbers), limit_(limit), out_(program) {}

  StructureReport run() {
    measure();
    out_.visit_all([this](std::uint32_t i) { statement(i); });
    return std::move(report_);
  }

 private:
  struct Ends {
    std::uint32_t begin = 0;
    std::uint32_t after = 0;
  };

  static bool opens(StatementKind kind) {
    return kind == StatementKind::while_begin || kind == StatementKind::loop_begin;
  }
  static bool closes(StatementKind kind) { return kind == StatementKind::while_end || kind == StatementKind::loop_end; }

  // How many loops lie inside one another from each loop inward.
  void measure() {
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const StatementKind kind = program_.statements[i].kind;
      if (opens(kind) && structure_at(program_, i).partner != ir::kNoIndex) {
        open.push_back(i);
        height_[i] = 1;
      } else if (closes(kind) && structure_at(program_, i).partner != ir::kNoIndex) {
        const std::uint32_t inner = height_[open.back()];
        open.pop_back();
        if (!open.empty()) height_[open.back()] = std::max(height_[open.back()], inner + 1);
      }
    }
  }

  void statement(std::uint32_t i) {
    const StatementKind kind = program_.statements[i].kind;
    if (opens(kind) && height_.contains(i)) return height_[i] > limit_ ? begin_jumps(i) : number(i, ++depth_);
    if (closes(kind)) {
      const std::uint32_t begin = structure_at(program_, i).partner;
      if (begin != ir::kNoIndex) return height_[begin] > limit_ ? end_jumps() : number(i, depth_--);
    }
    out_.keep();
  }

  void number(std::uint32_t i, std::uint32_t depth) {
    program_.structures[program_.statements[i].payload].loop_number = static_cast<std::uint8_t>(depth);
    out_.keep();
  }

  void begin_jumps(std::uint32_t i) {
    ++report_.changed;
    const Ends ends = {numbers_.next(), numbers_.next()};
    open_.push_back(ends);
    out_.label_next(ends.begin);
    const ExpressionId condition = structure_at(program_, i).condition;
    if (condition != ExpressionId::none) out_.emit_jump(jump_to(ends.after, negated(program_, condition)));
  }

  void end_jumps() {
    out_.emit_jump(jump_to(open_.back().begin));
    out_.label_next(open_.back().after);
    open_.pop_back();
  }

  ir::Program& program_;
  FreeNumbers& numbers_;
  std::uint32_t limit_;
  Rewrite out_;
  StructureReport report_;
  std::uint32_t depth_ = 0;
  std::vector<Ends> open_;
  std::unordered_map<std::uint32_t, std::uint32_t> height_;
};

}  // namespace

StructureReport limit_loop_nesting(ir::Program& program, FreeNumbers& numbers, std::uint32_t limit) {
  return Nesting(program, numbers, limit == 0 ? ir::kNoIndex : limit).run();
}

}  // namespace dripfeed::passes
