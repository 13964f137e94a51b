// Labels and jumps; blocks that are never reached; the program's end.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "dialects/facts/flow_graph.h"
#include "dialects/ir/repetition.h"
#include "dialects/sinumerik/reader/one_per_name.h"
#include "dialects/sinumerik/tables/name_index.h"
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
    flood(graph_.entries(), ir::kNoIndex, reached);
    report(reached);
    if (!is_data_file(check_.program) && runs_off_the_end()) {
      const auto count = static_cast<std::uint32_t>(statements_.size());
      check_.report(DiagnosticId::missing_program_end, ir::span_of_last(check_.program, 0, count));
    }
  }

 private:
  // A cycle runs the blocks of its contour and comes back, whatever stands behind them.
  enum class Contours : std::uint8_t { reached, left_out };

  // Marks what comes after those statements; nothing comes after `last`.
  void flood(std::vector<std::uint32_t> work, std::uint32_t last, std::vector<bool>& reached,
             Contours contours = Contours::reached) {
    while (!work.empty()) {
      const std::uint32_t i = work.back();
      work.pop_back();
      if (reached[i]) continue;
      reached[i] = true;
      if (i == last) continue;
      const bool skips_contour =
          contours == Contours::left_out && i < statements_.size() && statements_[i].kind == StatementKind::call;
      for (const std::uint32_t next : graph_.after(i))
        if (!skips_contour || next == i + 1) work.push_back(next);
    }
  }

  // A part that REPEAT runs may be the text's last: behind its last block the run goes back.
  bool runs_off_the_end() {
    std::vector<bool> reached(statements_.size() + 1, false);
    flood(graph_.entries_for_good(), ir::kNoIndex, reached, Contours::left_out);
    if (reached.back()) return true;
    return std::ranges::any_of(ir::repeated_parts(check_.program), [this](const ir::RepeatedPart& part) {
      if (!part.is_found() || (part.last == ir::kNoIndex && part.first > part.repeat)) return false;
      std::vector<bool> in_part(statements_.size() + 1, false);
      flood({part.first}, part.last == ir::kNoIndex ? part.repeat : part.last, in_part);
      return static_cast<bool>(in_part.back());
    });
  }

  // Labels that a cycle is given in a text, as CYCLE95("START:END",…): the contour between them is run by the cycle.
  [[nodiscard]] std::set<ir::StringId> labels_in_texts() const {
    std::set<ir::StringId> labels;
    for (const ir::Token& token : check_.program.tokens) {
      if (token.kind != ir::TokenKind::string) continue;
      std::string_view text = check_.text_of(token.span);
      while (!text.empty()) {
        const std::size_t begin = text.find_first_not_of("\": ");
        if (begin == std::string_view::npos) break;
        text.remove_prefix(begin);
        const std::string_view name = text.substr(0, text.find_first_of("\": "));
        labels.insert(check_.program.strings.find(UpperName(name).view()));
        text.remove_prefix(name.size());
      }
    }
    return labels;
  }

  // Statements that only a cycle runs: from a label that it is given to the next block that is reached.
  [[nodiscard]] std::vector<bool> contours(const std::vector<bool>& reached) const {
    std::vector<bool> of_cycle(statements_.size(), false);
    const std::set<ir::StringId> named = labels_in_texts();
    for (const ir::Label& label : check_.program.labels)
      if (label.name != ir::StringId::none && named.contains(label.name))
        for (std::uint32_t i = label.statement; i < statements_.size() && !reached[i]; ++i) of_cycle[i] = true;
    return of_cycle;
  }

  // One warning for each stretch that is not reached; closers of structures and empty lines are no blocks to miss.
  void report(const std::vector<bool>& reached) const {
    const std::vector<bool> of_cycle = contours(reached);
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
  std::map<std::pair<std::size_t, ir::StringId>, text::Span> names;
  for (const ir::Label& label : program.labels) {
    if (label.name == ir::StringId::none) continue;
    const std::pair name(section_of(program, label.span.begin), label.name);
    const auto [first, is_new] = names.emplace(name, label.span);
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
    if (jump.tolerant || jump.computed != ir::ExpressionId::none || facts::target_of(program, i) != ir::kNoIndex)
      continue;
    check.report(DiagnosticId::jump_target_missing, s.span, {name_of_target(program, jump)});
  }
}

void check_reachability(const Check& check) { Reachability(check).run(); }

}  // namespace dripfeed::sinumerik
