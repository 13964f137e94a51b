// What a loop does not change is computed before it: whole assignments, and parts of expressions in a number of their
// own. Nothing is hoisted that may be an alarm: the loop may never come to it.
#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "dialects/facts/flow_graph.h"
#include "dialects/optimize/edit.h"
#include "dialects/optimize/work.h"
#include "dialects/passes/structure_parts.h"

namespace dripfeed::optimize {

namespace {

using ir::ExpressionId;
using ir::StatementKind;

struct Loop {
  std::uint32_t first = 0;  // its head
  std::uint32_t last = 0;   // its end
};

class Hoisting {
 public:
  explicit Hoisting(Work& work)
      : work_(work),
        program_(work.program),
        places_(program_, work.control, work.own),
        accesses_(accesses_of(program_, places_)),
        liveness_(program_, places_, accesses_),
        is_target_(facts::jump_targets(program_)),
        is_moved_(program_.statements.size(), false) {}

  // The innermost loops first: what leaves one may leave the loop around it in the next call.
  bool run() {
    if (hoist_each([this](const Loop& loop) { return find_moved(loop); })) return move(), true;
    return hoist_each([this](const Loop& loop) { return find_part(loop); }) && (replace_parts(), true);
  }

 private:
  // Loops that lie apart are looked at in one call.
  template <class Find>
  bool hoist_each(const Find& find) {
    std::vector<Loop> taken;
    for (const Loop& loop : loops()) {
      const auto overlaps = [&](const Loop& other) { return loop.first <= other.last && other.first <= loop.last; };
      if (std::ranges::none_of(taken, overlaps) && find(loop)) taken.push_back(loop);
    }
    return !taken.empty();
  }

  [[nodiscard]] std::vector<Loop> loops() const {
    std::vector<Loop> out;
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (passes::begins_loop(s.kind)) out.push_back({i, program_.structures[s.payload].partner});
    }
    std::ranges::stable_sort(out, {}, [](const Loop& l) { return l.last - l.first; });
    return out;
  }

  // What the loop sets. Nothing comes back where a jump into it would pass by what stands before it.
  struct Sets {
    std::vector<std::uint32_t> count;  // by place
    bool shared = false;
  };
  [[nodiscard]] std::optional<Sets> sets_of(const Loop& loop) const {
    Sets out{.count = std::vector<std::uint32_t>(places_.count(), 0)};
    for (std::uint32_t i = loop.first; i <= loop.last; ++i) {
      if (is_target_[i]) return {};
      for (const Place p : accesses_[i].sets) ++out.count[p];
      out.shared = out.shared || accesses_[i].sets_shared;
    }
    return out;
  }

  [[nodiscard]] bool is_invariant(const Sets& sets, ExpressionId id) const {
    if (!is_pure(program_, places_, id) || mentions_vacant(program_, id) || may_fault(program_, id)) return false;
    std::vector<Place> operands;
    add_places(program_, places_, id, operands);
    return std::ranges::all_of(operands,
                               [&](Place p) { return sets.count[p] == 0 && !(sets.shared && places_.is_shared(p)); });
  }

  bool find_moved(const Loop& loop) {
    const std::optional<Sets> sets = sets_of(loop);
    if (!sets) return false;
    std::vector<std::uint32_t> moved;
    for (std::uint32_t i = loop.first + 1; i < loop.last; ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind != StatementKind::assign || accesses_[i].is_fixed || accesses_[i].sets.size() != 1) continue;
      const Place place = accesses_[i].sets.front();
      const bool is_real = places_.at(place).is_plain && places_.at(place).type == ir::ValueType::real;
      if (!is_real || sets->count[place] != 1 || liveness_.before(loop.first, place)) continue;
      if (sets->shared && places_.is_shared(place)) continue;
      if (is_invariant(*sets, program_.assigns[s.payload].value)) moved.push_back(i);
    }
    if (moved.empty()) return false;
    for (const std::uint32_t m : moved) is_moved_[m] = true;
    moved_[loop.first] = std::move(moved);
    return true;
  }

  void move() {
    passes::Rewrite out(program_);
    for (std::uint32_t i = 0; i < accesses_.size(); ++i) {
      out.at(i);
      if (const auto before = moved_.find(i); before != moved_.end()) {
        for (const std::uint32_t m : before->second) {
          const ir::Assign assign = program_.assigns[program_.statements[m].payload];
          out.emit_assign(assign.target, assign.value);
          out.last().line = work_.new_line(program_.statements[m].line, {program_.statements[m].line});
          work_.report(Rule::invariants, program_.statements[m].line, "the loop does not change it: set before");
        }
        out.labels_from_here();
      }
      if (!is_moved_[i]) out.keep();
    }
    out.finish();
  }

  // The largest parts that cost more than reading a number does, one of them for each loop.
  bool find_part(const Loop& loop) {
    const std::optional<Sets> sets = sets_of(loop);
    if (!sets) return false;
    std::vector<ExpressionId> parts;
    for (std::uint32_t i = loop.first; i <= loop.last && parts.empty(); ++i) {
      if (accesses_[i].is_fixed) continue;
      for_each_changeable(program_, program_.statements[i], [&](ExpressionId root) { collect(root, *sets, parts); });
    }
    if (parts.empty()) return false;
    // One for all loops that lie apart: nothing reads it after its loop.
    if (!number_) number_ = free_place(work_);
    if (!number_) return false;
    work_.report(Rule::invariants, program_.statements[loop.first].line,
                 fmt::format("what the loop does not change is computed before it, in {}{}",
                             number_->bank == ir::Bank::r ? "R" : "#", number_->number));
    parts_.push_back({loop, parts.front()});
    return true;
  }

  void collect(ExpressionId id, const Sets& sets, std::vector<ExpressionId>& parts) const {
    if (id == ExpressionId::none) return;
    const ir::Expression e = program_.at(id);
    if (e.op == ir::Operator::constant || e.op == ir::Operator::variable) return;
    if (is_invariant(sets, id) && is_number(program_, work_.control, id) && is_worth_it(id)) {
      parts.push_back(id);
      return;
    }
    for (const ExpressionId operand : {e.a, e.b, e.c}) collect(operand, sets, parts);
  }

  [[nodiscard]] bool is_worth_it(ExpressionId id) const {
    const ir::Operator op = program_.at(id).op;
    if (op >= ir::Operator::equal && op <= ir::Operator::greater_equal) return false;  // a condition is not a number
    const double read = read_cost(work_.cost, {.bank = ir::Bank::r});
    return cost_of(program_, work_.cost, id) > read + 1e-6;
  }

  void replace_parts() {
    std::ranges::sort(parts_, {}, [](const Part& part) { return part.loop.first; });
    passes::Rewrite out(program_);
    auto part = parts_.begin();
    for (std::uint32_t i = 0; i < accesses_.size(); ++i) {
      out.at(i);
      if (part != parts_.end() && part->loop.last < i) ++part;
      if (part == parts_.end() || i < part->loop.first) {
        out.keep();
        continue;
      }
      if (i == part->loop.first) {
        out.emit_assign(variable_of(program_, *number_), part->value);
        out.last().line = work_.new_line(program_.statements[i].line);
        out.labels_from_here();
      }
      if (accesses_[i].is_fixed) {
        out.keep();
        continue;
      }
      keep_with(program_, i, out, [&](ExpressionId id) {
        return rebuilt(program_, id, [&](ExpressionId node) {
          return is_same(node, part->value) ? read_of(program_, *number_) : node;
        });
      });
    }
    out.finish();
  }

  [[nodiscard]] bool is_same(ExpressionId a, ExpressionId b) const {
    if (a == b) return true;
    if (a == ExpressionId::none || b == ExpressionId::none) return false;
    const ir::Expression& x = program_.at(a);
    const ir::Expression& y = program_.at(b);
    if (x.op != y.op) return false;
    if (x.op == ir::Operator::constant) return x.value == y.value;
    if (x.op == ir::Operator::variable) return place_at(program_, places_, a) == place_at(program_, places_, b);
    return is_same(x.a, y.a) && is_same(x.b, y.b) && is_same(x.c, y.c);
  }

  Work& work_;
  ir::Program& program_;
  Places places_;
  std::vector<Access> accesses_;
  Liveness liveness_;
  std::vector<bool> is_target_;
  struct Part {
    Loop loop;
    ExpressionId value = ExpressionId::none;
  };
  std::map<std::uint32_t, std::vector<std::uint32_t>> moved_;  // by the head of the loop
  std::vector<bool> is_moved_;                                 // by statement
  std::vector<Part> parts_;
  std::optional<PlaceFacts> number_;  // that takes the parts
};

}  // namespace

bool hoist_invariants(Work& work) { return Hoisting(work).run(); }

}  // namespace dripfeed::optimize
