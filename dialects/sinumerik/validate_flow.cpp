// Labels and jumps; blocks that are never reached; the program's end. Reachability is exact for what is written: a
// condition counts as going both ways unless it is a constant, and where a target is computed every label counts.
#include <algorithm>
#include <map>

#include "dialects/sinumerik/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using text::DiagnosticId;

std::string name_of_target(const ir::Program& program, const ir::Jump& jump) {
  if (jump.label != ir::StringId::none) return std::string(program.strings.at(jump.label));
  return "N" + std::to_string(jump.number);
}

// Statements that may jump to any label or repeat any section.
bool jumps_anywhere(std::string_view native) {
  constexpr std::string_view kNames[] = {"REPEAT", "REPEATB", "CALL", "GOTOS", "EXECSTRING", "SETINT", "SYNTAX ERROR"};
  return std::ranges::find(kNames, native) != std::end(kNames);
}

class Reachability {
 public:
  explicit Reachability(const Check& check)
      : check_(check), statements_(check.program.statements), reached_(statements_.size() + 1, false) {}

  void run() {
    const bool anywhere = std::ranges::any_of(statements_, [this](const ir::Statement& s) { return is_open(s); });
    work_.push_back(0);
    if (anywhere)
      for (const ir::Label& label : check_.program.labels) work_.push_back(label.statement);
    while (!work_.empty()) {
      const std::uint32_t i = work_.back();
      work_.pop_back();
      if (i > statements_.size() || reached_[i]) continue;
      reached_[i] = true;
      if (i < statements_.size()) follow(i);
    }
    report();
  }

 private:
  [[nodiscard]] bool is_open(const ir::Statement& s) const {
    if (s.kind == StatementKind::native) return jumps_anywhere(check_.native_name(s));
    return s.kind == StatementKind::go_to && check_.program.jumps[s.payload].computed != ir::ExpressionId::none;
  }

  // 1 true, 0 false, -1 not known before it runs
  [[nodiscard]] int constant_condition(ir::ExpressionId condition) const {
    if (condition == ir::ExpressionId::none) return 1;
    const ir::Expression& e = check_.program.at(condition);
    return e.op == ir::Operator::constant ? (e.value != 0.0 ? 1 : 0) : -1;
  }

  void go(std::uint32_t statement) { work_.push_back(statement); }

  // Into the body when `enter` may be true, behind the partner when it may be false.
  void opener(std::uint32_t i, int enter) {
    const std::uint32_t partner = check_.program.structures[statements_[i].payload].partner;
    if (enter != 0 || partner == ir::kNoIndex) go(i + 1);
    if (enter != 1 && partner != ir::kNoIndex) go(partner + 1);
  }

  void follow(std::uint32_t i) {
    const ir::Statement& s = statements_[i];
    switch (s.kind) {
      case StatementKind::go_to: {
        const ir::Jump& jump = check_.program.jumps[s.payload];
        const std::uint32_t target = target_of(check_.program, i);
        const int taken = constant_condition(jump.condition);
        if (target != ir::kNoIndex && taken != 0) go(target);
        if (taken != 1 || target == ir::kNoIndex) go(i + 1);
        return;
      }
      case StatementKind::if_begin:
      case StatementKind::while_begin:
        opener(i, constant_condition(check_.program.structures[s.payload].condition));
        return;
      case StatementKind::for_begin: opener(i, -1); return;
      case StatementKind::loop_begin: go(i + 1); return;
      case StatementKind::else_begin: {
        const std::uint32_t partner = check_.program.structures[s.payload].partner;
        go(partner == ir::kNoIndex ? i + 1 : partner + 1);
        return;
      }
      case StatementKind::while_end:
      case StatementKind::for_end:
      case StatementKind::loop_end: {
        const std::uint32_t partner = check_.program.structures[s.payload].partner;
        go(partner == ir::kNoIndex ? i + 1 : partner);
        return;
      }
      case StatementKind::repeat_end: {
        const ir::Structure& structure = check_.program.structures[s.payload];
        const int done = constant_condition(structure.condition);
        if (done != 1 && structure.partner != ir::kNoIndex) go(structure.partner);
        if (done != 0) go(i + 1);
        return;
      }
      case StatementKind::subprogram_return:
      case StatementKind::program_end: return;
      case StatementKind::native:
        if (check_.native_name(s) != "RET") go(i + 1);
        return;
      case StatementKind::empty:
      case StatementKind::block:
      case StatementKind::assign:
      case StatementKind::if_end:
      case StatementKind::repeat_begin:
      case StatementKind::define:
      case StatementKind::call:
      case StatementKind::procedure:
      case StatementKind::declaration:
      case StatementKind::message:
      case StatementKind::alarm: go(i + 1); return;
    }
  }

  // One warning for each stretch that is not reached; closers of structures and empty lines are no blocks to miss.
  void report() const {
    bool in_stretch = false;
    for (std::uint32_t i = 0; i < statements_.size(); ++i) {
      const StatementKind kind = statements_[i].kind;
      const bool closer = kind == StatementKind::if_end || kind == StatementKind::while_end ||
                          kind == StatementKind::for_end || kind == StatementKind::loop_end ||
                          kind == StatementKind::repeat_end || kind == StatementKind::else_begin;
      if (reached_[i]) in_stretch = false;
      if (reached_[i] || in_stretch || closer || kind == StatementKind::empty || kind == StatementKind::declaration ||
          kind == StatementKind::define)
        continue;
      // A second end after the first ("M30" after "M17") is habit, not a mistake.
      if (kind == StatementKind::program_end || kind == StatementKind::subprogram_return) continue;
      in_stretch = true;
      check_.report(DiagnosticId::unreachable, statements_[i].span);
    }
    if (reached_[statements_.size()]) {
      const auto end = static_cast<std::uint32_t>(check_.program.source.text().size());
      check_.report(DiagnosticId::missing_program_end, {end, end});
    }
  }

  const Check& check_;
  const std::vector<ir::Statement>& statements_;
  std::vector<bool> reached_;  // one more for the end of the text
  std::vector<std::uint32_t> work_;
};

}  // namespace

std::uint32_t target_of(const ir::Program& program, std::uint32_t jump_statement) {
  const ir::Jump& jump = program.jumps[program.statements[jump_statement].payload];
  if (jump.computed != ir::ExpressionId::none) return ir::kNoIndex;
  const auto matches = [&jump](const ir::Label& label) {
    return jump.label != ir::StringId::none ? label.name == jump.label
                                            : label.name == ir::StringId::none && label.number == jump.number;
  };
  const auto& labels = program.labels;  // in the order of the text
  const auto behind = std::ranges::partition_point(
      labels, [jump_statement](const ir::Label& label) { return label.statement <= jump_statement; });
  if (jump.search != ir::JumpSearch::backward) {
    const auto found = std::find_if(behind, labels.end(), matches);
    if (found != labels.end()) return found->statement;
    if (jump.search == ir::JumpSearch::forward) return ir::kNoIndex;
    const auto from_top = std::find_if(labels.begin(), behind, matches);
    return from_top == behind ? ir::kNoIndex : from_top->statement;
  }
  const auto found = std::find_if(std::make_reverse_iterator(behind), labels.rend(), matches);
  return found == labels.rend() ? ir::kNoIndex : found->statement;
}

void check_labels(const Check& check) {
  const ir::Program& program = check.program;
  std::map<ir::StringId, text::Span> names;
  for (const ir::Label& label : program.labels) {
    if (label.name == ir::StringId::none) continue;
    const auto [first, is_new] = names.emplace(label.name, label.span);
    if (is_new) continue;
    text::Diagnostic& d =
        check.report(DiagnosticId::label_defined_twice, label.span, {std::string(program.strings.at(label.name))});
    d.severity = text::Severity::error;  // 12450
    d.notes.push_back({first->second, "the first one is here"});
  }
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    const ir::Statement& s = program.statements[i];
    if (s.kind != StatementKind::go_to) continue;
    const ir::Jump& jump = program.jumps[s.payload];
    if (jump.tolerant || jump.computed != ir::ExpressionId::none || target_of(program, i) != ir::kNoIndex) continue;
    check.report(DiagnosticId::jump_target_missing, s.span, {name_of_target(program, jump)});
  }
}

void check_reachability(const Check& check) { Reachability(check).run(); }

}  // namespace dripfeed::sinumerik
