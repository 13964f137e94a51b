// A jump back that is a loop becomes one, and jumps over parts become IF with ELSE. Only jumps whose label no other
// jump uses, around parts that no jump leads into.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "dialects/facts/flow_graph.h"
#include "dialects/optimize/work.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/passes/structures.h"

namespace dripfeed::optimize {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

enum class Form : std::uint8_t { repeat_until, while_do, if_then, if_else };

// Statements [first, last): of a loop the jump is `last`, of an IF it is `first`; `middle` is the jump at the end of
// the first part, `end` the statement after the second.
struct Region {
  Form form = Form::if_then;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  std::uint32_t middle = ir::kNoIndex;
  std::uint32_t end = 0;
  std::uint8_t number = 0;  // of a loop, where loops have numbers
};

class Structurer {
 public:
  Structurer(Work& work, bool loops, bool branches)
      : work_(work),
        loops_(loops),
        branches_(branches),
        program_(work.program),
        has_words_(!ir::has_numbered_variables(work.control)) {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    target_.assign(count, ir::kNoIndex);
    for (std::uint32_t i = 0; i < count; ++i) {
      if (program_.statements[i].kind != StatementKind::go_to) continue;
      target_[i] = facts::target_of(program_, i);
      if (target_[i] != ir::kNoIndex) sources_[target_[i]].push_back(i);
    }
  }

  bool run() {
    std::vector<Region> found;
    for (const auto& [jump, target] : shortest_first()) {
      if (target <= jump ? !loops_ : !branches_) continue;
      std::optional<Region> region = target <= jump ? loop(target, jump) : condition(jump, target);
      if (region && fits(found, *region) && give_number(found, *region)) found.push_back(*region);
    }
    if (!found.empty()) rewrite(found);
    return !found.empty();
  }

 private:
  [[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> shortest_first() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    for (std::uint32_t i = 0; i < target_.size(); ++i)
      if (target_[i] != ir::kNoIndex) out.emplace_back(i, target_[i]);
    std::ranges::stable_sort(
        out, {}, [](const auto& p) { return p.first < p.second ? p.second - p.first : p.first - p.second; });
    return out;
  }

  [[nodiscard]] const ir::Jump& jump_at(std::uint32_t i) const {
    return program_.jumps[program_.statements[i].payload];
  }

  // Whether structures begin and end within, and only `allowed` jump there from outside; a jump to `first` itself comes
  // from outside by falling in.
  [[nodiscard]] bool is_closed(std::uint32_t first, std::uint32_t last, std::uint32_t allowed) const {
    for (std::uint32_t i = first; i < last; ++i) {
      const ir::Statement& s = program_.statements[i];
      if (ir::is_structure(s.kind)) {
        const std::uint32_t partner = program_.structures[s.payload].partner;
        if (partner == ir::kNoIndex || partner < first || partner >= last) return false;
      }
      const auto from = sources_.find(i);
      if (from == sources_.end()) continue;
      for (const std::uint32_t jump : from->second)
        if (jump != allowed && (jump < first || jump >= last)) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_only_source(std::uint32_t target, std::uint32_t jump) const {
    return sources_.at(target).size() == 1 && sources_.at(target).front() == jump;
  }

  // The jumps of CASE are one block.
  [[nodiscard]] bool shares_its_line(std::uint32_t i) const {
    const auto is_neighbour = [&](std::uint32_t other) {
      return program_.statements[other].kind == StatementKind::go_to &&
             program_.statements[other].line == program_.statements[i].line;
    };
    return (i > 0 && is_neighbour(i - 1)) || (i + 1 < program_.statements.size() && is_neighbour(i + 1));
  }

  [[nodiscard]] bool is_plain_jump(std::uint32_t i) const {
    const ir::Jump& jump = jump_at(i);
    return !shares_its_line(i) && program_.statements[i].skip_level == 0 && !jump.tolerant && !jump.restart &&
           !program_.statements[i].is_label;
  }

  [[nodiscard]] std::optional<Region> loop(std::uint32_t target, std::uint32_t jump) const {
    if (jump_at(jump).condition == ExpressionId::none || !is_plain_jump(jump)) return {};
    if (!is_only_source(target, jump) || !is_closed(target, jump, jump)) return {};
    Region region{.first = target, .last = jump, .end = jump + 1};
    if (begins_true(target, jump_at(jump).condition))
      region.form = Form::while_do;
    else if (has_words_)
      region.form = Form::repeat_until;
    else
      return {};
    return region;
  }

  [[nodiscard]] std::optional<Region> condition(std::uint32_t jump, std::uint32_t target) const {
    if (!has_words_ || jump_at(jump).condition == ExpressionId::none || !is_plain_jump(jump)) return {};
    if (target == jump + 1 || !is_closed(jump + 1, target, jump)) return {};
    const std::uint32_t middle = target - 1;
    if (middle > jump && target_[middle] != ir::kNoIndex && target_[middle] > target && is_plain_jump(middle) &&
        jump_at(middle).condition == ExpressionId::none && is_only_source(target, jump) &&
        is_closed(target, target_[middle], jump))
      return Region{.form = Form::if_else, .first = jump, .last = target, .middle = middle, .end = target_[middle]};
    return Region{.form = Form::if_then, .first = jump, .last = target, .end = target};
  }

  // Whether the condition is certainly true where the loop is entered: by constants that stand before it.
  [[nodiscard]] bool begins_true(std::uint32_t target, ExpressionId condition) const {
    if (!passes::is_comparison(program_, condition)) return false;
    const ir::Expression e = program_.at(condition);
    const std::optional<double> a = value_before(target, e.a), b = value_before(target, e.b);
    if (!a || !b) return false;
    constexpr double kApart = 1e-3;  // no control's tolerance takes these for equal
    switch (e.op) {
      case Operator::less:
      case Operator::less_equal: return *b - *a > kApart;
      case Operator::greater:
      case Operator::greater_equal: return *a - *b > kApart;
      case Operator::not_equal: return std::abs(*a - *b) > kApart;
      default: return false;
    }
  }

  [[nodiscard]] std::optional<double> value_before(std::uint32_t statement, ExpressionId id) const {
    const ir::Expression& e = program_.at(id);
    if (e.op == Operator::constant) return e.value;
    if (e.op != Operator::variable) return {};
    const ir::Variable wanted = program_.at(e.variable);
    if (wanted.index != ExpressionId::none || wanted.bank == ir::Bank::system) return {};
    for (std::uint32_t i = statement; i-- > 0;) {
      const ir::Statement& s = program_.statements[i];
      const bool is_straight =
          s.kind == StatementKind::empty || s.kind == StatementKind::block || s.kind == StatementKind::assign;
      if (!is_straight || s.skip_level != 0 || sources_.contains(i + 1 == statement ? ir::kNoIndex : i + 1)) return {};
      if (s.kind != StatementKind::assign) continue;
      const ir::Assign& assign = program_.assigns[s.payload];
      const ir::Variable& set = program_.at(assign.target);
      if (set.index != ExpressionId::none) return {};
      if (set.bank != wanted.bank || set.number != wanted.number || set.symbol != wanted.symbol) continue;
      const ir::Expression& value = program_.at(assign.value);
      if (value.op != Operator::constant) return {};
      return value.value;
    }
    return {};
  }

  // Nested in one that was found, around it, or apart from it: never across an edge.
  [[nodiscard]] static bool fits(const std::vector<Region>& found, const Region& region) {
    const auto apart_or_nested = [](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
      return b <= c || d <= a || (a <= c && d <= b) || (c <= a && b <= d);
    };
    return std::ranges::all_of(found, [&](const Region& other) {
      const auto parts = [](const Region& r) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> out = {{r.first, std::max(r.end, r.last)}};
        if (r.form == Form::if_else) out = {{r.first, r.last}, {r.middle, r.end}, {r.first, r.end}};
        return out;
      };
      for (const auto& [a, b] : parts(other))
        for (const auto& [c, d] : parts(region))
          if (!apart_or_nested(a, b, c, d)) return false;
      return true;
    });
  }

  // DO 1 to DO 3: another number than all loops around it and in it. False: there is none left.
  [[nodiscard]] bool give_number(const std::vector<Region>& found, Region& region) const {
    if (has_words_) return true;
    std::array<bool, 256> used{};
    for (const Region& other : found)
      if (other.first <= region.last && region.first <= other.last) used[other.number] = true;
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind != StatementKind::while_begin && s.kind != StatementKind::loop_begin) continue;
      const ir::Structure& loop = program_.structures[s.payload];
      if (i <= region.last && loop.partner != ir::kNoIndex && loop.partner >= region.first)
        used[loop.loop_number] = true;
    }
    for (std::uint32_t n = 1; n <= work_.control.limits.loop_nesting && n < used.size(); ++n) {
      if (used[n]) continue;
      region.number = static_cast<std::uint8_t>(n);
      return true;
    }
    return false;
  }

  void rewrite(const std::vector<Region>& found) {
    std::map<std::uint32_t, std::vector<const Region*>> begins, ends;
    std::map<std::uint32_t, const Region*> middles, jumps;
    for (const Region& r : found) {
      const bool is_loop = r.form == Form::while_do || r.form == Form::repeat_until;
      if (is_loop) begins[r.first].push_back(&r), jumps[r.last] = &r;
      if (!is_loop) jumps[r.first] = &r, ends[r.end].push_back(&r);
      if (r.middle != ir::kNoIndex) middles[r.middle] = &r;
      say(r);
    }
    passes::Rewrite out(program_);
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out.at(i);
      for (std::size_t n = ends.contains(i) ? ends[i].size() : 0; n > 0; --n)
        out.emit_structure(StatementKind::if_end, {});
      if (ends.contains(i)) out.labels_from_here();
      if (begins.contains(i)) {
        auto loops = begins[i];
        std::ranges::sort(loops, std::ranges::greater(), &Region::last);
        for (const Region* r : loops) open_loop(*r, out);
        out.labels_from_here();
      }
      if (middles.contains(i)) {
        out.emit_structure(StatementKind::else_begin, {});
      } else if (jumps.contains(i)) {
        close_or_branch(*jumps[i], out);
      } else {
        out.keep();
      }
    }
    out.finish();
  }

  void open_loop(const Region& r, passes::Rewrite& out) {
    ir::Structure head;
    head.loop_number = r.number;
    if (r.form == Form::while_do) head.condition = jump_at(r.last).condition;
    out.emit_structure(r.form == Form::while_do ? StatementKind::while_begin : StatementKind::repeat_begin, head);
  }

  void close_or_branch(const Region& r, passes::Rewrite& out) {
    const ExpressionId condition =
        jump_at(r.form == Form::if_then || r.form == Form::if_else ? r.first : r.last).condition;
    ir::Structure structure;
    structure.loop_number = r.number;
    if (r.form == Form::while_do) return out.emit_structure(StatementKind::while_end, structure);
    structure.condition = passes::negated(program_, condition);
    out.emit_structure(r.form == Form::repeat_until ? StatementKind::repeat_end : StatementKind::if_begin, structure);
  }

  void say(const Region& r) {
    const bool is_loop = r.form == Form::while_do || r.form == Form::repeat_until;
    const std::uint32_t line = program_.statements[is_loop ? r.last : r.first].line;
    work_.report(is_loop ? Rule::loops : Rule::branches, line,
                 r.form == Form::while_do       ? "the jump back is a WHILE loop"
                 : r.form == Form::repeat_until ? "the jump back is a REPEAT loop"
                 : r.form == Form::if_else      ? "the jumps are an IF with ELSE"
                                                : "the jump is an IF");
  }

  Work& work_;
  bool loops_;
  bool branches_;
  ir::Program& program_;
  bool has_words_;                                               // IF, ELSE, ENDIF, REPEAT, UNTIL
  std::vector<std::uint32_t> target_;                            // of jumps
  std::map<std::uint32_t, std::vector<std::uint32_t>> sources_;  // of statements that are jumped to
};

}  // namespace

bool structure_jumps(Work& work, bool loops, bool branches) {
  return (loops || branches) && Structurer(work, loops, branches).run();
}

}  // namespace dripfeed::optimize
