// Nesting of IF, WHILE, FOR, LOOP and REPEAT, and jumps that would enter one of them.
#include <algorithm>

#include "dialects/facts/flow_graph.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using text::DiagnosticId;

struct StructureWords {
  StatementKind begin;
  StatementKind end;
  std::string_view begin_word;
  std::string_view end_word;
};
constexpr StructureWords kWords[] = {
    {StatementKind::if_begin, StatementKind::if_end, "IF", "ENDIF"},
    {StatementKind::while_begin, StatementKind::while_end, "WHILE", "ENDWHILE"},
    {StatementKind::repeat_begin, StatementKind::repeat_end, "REPEAT", "UNTIL"},
    {StatementKind::for_begin, StatementKind::for_end, "FOR", "ENDFOR"},
    {StatementKind::loop_begin, StatementKind::loop_end, "LOOP", "ENDLOOP"},
};

const StructureWords* row_of_begin(StatementKind kind) {
  const auto row = std::ranges::find(kWords, kind, &StructureWords::begin);
  return row == std::end(kWords) ? nullptr : row;
}
const StructureWords* row_of_end(StatementKind kind) {
  const auto row = std::ranges::find(kWords, kind, &StructureWords::end);
  return row == std::end(kWords) ? nullptr : row;
}

class Nesting {
 public:
  explicit Nesting(const Check& check) : check_(check), enclosing_(check.program.statements.size(), ir::kNoIndex) {}

  void run() {
    const auto& statements = check_.program.statements;
    for (std::uint32_t i = 0; i < statements.size(); ++i) visit(i, statements[i]);
    for (const Open& open : open_) {
      check_.report(DiagnosticId::missing_end, statements[open.statement].span,
                    {std::string(open.words->begin_word), std::string(open.words->end_word)});
    }
    if (!open_.empty() || faulty_) return;
    jumps();
    for (std::uint32_t i = 0; i < statements.size(); ++i)
      if (repeats_for_ever(i) && !has_exit(i)) check_.report(DiagnosticId::endless_loop, statements[i].span);
  }

 private:
  struct Open {
    std::uint32_t statement;
    std::uint32_t part;  // the opener or its ELSE
    const StructureWords* words;
  };

  void visit(std::uint32_t i, const ir::Statement& s) {
    if (const StructureWords* words = row_of_end(s.kind)) close(s, *words);
    if (s.kind == StatementKind::else_begin) middle(i, s);
    // An opener and a closer belong to what is around them: a jump to them is allowed.
    enclosing_[i] = open_.empty() || s.kind == StatementKind::else_begin ? ir::kNoIndex : open_.back().part;
    if (const StructureWords* words = row_of_begin(s.kind)) {
      open_.push_back({i, i, words});
      if (open_.size() == check_.control.limits.loop_nesting + std::size_t{1}) {
        check_.report(DiagnosticId::nesting_too_deep, s.span,
                      {std::to_string(open_.size()), std::to_string(check_.control.limits.loop_nesting)});
      }
    }
  }

  void middle(std::uint32_t i, const ir::Statement& s) {
    if (!open_.empty() && open_.back().words->begin == StatementKind::if_begin &&
        open_.back().part == open_.back().statement) {
      open_.back().part = i;
      return;
    }
    faulty_ = true;
    check_.report(DiagnosticId::end_without_begin, s.span, {"ELSE", "IF"});
  }

  void close(const ir::Statement& s, const StructureWords& words) {
    const auto partner = std::find_if(open_.rbegin(), open_.rend(), [&](const Open& o) { return o.words == &words; });
    if (partner == open_.rend()) {
      if (s.kind == StatementKind::if_end) return surplus_end(s);
      faulty_ = true;
      check_.report(DiagnosticId::end_without_begin, s.span,
                    {std::string(words.end_word), std::string(words.begin_word)});
      return;
    }
    if (partner != open_.rbegin()) {
      faulty_ = true;
      check_.report(DiagnosticId::wrong_nesting, s.span,
                    {std::string(words.end_word), std::string(open_.back().words->begin_word)});
    }
    open_.erase(std::prev(partner.base()), open_.end());
  }

  // ENDIF after IF … GOTOF, and one too many: programs in use have it, and controls run them.
  void surplus_end(const ir::Statement& s) {
    text::Diagnostic& d = check_.report(DiagnosticId::end_without_begin, s.span, {"ENDIF", "IF"});
    d.severity = text::Severity::warning;
    d.notes.push_back({s.span, "it closes nothing; IF with a jump in the same block needs no ENDIF"});
  }

  // A jump may leave structures, never enter one: its target's structure must be around the jump, too.
  void jumps() {
    const auto& statements = check_.program.statements;
    for (std::uint32_t i = 0; i < statements.size(); ++i) {
      if (statements[i].kind != StatementKind::go_to) continue;
      const std::uint32_t target = facts::target_of(check_.program, i);
      if (target == ir::kNoIndex || enclosing_[target] == ir::kNoIndex || is_around(enclosing_[target], i)) continue;
      // The manual forbids it; controls in use do not always stop, and what the structure does then is not defined.
      const ir::Jump& jump = check_.program.jumps[statements[i].payload];
      const std::string name = jump.label == ir::StringId::none ? "N" + std::to_string(jump.number)
                                                                : std::string(check_.program.strings.at(jump.label));
      check_.report(DiagnosticId::jump_into_loop, statements[i].span, {name}).severity = text::Severity::warning;
    }
  }

  // LOOP, and WHILE of a constant that is true.
  [[nodiscard]] bool repeats_for_ever(std::uint32_t i) const {
    const ir::Statement& s = check_.program.statements[i];
    if (s.kind == StatementKind::loop_begin) return true;
    if (s.kind != StatementKind::while_begin) return false;
    const ir::Expression& e = check_.program.at(check_.program.structures[s.payload].condition);
    return e.op == ir::Operator::constant && e.value != 0.0;
  }

  [[nodiscard]] bool has_exit(std::uint32_t begin) const {
    const auto& statements = check_.program.statements;
    const std::uint32_t end = check_.program.structures[statements[begin].payload].partner;
    for (std::uint32_t i = begin; i < end; ++i) {
      const StatementKind kind = statements[i].kind;
      if (kind == StatementKind::program_end || kind == StatementKind::subprogram_return) return true;
      if (kind == StatementKind::native && !check_.program.natives[statements[i].payload].effects_known) return true;
      if (kind != StatementKind::go_to) continue;
      const std::uint32_t target = facts::target_of(check_.program, i);
      if (target == ir::kNoIndex || target <= begin || target >= end) return true;
    }
    return false;
  }

  [[nodiscard]] bool is_around(std::uint32_t part, std::uint32_t statement) const {
    for (std::uint32_t at = enclosing_[statement]; at != ir::kNoIndex; at = enclosing_[at])
      if (at == part) return true;
    return false;
  }

  const Check& check_;
  std::vector<Open> open_;
  std::vector<std::uint32_t> enclosing_;  // the opener or ELSE around each statement
  bool faulty_ = false;
};

}  // namespace

void check_structures(const Check& check) { Nesting(check).run(); }

}  // namespace dripfeed::sinumerik
