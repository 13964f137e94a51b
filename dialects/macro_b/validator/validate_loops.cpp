// Loops as the control pairs them: END m closes the DO of that number that is open.
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "dialects/macro_b/validator/validate.h"

namespace dripfeed::macro_b {

namespace {

using ir::StatementKind;
using enum text::DiagnosticId;

bool opens(StatementKind kind) { return kind == StatementKind::while_begin || kind == StatementKind::loop_begin; }
bool closes(StatementKind kind) { return kind == StatementKind::while_end || kind == StatementKind::loop_end; }

class LoopCheck {
 public:
  LoopCheck(const ir::Program& program, const ir::Control& control, const Section& section, Findings& findings)
      : program_(program), control_(control), section_(section), findings_(findings), labels_(program, section) {}

  void run() {
    for (std::uint32_t i = section_.first; i < section_.last; ++i) {
      const ir::Statement& statement = program_.statements[i];
      if (opens(statement.kind)) open(i);
      if (closes(statement.kind)) close(i);
      block_condition(i);
    }
    for (const std::uint32_t i : open_) missing_end_of(i, "END");
    for (const std::uint32_t i : conditions_) missing_end_of(i, "ENDIF");
  }

 private:
  [[nodiscard]] const ir::Structure& structure(std::uint32_t i) const {
    return program_.structures[program_.statements[i].payload];
  }
  [[nodiscard]] std::string name_of(std::uint32_t i, std::string_view word) const {
    return fmt::format("{}{}", word, structure(i).loop_number);
  }
  void missing_end_of(std::uint32_t i, std::string_view end) {
    const bool loop = opens(program_.statements[i].kind);
    findings_.add(missing_end, program_.statements[i].span,
                  {loop ? name_of(i, "DO") : "IF", loop ? name_of(i, end) : std::string(end)});
  }

  void open(std::uint32_t i) {
    const std::uint8_t number = structure(i).loop_number;
    const bool reused = std::ranges::any_of(open_, [&](std::uint32_t o) { return structure(o).loop_number == number; });
    if (reused) {
      findings_.add(loop_number_invalid, program_.statements[i].span,
                    {fmt::format("{0} inside {0}", name_of(i, "DO"))});
    }
    open_.push_back(i);
    const auto most = control_.limits.loop_nesting;
    if (most != 0 && open_.size() == most + 1) {
      findings_.add(nesting_too_deep, program_.statements[i].span,
                    {std::to_string(open_.size()), std::to_string(most)});
    }
  }

  void close(std::uint32_t i) {
    const std::uint8_t number = structure(i).loop_number;
    const auto partner = std::ranges::find_if(open_.rbegin(), open_.rend(),
                                              [&](std::uint32_t o) { return structure(o).loop_number == number; });
    const text::Span span = program_.statements[i].span;
    if (partner == open_.rend()) {
      findings_.add(end_without_begin, span, {name_of(i, "END"), name_of(i, "DO")});
      return;
    }
    if (partner != open_.rbegin()) {
      findings_.add(wrong_nesting, span, {name_of(i, "END"), name_of(open_.back(), "DO")});
    } else if (open_.size() <= kDeepestLoopLookedAt) {
      check_exit(*partner, i);
    }
    open_.erase(std::next(partner).base());
  }

  // A loop without condition, or whose condition cannot change inside it, needs a jump, a return or a stop.
  void check_exit(std::uint32_t begin, std::uint32_t end) {
    const ir::ExpressionId condition = structure(begin).condition;
    if (changes_by_itself(condition)) return;
    for (std::uint32_t i = begin + 1; i < end; ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind == StatementKind::go_to && leaves(program_.jumps[s.payload], i, begin, end)) return;
      if (is_end_of_program(s.kind) || s.kind == StatementKind::alarm || s.kind == StatementKind::native ||
          s.kind == StatementKind::call) {
        return;
      }
      if (s.kind == StatementKind::assign && may_change(program_.assigns[s.payload], condition)) return;
    }
    findings_.add(endless_loop, program_.statements[begin].span);
  }

  [[nodiscard]] bool leaves(const ir::Jump& jump, std::uint32_t at, std::uint32_t begin, std::uint32_t end) const {
    if (jump.number == ir::kNoIndex) return true;
    const ir::Label* label = labels_.find(jump.number, at);
    return label == nullptr || label->statement < begin || label->statement > end;
  }

  bool may_change(const ir::Assign& assign, ir::ExpressionId condition) const {
    if (condition == ir::ExpressionId::none) return false;
    return reads(condition, program_.at(assign.target));
  }
  bool reads(ir::ExpressionId id, const ir::Variable& target) const {
    if (id == ir::ExpressionId::none) return false;
    const ir::Expression& e = program_.at(id);
    if (e.op == ir::Operator::variable) {
      return target.index != ir::ExpressionId::none || program_.at(e.variable).number == target.number;
    }
    return reads(e.a, target) || reads(e.b, target) || reads(e.c, target);
  }
  // Clocks, signals and positions do; a variable with a computed number may be one of them.
  bool changes_by_itself(ir::ExpressionId id) const {
    if (id == ir::ExpressionId::none) return false;
    const ir::Expression& e = program_.at(id);
    if (e.op == ir::Operator::variable) {
      const ir::Variable& v = program_.at(e.variable);
      return v.index != ir::ExpressionId::none || v.number >= kFirstSystemVariable;
    }
    return changes_by_itself(e.a) || changes_by_itself(e.b) || changes_by_itself(e.c);
  }

  void block_condition(std::uint32_t i) {
    const StatementKind kind = program_.statements[i].kind;
    if (kind == StatementKind::if_begin) {
      conditions_.push_back(i);
      const auto most = control_.limits.condition_nesting;
      if (most != 0 && conditions_.size() == most + 1) {
        findings_.add(nesting_too_deep, program_.statements[i].span,
                      {std::to_string(conditions_.size()), std::to_string(most)}, ir::AlarmDetail::if_nesting);
      }
    }
    const bool has_begin = !conditions_.empty();
    if (kind == StatementKind::else_begin && !has_begin) unopened(i, "ELSE");
    if (kind != StatementKind::if_end) return;
    if (has_begin) {
      conditions_.pop_back();
    } else {
      unopened(i, "ENDIF");
    }
  }
  void unopened(std::uint32_t i, std::string_view word) {
    findings_.add(end_without_begin, program_.statements[i].span, {std::string(word), "IF"},
                  ir::AlarmDetail::condition_end);
  }

  // Deeper loops are a fault already, and a text of nothing but DO must not take for ever.
  static constexpr std::size_t kDeepestLoopLookedAt = 32;
  static constexpr std::uint32_t kFirstSystemVariable = 1000;

  const ir::Program& program_;
  const ir::Control& control_;
  const Section& section_;
  Findings& findings_;
  LabelIndex labels_;
  std::vector<std::uint32_t> open_;
  std::vector<std::uint32_t> conditions_;
};

}  // namespace

void check_loops(const ir::Program& program, const ir::Control& control, const Section& section, Findings& findings) {
  LoopCheck(program, control, section, findings).run();
}

// IF … THEN, ELSE and ENDIF in blocks of their own: older controls take IF … THEN with one statement only, and which of
// the newer ones take more is not certain. Said once.
void check_condition_blocks(const ir::Program& program, Findings& findings) {
  for (const ir::Statement& s : program.statements) {
    const bool own_block = s.tokens.first != s.tokens.last;
    if (!own_block || (s.kind != StatementKind::else_begin && s.kind != StatementKind::if_end)) continue;
    text::Diagnostic* finding =
        findings.add(syntax_error, s.span, {"only the newest of these controls have IF over several blocks"});
    if (finding == nullptr) return;
    finding->severity = text::Severity::warning;
    finding->alarm.clear();
    return;
  }
}

}  // namespace dripfeed::macro_b
