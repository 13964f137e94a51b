// Assignments that stand together are put into as few blocks as their order allows: none in a block reads or sets what
// another of the block sets. Controls with numbered variables take one a block.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "dialects/facts/flow_graph.h"
#include "dialects/ir/readable_line.h"
#include "dialects/optimize/expressions.h"
#include "dialects/optimize/work.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/structure_parts.h"

namespace dripfeed::optimize {

namespace {

using ir::StatementKind;

bool is_product(ir::Operator op) { return op == ir::Operator::multiply || op == ir::Operator::divide; }
bool is_sum(ir::Operator op) { return op == ir::Operator::add || op == ir::Operator::subtract; }

std::uint32_t columns_of(const ir::Program& program, ir::VariableId id) {
  const ir::Variable& v = program.at(id);
  return static_cast<std::uint32_t>(v.symbol == ir::SymbolId::none
                                        ? 1 + std::to_string(v.number).size()
                                        : program.strings.at(program.at(v.symbol).name).size());
}

// Columns that the expression takes in a line at most: where no more are in doubt than parentheses, those count.
std::uint32_t columns_of(const ir::Program& program, ir::ExpressionId id) {
  constexpr std::uint32_t kParentheses = 2, kLongestName = 7;  // ROUNDUP, " B_AND "
  const ir::Expression& e = program.at(id);
  if (e.op == ir::Operator::variable) return columns_of(program, e.variable);
  if (!is_sum(e.op) && !is_product(e.op)) {
    std::uint32_t operands = 0;
    for (const ir::ExpressionId operand : {e.a, e.b, e.c})
      if (operand != ir::ExpressionId::none) operands += columns_of(program, operand) + kParentheses;
    return operands == 0 ? length_of(program, id) : operands + kLongestName;
  }
  const auto operand = [&](ir::ExpressionId of, bool is_right) {
    const ir::Operator op = program.at(of).op;
    const bool is_leaf = op == ir::Operator::variable || op == ir::Operator::constant;
    const bool is_stronger = is_sum(e.op) && is_product(op);
    const bool is_like = !is_right && (is_sum(e.op) ? is_sum(op) : is_product(op));
    return columns_of(program, of) + (is_leaf || is_stronger || is_like ? 0 : kParentheses);
  };
  return operand(e.a, false) + 1 + operand(e.b, true);
}

class Joining {
 public:
  explicit Joining(Work& work)
      : work_(work),
        program_(work.program),
        places_(program_, work.control, work.own),
        accesses_(accesses_of(program_, places_)),
        is_target_(facts::jump_targets(program_)) {
    if (work.keeps_comments) find_comments();
    find_loops();
  }

  bool run() {
    passes::Rewrite out(program_);
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count;) {
      const std::uint32_t end = end_of_stretch(i);
      if (end - i < 2) {
        out.at(i);
        out.keep();
        ++i;
        continue;
      }
      stretch(i, end, out);
      i = end;
    }
    if (changed_) out.finish();
    return changed_;
  }

 private:
  struct Group {
    std::vector<std::uint32_t> members;
    std::uint32_t length = 0;
  };

  void find_loops() {
    in_loop_.assign(program_.statements.size(), false);
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (!passes::begins_loop(s.kind) || in_loop_[i]) continue;
      for (std::uint32_t n = i; n <= program_.structures[s.payload].partner; ++n) in_loop_[n] = true;
    }
  }

  // Of lines that run once: they say what the program takes.
  void find_comments() {
    for (const ir::Statement& s : program_.statements)
      for (std::uint32_t t = s.tokens.first; t < s.tokens.last; ++t)
        if (program_.tokens[t].kind == ir::TokenKind::comment) has_comment_.insert(s.line);
  }

  [[nodiscard]] bool joins(std::uint32_t i) const {
    const ir::Statement& s = program_.statements[i];
    if (s.kind != StatementKind::assign || accesses_[i].is_fixed || accesses_[i].sets.size() != 1) return false;
    if (!in_loop_[i] && has_comment_.contains(work_.line_of_text(s.line))) return false;
    const Place place = accesses_[i].sets.front();
    return places_.at(place).is_plain && is_pure(program_, places_, program_.assigns[s.payload].value);
  }

  [[nodiscard]] std::uint32_t end_of_stretch(std::uint32_t i) const {
    if (!joins(i)) return i + 1;
    std::uint32_t end = i + 1;
    while (end < accesses_.size() && joins(end) && !is_target_[end] && !program_.statements[end].is_label) ++end;
    return end;
  }

  // Each goes into the first block that it may stand in: after all that it reads, and that read or set what it sets.
  void stretch(std::uint32_t first, std::uint32_t end, passes::Rewrite& out) {
    std::map<Place, std::size_t> last_set, last_read;  // the block after it
    std::vector<Group> groups;
    for (std::uint32_t i = first; i < end; ++i) {
      const Access& access = accesses_[i];
      const Place place = access.sets.front();
      std::size_t earliest = std::max(at(last_set, place), at(last_read, place));
      for (const Place p : access.reads) earliest = std::max(earliest, at(last_set, p));
      const ir::Assign assign = program_.assigns[program_.statements[i].payload];
      const std::uint32_t length = columns_of(program_, assign.target) + columns_of(program_, assign.value) + 2;
      while (earliest < groups.size() && groups[earliest].length + length > ir::kReadableLine) ++earliest;
      if (earliest == groups.size()) groups.push_back({});
      groups[earliest].members.push_back(i);
      groups[earliest].length += length;
      last_set[place] = std::max(at(last_set, place), earliest + 1);
      for (const Place p : access.reads) last_read[p] = std::max(at(last_read, p), earliest + 1);
    }
    if (groups.size() >= blocks_now(first, end)) return keep(first, end, out);
    changed_ = true;
    work_.report(
        Rule::join, program_.statements[first].line,
        fmt::format("{} assignments share {} block{}", end - first, groups.size(), groups.size() == 1 ? "" : "s"));
    // Labels of the stretch stand at its first statement alone.
    for (std::uint32_t i = first; i < end; ++i) out.at(i);
    out.at(first);
    for (const Group& group : groups) emit(group, out);
  }

  static std::size_t at(const std::map<Place, std::size_t>& map, Place place) {
    const auto found = map.find(place);
    return found == map.end() ? 0 : found->second;
  }

  [[nodiscard]] std::size_t blocks_now(std::uint32_t first, std::uint32_t end) const {
    std::size_t count = 1;
    for (std::uint32_t i = first + 1; i < end; ++i)
      if (program_.statements[i].line != program_.statements[i - 1].line) ++count;
    return count;
  }

  void keep(std::uint32_t first, std::uint32_t end, passes::Rewrite& out) {
    for (std::uint32_t i = first; i < end; ++i) out.at(i), out.keep();
  }

  void emit(const Group& group, passes::Rewrite& out) {
    std::vector<std::uint32_t> lines;
    lines.reserve(group.members.size());
    for (const std::uint32_t i : group.members) lines.push_back(program_.statements[i].line);
    const std::uint32_t line = work_.new_line(lines.front(), lines);
    for (const std::uint32_t i : group.members) {
      const ir::Assign assign = program_.assigns[program_.statements[i].payload];
      out.emit_assign(assign.target, assign.value);
      out.last().line = line;
    }
  }

  Work& work_;
  ir::Program& program_;
  Places places_;
  std::vector<Access> accesses_;
  std::vector<bool> is_target_;
  std::vector<bool> in_loop_;            // by statement
  std::set<std::uint32_t> has_comment_;  // lines of the text
  bool changed_ = false;
};

}  // namespace

bool join_blocks(Work& work) { return !ir::has_numbered_variables(work.control) && Joining(work).run(); }

}  // namespace dripfeed::optimize
