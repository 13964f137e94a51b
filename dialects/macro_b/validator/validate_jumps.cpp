// Jumps and what they reach. Loops are known by their innermost one at each statement, so that a jump into a loop is
// found by walking outward from its target.
#include <algorithm>
#include <string>
#include <unordered_set>

#include <fmt/format.h>

#include "dialects/macro_b/reader/lower.h"
#include "dialects/macro_b/validator/validate.h"

namespace dripfeed::macro_b {

namespace {

using ir::StatementKind;
using enum text::DiagnosticId;

class JumpCheck {
 public:
  JumpCheck(const ir::Program& program, const Section& section, Findings& findings)
      : program_(program),
        section_(section),
        findings_(findings),
        labels_(program, section),
        entries_(program, section) {}

  void run() {
    find_loops();
    for (std::uint32_t i = section_.first; i < section_.last; ++i) {
      if (program_.statements[i].kind == StatementKind::go_to) check_jump(i);
    }
    check_reached();
  }

 private:
  struct Loop {
    std::uint32_t begin;
    std::uint32_t outer;  // index of the loop around it, kNoIndex for none
  };

  void find_loops() {
    inside_.assign(section_.last - section_.first, ir::kNoIndex);
    std::uint32_t innermost = ir::kNoIndex;
    for (std::uint32_t i = section_.first; i < section_.last; ++i) {
      const StatementKind kind = program_.statements[i].kind;
      // The opener itself may be jumped to; the closer belongs to the inside.
      inside_[i - section_.first] = innermost;
      if (kind == StatementKind::while_begin || kind == StatementKind::loop_begin) {
        loops_.push_back({i, innermost});
        innermost = static_cast<std::uint32_t>(loops_.size() - 1);
      } else if ((kind == StatementKind::while_end || kind == StatementKind::loop_end) && innermost != ir::kNoIndex) {
        innermost = loops_[innermost].outer;
      }
    }
  }

  [[nodiscard]] bool encloses(std::uint32_t loop, std::uint32_t statement) const {
    for (std::uint32_t l = inside_[statement - section_.first]; l != ir::kNoIndex; l = loops_[l].outer) {
      if (l == loop) return true;
    }
    return false;
  }

  void check_jump(std::uint32_t i) {
    const ir::Statement& statement = program_.statements[i];
    const ir::Jump& jump = program_.jumps[statement.payload];
    if (jump.number == ir::kNoIndex) return;
    const std::string name = fmt::format("N{}", jump.number);
    const ir::Label* label = labels_.find(jump.number, i);
    if (label == nullptr) {
      findings_.add(jump_target_missing, statement.span, {name});
      return;
    }
    const std::uint32_t target_loop = inside_[label->statement - section_.first];
    if (target_loop != ir::kNoIndex && !encloses(target_loop, i)) {
      text::Diagnostic* finding = findings_.add(jump_into_loop, statement.span, {name});
      if (finding != nullptr) {
        finding->notes.push_back({program_.statements[loops_[target_loop].begin].span, "the loop begins here"});
      }
    }
    if (const ir::Label* other = labels_.other(*label); other != nullptr && reported_.insert(jump.number).second) {
      text::Diagnostic* finding = findings_.add(label_defined_twice, other->span, {name});
      if (finding != nullptr) finding->notes.push_back({statement.span, "the jump to it"});
    }
  }

  void check_reached() {
    bool reached = true;
    std::uint32_t conditional_line = 0;
    for (std::uint32_t i = section_.first; i < section_.last; ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind == StatementKind::if_begin) conditional_line = s.line;
      const bool closes = s.kind == StatementKind::if_end || s.kind == StatementKind::while_end ||
                          s.kind == StatementKind::loop_end || s.kind == StatementKind::else_begin;
      reached = reached || closes || entries_.at(i);
      if (!reached && s.kind != StatementKind::empty && !is_folder_line(program_, s)) {
        findings_.add(unreachable, s.span);
        reached = true;
      }
      const bool always = s.skip_level == 0 && s.line != conditional_line;
      const bool jumps =
          s.kind == StatementKind::go_to && program_.jumps[s.payload].condition == ir::ExpressionId::none;
      if (always && (jumps || is_end_of_program(s.kind) || s.kind == StatementKind::alarm)) reached = false;
    }
  }

  const ir::Program& program_;
  const Section& section_;
  Findings& findings_;
  LabelIndex labels_;
  Entries entries_;
  std::vector<Loop> loops_;
  std::vector<std::uint32_t> inside_;  // by statement of the section: index of its innermost loop
  std::unordered_set<std::uint32_t> reported_;
};

}  // namespace

void check_jumps(const ir::Program& program, const Section& section, Findings& findings) {
  JumpCheck(program, section, findings).run();
}

}  // namespace dripfeed::macro_b
