// Follows the text with what each place is worth. A loop begins without what it sets; after an IF holds what neither
// part sets; a block that a jump leads to begins with nothing.
#include <algorithm>
#include <optional>
#include <vector>

#include "dialects/facts/flow_graph.h"
#include "dialects/interpreter/arithmetic/arithmetic.h"
#include "dialects/optimize/edit.h"
#include "dialects/optimize/simplify.h"
#include "dialects/optimize/value_table.h"
#include "dialects/optimize/work.h"
#include "dialects/passes/value_facts.h"

namespace dripfeed::optimize {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

class Propagation {
 public:
  explicit Propagation(Work& work)
      : work_(work),
        program_(work.program),
        arithmetic_(work.control.semantics),
        places_(program_, work.control, work.own),
        accesses_(accesses_of(program_, places_)),
        is_target_(facts::jump_targets(program_)),
        is_parameter_(parameters_of(program_, places_, accesses_)),
        now_(places_.count(), kNoValue) {}

  bool run() {
    passes::Rewrite out(program_);
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out.at(i);
      enter(i);
      const std::uint32_t line = program_.statements[i].line;
      const bool may_change = !accesses_[i].is_fixed && !sets_parameter(i);
      if (!may_change) {
        out.keep();
      } else if (keep_with(program_, i, out, [this](ExpressionId id) { return known(id); })) {
        changed_ = true;
        work_.report(Rule::values, line, "what is known already is not computed again");
      }
      leave(i, may_change ? out.last() : program_.statements[i]);
    }
    out.finish();
    return changed_;
  }

 private:
  using Values = std::vector<Value>;

  // It runs once, and people read it.
  [[nodiscard]] bool sets_parameter(std::uint32_t i) const {
    return program_.statements[i].kind == StatementKind::assign && accesses_[i].sets.size() == 1 &&
           is_parameter_[accesses_[i].sets.front()];
  }

  void forget_all() { std::ranges::fill(now_, kNoValue); }
  void forget_shared() {
    for (Place p = 0; p < places_.count(); ++p)
      if (places_.is_shared(p)) now_[p] = kNoValue;
  }
  void forget_sets_of(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t i = first; i <= last; ++i) {
      for (const Place p : accesses_[i].sets) now_[p] = kNoValue;
      if (accesses_[i].sets_shared) forget_shared();
    }
  }

  [[nodiscard]] std::uint32_t partner_of(std::uint32_t i) const {
    return program_.structures[program_.statements[i].payload].partner;
  }

  // What holds before the statement.
  void enter(std::uint32_t i) {
    if (is_target_[i] || i == facts::section_of(program_, i).first) forget_all();
    switch (program_.statements[i].kind) {
      case StatementKind::while_begin:
      case StatementKind::repeat_begin:
      case StatementKind::for_begin:
      case StatementKind::loop_begin: {
        const std::uint32_t end = partner_of(i);
        if (end == ir::kNoIndex) return forget_all();
        forget_sets_of(i, end);
        return forget_targets(i + 1, end);
      }
      default: return;
    }
  }

  // What holds after it. `now` is what it has become.
  void leave(std::uint32_t i, const ir::Statement& now) {
    const Access& access = accesses_[i];
    const ir::Statement& s = program_.statements[i];
    if (access.sets_shared) forget_shared();
    if (s.kind == StatementKind::assign && access.sets.size() == 1 && access.sets_for_sure)
      set(access.sets.front(), program_.assigns[now.payload].value);
    else
      for (const Place p : access.sets) now_[p] = kNoValue;
    switch (s.kind) {
      case StatementKind::if_begin: branches_.push_back(now_); return;
      case StatementKind::else_begin:
        if (branches_.empty()) return forget_all();
        now_ = branches_.back();
        return;
      case StatementKind::if_end: return join_if(i);
      case StatementKind::while_end:
      case StatementKind::for_end:
      case StatementKind::loop_end:
      case StatementKind::repeat_end: return join_loop(i);
      case StatementKind::go_to:
        // What follows an unconditional jump is reached by its labels alone.
        if (program_.jumps[s.payload].condition == ExpressionId::none) forget_all();
        return;
      default: return;
    }
  }

  void join_if(std::uint32_t i) {
    if (branches_.empty() || partner_of(i) == ir::kNoIndex) return forget_all();
    now_ = std::move(branches_.back());
    branches_.pop_back();
    std::uint32_t begin = partner_of(i);
    if (program_.statements[begin].kind == StatementKind::else_begin) begin = if_of(begin);
    forget_sets_of(begin, i);
    forget_targets(begin, i);
  }
  [[nodiscard]] std::uint32_t if_of(std::uint32_t middle) const {
    for (std::uint32_t i = middle; i-- > 0;)
      if (program_.statements[i].kind == StatementKind::if_begin && partner_of(i) == middle) return i;
    return 0;
  }
  void join_loop(std::uint32_t i) {
    const std::uint32_t begin = partner_of(i);
    if (begin == ir::kNoIndex) return forget_all();
    // Of REPEAT the last round ends here; other loops are left from their heads.
    if (program_.statements[i].kind != StatementKind::repeat_end) forget_sets_of(begin, i);
    forget_targets(begin, i);
  }
  // A part that is entered by a jump as well.
  void forget_targets(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t i = first; i <= last; ++i)
      if (is_target_[i]) return forget_all();
  }

  void set(Place place, ExpressionId value) {
    const PlaceFacts& facts = places_.at(place);
    const bool keeps = facts.is_plain && (facts.type == ir::ValueType::real || passes::is_whole(program_, value));
    if (!keeps || !is_pure(program_, places_, value)) {
      now_[place] = kNoValue;
      return;
    }
    const Value worth = value_of(value);
    now_[place] = worth;
    if (worth >= first_.size()) first_.resize(worth + 1, kNoPlace);
    if (first_[worth] == kNoPlace || now_[first_[worth]] != worth) first_[worth] = place;
  }

  Value value_of(ExpressionId id) {
    const ir::Expression e = program_.at(id);
    if (e.op == Operator::constant) return table_.constant(e.value);
    if (e.op == Operator::variable) {
      const Place place = places_.of(program_.at(e.variable));
      if (place == kNoPlace || !places_.at(place).is_plain) return table_.fresh();
      if (now_[place] == kNoValue) {
        now_[place] = table_.fresh();
        if (now_[place] >= first_.size()) first_.resize(now_[place] + 1, kNoPlace);
        first_[now_[place]] = place;
      }
      return now_[place];
    }
    const Value a = e.a == ExpressionId::none ? kNoValue : value_of(e.a);
    const Value b = e.b == ExpressionId::none ? kNoValue : value_of(e.b);
    const Value c = e.c == ExpressionId::none ? kNoValue : value_of(e.c);
    return table_.computed(e.op, a, b, c);
  }

  [[nodiscard]] ExpressionId known(ExpressionId id) {
    if (!is_pure(program_, places_, id) || mentions_vacant(program_, id)) return id;
    return rebuilt(program_, id, [this](ExpressionId node) { return known_node(node); });
  }

  ExpressionId known_node(ExpressionId node) {
    const Operator op = program_.at(node).op;
    if (op == Operator::constant) return node;
    if (op != Operator::variable) node = simplified(program_, work_.control, arithmetic_, node);
    if (program_.at(node).op == Operator::constant) return node;
    const Value worth = value_of(node);
    const Place own = place_at(program_, places_, node);
    // A parameter stays one, and no other that has the same number takes its place.
    if (const auto number = table_.constant_of(worth); number && own != kNoPlace)
      return is_parameter_[own] || !can_be_written(work_.control, *number) ? node : program_.add_constant(*number);
    const Place holder = worth < first_.size() ? first_[worth] : kNoPlace;
    if (holder == kNoPlace || holder == own || now_[holder] != worth) return node;
    return is_better(holder, own, node) ? read_of(program_, places_.at(holder)) : node;
  }

  [[nodiscard]] bool is_better(Place holder, Place own, ExpressionId node) const {
    const double read = read_cost(work_.cost, places_.at(holder));
    if (own != kNoPlace) return places_.at(own).is_own && read <= read_cost(work_.cost, places_.at(own));
    return read < cost_of(program_, work_.cost, node) || depth_of(program_, node) > 1;
  }

  Work& work_;
  ir::Program& program_;
  interpreter::Arithmetic arithmetic_;
  Places places_;
  std::vector<Access> accesses_;
  std::vector<bool> is_target_;
  std::vector<bool> is_parameter_;  // by place
  ValueTable table_;
  Values now_;                    // by place
  std::vector<Place> first_;      // by value: who got it first
  std::vector<Values> branches_;  // at the IFs around
  bool changed_ = false;
};

}  // namespace

bool propagate_values(Work& work) { return Propagation(work).run(); }

}  // namespace dripfeed::optimize
