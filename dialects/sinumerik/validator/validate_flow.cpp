// Labels and jumps; blocks that are never reached; the program's end.
#include <algorithm>
#include <map>
#include <utility>

#include "dialects/facts/flow_graph.h"
#include "dialects/ir/repetition.h"
#include "dialects/sinumerik/reader/one_per_name.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/validator/unreached.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using text::DiagnosticId;

std::string name_of_target(const ir::Program& program, const ir::Jump& jump) {
  if (jump.label != ir::StringId::none) return std::string(program.strings.at(jump.label));
  return "N" + std::to_string(jump.number);
}

class Reachability {
 public:
  explicit Reachability(const Check& check) : check_(check), statements_(check.program.statements) {}

  void run() {
    std::vector<bool> reached(statements_.size() + 1, false);
    flood(check_.program, graph_, graph_.entries(), ir::kNoIndex, reached);
    report(reached);
    if (!is_data_file(check_.program) && !ends_by_reposition() && runs_off_the_end()) {
      const auto count = static_cast<std::uint32_t>(statements_.size());
      check_.report(DiagnosticId::missing_program_end, ir::span_of_last(check_.program, 0, count));
    }
  }

 private:
  // An asynchronous subprogram may end by REPOS instead of M17 (PGA, "Interrupt routine").
  [[nodiscard]] bool ends_by_reposition() const {
    const auto says_something = [](const ir::Statement& s) { return s.kind != StatementKind::empty; };
    const auto last = std::find_if(statements_.rbegin(), statements_.rend(), says_something);
    if (last == statements_.rend()) return false;
    for (std::uint32_t t = last->tokens.first; t < last->tokens.last; ++t)
      if (UpperName(check_.text_of(check_.program.tokens[t].span)).view().starts_with("REPOS")) return true;
    return false;
  }

  // A part that REPEAT runs may be the text's last: after its last block the run returns.
  bool runs_off_the_end() {
    std::vector<bool> reached(statements_.size() + 1, false);
    flood(check_.program, graph_, graph_.entries_for_good(), ir::kNoIndex, reached, Contours::left_out);
    if (reached.back()) return true;
    return std::ranges::any_of(ir::repeated_parts(check_.program), [this](const ir::RepeatedPart& part) {
      if (!part.is_found() || (part.last == ir::kNoIndex && part.first > part.repeat)) return false;
      std::vector<bool> in_part(statements_.size() + 1, false);
      flood(check_.program, graph_, {part.first}, part.last == ir::kNoIndex ? part.repeat : part.last, in_part);
      return static_cast<bool>(in_part.back());
    });
  }

  // One warning for each stretch that is not reached; closers of structures and empty lines are no blocks to miss.
  void report(const std::vector<bool>& reached) const {
    const std::vector<bool> of_cycle = contours_of_cycles(check_.program, reached);
    bool in_stretch = false;
    for (std::uint32_t i = 0; i < statements_.size(); ++i) {
      if (of_cycle[i]) {
        in_stretch = false;
        continue;
      }
      const StatementKind kind = statements_[i].kind;
      const bool closer = kind == StatementKind::if_end || kind == StatementKind::while_end ||
                          kind == StatementKind::for_end || kind == StatementKind::loop_end ||
                          kind == StatementKind::repeat_end || kind == StatementKind::else_begin;
      if (reached[i]) in_stretch = false;
      if (reached[i] || in_stretch || closer || kind == StatementKind::empty || kind == StatementKind::declaration ||
          kind == StatementKind::define)
        continue;
      // A second end after the first ("M30" after "M17") is habit, not a mistake.
      if (kind == StatementKind::program_end || kind == StatementKind::subprogram_return) continue;
      in_stretch = true;
      check_.report(DiagnosticId::unreachable, statements_[i].span);
    }
  }

  const Check& check_;
  const std::vector<ir::Statement>& statements_;
  facts::FlowGraph graph_{check_.program};
};

}  // namespace

void check_labels(const Check& check) {
  const ir::Program& program = check.program;
  struct First {
    text::Span span;
    bool is_reported = false;
  };
  std::map<std::pair<std::size_t, ir::StringId>, First> names;
  for (const ir::Label& label : program.labels) {
    if (label.name == ir::StringId::none) continue;
    const std::pair name(section_of(program, label.span.begin), label.name);
    const auto [first, is_new] = names.emplace(name, First{label.span});
    if (is_new || std::exchange(first->second.is_reported, true)) continue;  // once a name
    text::Diagnostic& d =
        check.report(DiagnosticId::label_defined_twice, label.span, {std::string(program.strings.at(label.name))});
    // 12450, but programs in use have such labels: a jump takes the nearest in its direction.
    d.severity = text::Severity::warning;
    d.notes.push_back({first->second.span, "the first one is here"});
  }
  bool certain = true;  // every run comes to this statement
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    const ir::Statement& s = program.statements[i];
    const bool every_run =
        std::exchange(certain, certain && s.kind != StatementKind::go_to && !ir::is_structure(s.kind));
    if (s.kind != StatementKind::go_to) continue;
    const ir::Jump& jump = program.jumps[s.payload];
    if (jump.tolerant || jump.computed != ir::ExpressionId::none || facts::target_of(program, i) != ir::kNoIndex)
      continue;
    text::Diagnostic& d = check.report(DiagnosticId::jump_target_missing, s.span, {name_of_target(program, jump)});
    if (every_run && jump.condition == ir::ExpressionId::none) continue;
    d.severity = text::Severity::warning;
    d.notes.push_back({s.span, "the control stops with this alarm in a run that takes the jump"});
  }
}

void check_reachability(const Check& check) { Reachability(check).run(); }

}  // namespace dripfeed::sinumerik
