// Bottom up: operands first, then the node itself, then the depth of the whole. A node that has to be computed before
// the statement is replaced by the variable that holds it.
#include "dialects/macro_b/writer/flatten.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "dialects/macro_b/writer/print_expression.h"
#include "dialects/macro_b/writer/tolerance.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/passes/structures.h"
#include "dialects/passes/value_facts.h"
#include "dialects/passes/walk.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

class Flattener {
 public:
  Flattener(ir::Program& program, const ir::Control& from, const ir::Control& to, const Grammar& grammar,
            passes::FreeNumbers& numbers)
      : program_(program), from_(from), to_(to), grammar_(grammar), numbers_(numbers), out_(program) {}

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      index_ = i;
      out_.at(i);
      statement(i);
    }
    out_.finish();
    return std::move(diagnostics_);
  }

 private:
  void statement(std::uint32_t i) {
    const ir::Statement s = program_.statements[i];
    if (s.kind == StatementKind::while_begin) return begin_while(i);
    if (s.kind == StatementKind::while_end) return end_while(i);
    if (s.kind == StatementKind::assign) return assign(s);
    if (s.kind == StatementKind::message || s.kind == StatementKind::alarm) return out_.keep();
    // A condition stands in brackets of its own, and so does a word that is calculated.
    const bool in_word = s.kind == StatementKind::block;
    std::vector<ExpressionId> roots;
    passes::for_each_root(program_, s, [&](ExpressionId id) { roots.push_back(id); }, [](ir::VariableId) {});
    for (ExpressionId& root : roots)
      if (!is_text(root)) root = legal(root, deepest() - 1, in_word);
    auto next = roots.begin();
    passes::for_each_root(program_, s, [&](ExpressionId& id) { id = *next++; }, [](ir::VariableId) {});
    out_.keep();
  }

  [[nodiscard]] std::uint32_t deepest() const {
    return to_.limits.expression_nesting == 0 ? 64 : to_.limits.expression_nesting;
  }

  void assign(const ir::Statement& s) {
    const ir::Assign old = program_.assigns[s.payload];
    const ir::Variable target = program_.at(old.target);
    if (target.index != ExpressionId::none) {
      const ExpressionId index = legal(target.index, deepest() - 1, false);
      program_.variables[static_cast<std::uint32_t>(old.target)].index = index;
    }
    if (is_truth(old.value)) return assign_truth(old);
    if (is_of(target, ir::ValueType::boolean) && !is_switch(old.value)) {
      const ExpressionId value = legal(old.value, deepest() - 1, false);
      return assign_truth({old.target, program_.add_operator(Operator::not_equal, value, program_.add_constant(0.0))});
    }
    const ExpressionId value = legal(whole_for(target, old.value), deepest(), false);
    program_.assigns[s.payload].value = value;
    out_.keep();
  }

  [[nodiscard]] bool is_of(const ir::Variable& v, ir::ValueType type) const {
    return v.bank == ir::Bank::named && v.symbol != ir::SymbolId::none && program_.at(v.symbol).type == type;
  }
  // Already one of a BOOL's two values.
  [[nodiscard]] bool is_switch(ExpressionId id) const {
    const ir::Expression& e = program_.at(id);
    if (e.op == Operator::constant) return e.value == 0.0 || e.value == 1.0;
    return e.op == Operator::variable && is_of(program_.at(e.variable), ir::ValueType::boolean);
  }
  // What an INT takes is rounded when it comes in; variables here have no types.
  ExpressionId whole_for(const ir::Variable& target, ExpressionId value) {
    if (!is_of(target, ir::ValueType::integer) || passes::is_whole(program_, value)) return value;
    return program_.add_operator(Operator::round, value);
  }

  // The truth of a condition as a value: 0, and 1 when it holds.
  void assign_truth(const ir::Assign& old) {
    const ExpressionId condition = legal(old.value, deepest() - 1, false);
    // B=NOT B: the old value is needed until the new one is known.
    const bool reads_itself = reads(condition, program_.at(old.target));
    const ir::Variable truth = reads_itself ? new_variable() : ir::Variable(program_.at(old.target));
    out_.emit_assign(program_.add(truth), program_.add_constant(0.0));
    assign_if(condition, truth, program_.add_constant(1.0));
    if (reads_itself) out_.emit_assign(copy(old.target), program_.add_variable(truth));
  }
  // Any element counts as all of its array or bank.
  [[nodiscard]] bool reads(ExpressionId id, const ir::Variable& target) const {
    bool found = false;
    passes::for_each_node(program_, id, [&](ExpressionId node) {
      const ir::Expression& e = program_.at(node);
      if (e.op != Operator::variable) return;
      const ir::Variable& v = program_.at(e.variable);
      const bool plain = v.index == ExpressionId::none && target.index == ExpressionId::none;
      found |= v.bank == target.bank && v.symbol == target.symbol && (!plain || v.number == target.number);
    });
    return found;
  }
  ir::VariableId copy(ir::VariableId id) { return program_.add(ir::Variable(program_.at(id))); }

  [[nodiscard]] bool is_truth(ExpressionId id) const {
    const Operator op = program_.at(id).op;
    return passes::is_comparison(program_, id) || op == Operator::logic_and || op == Operator::logic_or ||
           op == Operator::logic_not || op == Operator::logic_xor;
  }

  // The variables that a condition needs must be computed again before each pass.
  void begin_while(std::uint32_t i) {
    const ir::Structure head = passes::structure_at(program_, i);
    if (head.condition == ExpressionId::none) return out_.keep();
    if (!needs_variables(head.condition)) {
      const ExpressionId condition = legal(head.condition, deepest() - 1, false);
      program_.structures[program_.statements[i].payload].condition = condition;
      return out_.keep();
    }
    ir::Structure opened;
    opened.loop_number = head.loop_number;
    out_.emit_structure(StatementKind::loop_begin, opened);
    const ExpressionId condition = legal(head.condition, deepest() - 1, false);
    label_after_[i] = numbers_.next();
    out_.emit_jump(passes::jump_to(label_after_[i], passes::negated(program_, condition)));
  }

  void end_while(std::uint32_t i) {
    const ir::Structure tail = passes::structure_at(program_, i);
    const auto after = label_after_.find(tail.partner);
    if (after == label_after_.end()) return out_.keep();
    ir::Structure closed;
    closed.loop_number = tail.loop_number;
    out_.emit_structure(StatementKind::loop_end, closed);
    out_.label_next(after->second);
  }

  [[nodiscard]] bool needs_variables(ExpressionId id) const {
    bool needs = too_deep(id);
    passes::for_each_node(program_, id, [&](ExpressionId node) {
      const Operator op = program_.at(node).op;
      const bool holds_truth =
          ir::operand_count(op) > 0 && takes_values(op) &&
          (is_truth(program_.at(node).a) || (ir::operand_count(op) > 1 && is_truth(program_.at(node).b)));
      needs |= holds_truth || op == Operator::minimum || op == Operator::maximum || op == Operator::bound ||
               turns(op) || rounds_otherwise(program_.at(node));
    });
    return needs;
  }

  // Angles of another range than the target's.
  [[nodiscard]] bool turns(Operator op) const {
    if (op == Operator::atan2) return from_.semantics.atan_full_circle != to_.semantics.atan_full_circle;
    return op == Operator::asin && from_.semantics.asin_from_90_to_270 != to_.semantics.asin_from_90_to_270;
  }

  // Negative numbers, which one control takes away from zero and the other toward the larger.
  [[nodiscard]] bool rounds_otherwise(const ir::Expression& e) const {
    const ir::Semantics& from = from_.semantics;
    const ir::Semantics& to = to_.semantics;
    const bool differs = (e.op == Operator::round && from.round_half != to.round_half) ||
                         (e.op == Operator::round_up && from.round_up != to.round_up);
    return differs && !passes::never_negative(program_, e.a) && !passes::is_whole(program_, e.a);
  }

  ExpressionId legal(ExpressionId id, std::uint32_t budget, bool in_word) {
    return id == ExpressionId::none ? id : parts_within(rewritten(id, in_word), budget);
  }
  // Of a message or the name of a tool; what calculates with one is reported.
  [[nodiscard]] bool is_text(ExpressionId id) const {
    return id != ExpressionId::none && program_.at(id).op == Operator::string;
  }

  // AND and OR will be several jumps: each comparison is looked at by itself.
  ExpressionId parts_within(ExpressionId id, std::uint32_t budget) {
    if (takes_values(program_.at(id).op)) return within(id, budget);
    ir::Expression e = program_.at(id);
    e.a = parts_within(e.a, budget);
    if (ir::operand_count(e.op) == 2) e.b = parts_within(e.b, budget);
    return program_.add(e);
  }
  [[nodiscard]] bool too_deep(ExpressionId id) const {
    const ir::Expression& e = program_.at(id);
    if (takes_values(e.op)) return ExpressionPrinter(program_, grammar_).depth(id) > deepest() - 1;
    return too_deep(e.a) || (ir::operand_count(e.op) == 2 && too_deep(e.b));
  }

  // Copies what changes; what can stay is shared.
  ExpressionId rewritten(ExpressionId id, bool in_word) {
    const ir::Expression old = program_.at(id);
    if (old.op == Operator::variable) {
      ir::Variable v = program_.at(old.variable);
      if (v.index != ExpressionId::none) v.index = rewritten(v.index, in_word);
      if (v.index2 != ExpressionId::none) v.index2 = rewritten(v.index2, in_word);
      program_.variables[static_cast<std::uint32_t>(old.variable)] = v;
      return id;
    }
    ir::Expression e = old;
    if (in_word && is_rounded_to_increment(old)) {
      e.a = program_.add(rounded_operand(old));
      return program_.add(e);
    }
    const int count = ir::operand_count(e.op);
    if (count >= 1) e.a = rewritten(e.a, in_word);
    if (count >= 2) e.b = rewritten(e.b, in_word);
    if (count >= 3) e.c = rewritten(e.c, in_word);
    if (takes_values(e.op)) {
      if (count >= 1) e.a = as_value(e.a);
      if (count >= 2) e.b = as_value(e.b);
    }
    return replaced(e, in_word);
  }

  // Everything but AND, OR, XOR, NOT wants numbers: the truth of a condition is one in a variable only.
  static bool takes_values(Operator op) {
    return op != Operator::logic_and && op != Operator::logic_or && op != Operator::logic_xor &&
           op != Operator::logic_not;
  }
  ExpressionId as_value(ExpressionId id) {
    if (!is_truth(id)) return id;
    const ir::Variable truth = new_variable();
    out_.emit_assign(program_.add(truth), program_.add_constant(0.0));
    assign_if(parts_within(id, deepest() - 1), truth, program_.add_constant(1.0));
    return program_.add_variable(truth);
  }

  // ROUND[x*1000]/1000 is how ROUND of an address is kept; the printer says it as such again.
  [[nodiscard]] bool is_rounded_to_increment(const ir::Expression& e) const {
    if (e.op != Operator::divide || program_.at(e.a).op != Operator::round) return false;
    const ir::Expression& inner = program_.at(program_.at(e.a).a);
    return inner.op == Operator::multiply && program_.at(e.b).op == Operator::constant &&
           program_.at(inner.b).op == Operator::constant && program_.at(inner.b).value == program_.at(e.b).value;
  }
  ir::Expression rounded_operand(const ir::Expression& e) {
    ir::Expression round = program_.at(e.a);
    ir::Expression inner = program_.at(round.a);
    inner.a = rewritten(inner.a, true);
    round.a = program_.add(inner);
    return round;
  }

  ExpressionId replaced(const ir::Expression& e, bool in_word) {
    const auto op = [&](Operator o, ExpressionId a, ExpressionId b = ExpressionId::none) {
      return program_.add_operator(o, a, b, e.span);
    };
    if (e.op == Operator::square) {
      const ExpressionId value = is_leaf(e.a) ? e.a : held(e.a);
      return op(Operator::multiply, value, value);
    }
    // One of the two and not the other: not every one of these controls joins conditions by XOR.
    if (e.op == Operator::logic_xor && from_.dialect != to_.dialect)
      return op(Operator::logic_or, op(Operator::logic_and, e.a, passes::negated(program_, e.b)),
                op(Operator::logic_and, passes::negated(program_, e.a), e.b));
    if (e.op == Operator::integer_divide) return op(Operator::truncate, op(Operator::divide, e.a, e.b));
    if (e.op == Operator::bit_not) return op(Operator::subtract, program_.add_constant(-1.0, e.span), e.a);
    if (e.op == Operator::minimum || e.op == Operator::maximum) return chosen(e.op, e.a, e.b);
    if (e.op == Operator::bound) return chosen(Operator::maximum, e.a, chosen(Operator::minimum, e.b, e.c));
    if (turns(e.op)) return turned(program_.add(e));
    if (rounds_otherwise(e)) return rounded(e);
    if (e.op == Operator::round && in_word) return held(program_.add(e));
    const bool tolerance_lost = from_.semantics.comparison == ir::ComparisonMode::relative &&
                                to_.semantics.comparison == ir::ComparisonMode::exact;
    if (tolerance_lost && passes::opposite_comparison(e.op) != Operator::constant)
      return tolerant_comparison(program_, e);
    const bool logic = e.op == Operator::logic_not;
    if (logic || can_print(grammar_, e.op)) return program_.add(e);
    cannot(e);
    return program_.add_constant(0.0, e.span);
  }

  void cannot(const ir::Expression& e) {
    const std::string_view written = e.span.in(program_.source.text());
    diagnostics_.push_back(passes::diagnose(
        passes::of_value(written.empty() ? fmt::format("the operator in line {}", program_.statements[index_].line)
                                         : std::string(written)),
        program_.statements[index_].span, to_.title));
  }

  [[nodiscard]] bool is_leaf(ExpressionId id) const { return ir::operand_count(program_.at(id).op) == 0; }

  // --- values of their own

  ir::Variable new_variable() {
    ir::Symbol symbol;
    symbol.name = program_.strings.add(fmt::format("value {}", ++made_));
    ir::Variable variable;
    variable.bank = ir::Bank::named;
    variable.symbol = program_.add(symbol);
    return variable;
  }

  ExpressionId held(ExpressionId value) {
    const ir::Variable variable = new_variable();
    out_.emit_assign(program_.add(variable), within(value, deepest()));
    return program_.add_variable(variable);
  }

  void assign_if(ExpressionId condition, const ir::Variable& target, ExpressionId value) {
    ir::Structure head;
    head.condition = condition;
    out_.emit_structure(StatementKind::if_begin, head);
    out_.emit_assign(program_.add(target), value);
    out_.emit_structure(StatementKind::if_end, {});
  }

  ExpressionId chosen(Operator op, ExpressionId a, ExpressionId b) {
    const ir::Variable best = new_variable();
    const ExpressionId other = is_leaf(b) ? b : held(b);
    out_.emit_assign(program_.add(best), within(a, deepest()));
    const Operator compare = op == Operator::minimum ? Operator::less : Operator::greater;
    assign_if(program_.add_operator(compare, other, program_.add_variable(best)), best, other);
    return program_.add_variable(best);
  }

  // Toward the larger number where ROUND and FUP go away from zero:
  //   ROUND(-2.5) is -2:  #2=ROUND[#1]  IF[[#2-#1]EQ-0.5]THEN #2=#2+1
  //   ROUNDUP(-2.3) is -2:  #2=FUP[#1]  IF[#1LT0]THEN #2=FIX[#1]
  ExpressionId rounded(const ir::Expression& e) {
    const ExpressionId value = is_leaf(e.a) ? e.a : held(e.a);
    const ir::Variable result = new_variable();
    out_.emit_assign(program_.add(result), program_.add_operator(e.op, value, ExpressionId::none, e.span));
    const auto again = [&] { return program_.add_variable(result); };
    if (e.op == Operator::round) {
      const ExpressionId moved = program_.add_operator(Operator::subtract, again(), value);
      assign_if(program_.add_operator(Operator::equal, moved, program_.add_constant(-0.5)), result,
                program_.add_operator(Operator::add, again(), program_.add_constant(1.0)));
    } else {
      assign_if(program_.add_operator(Operator::less, value, program_.add_constant(0.0)), result,
                program_.add_operator(Operator::truncate, value));
    }
    return again();
  }

  // -180…180 out of 0…360, or the reverse.
  ExpressionId turned(ExpressionId angle) {
    const ir::Variable result = new_variable();
    out_.emit_assign(program_.add(result), within(angle, deepest()));
    const bool to_full = program_.at(angle).op == Operator::atan2 ? from_.semantics.atan_full_circle
                                                                  : from_.semantics.asin_from_90_to_270;
    const ExpressionId limit = program_.add_constant(to_full ? 0.0 : 180.0);
    const ExpressionId full = program_.add_constant(360.0);
    const ExpressionId outside =
        program_.add_operator(to_full ? Operator::less : Operator::greater, program_.add_variable(result), limit);
    assign_if(outside, result,
              program_.add_operator(to_full ? Operator::add : Operator::subtract, program_.add_variable(result), full));
    return program_.add_variable(result);
  }

  // --- depth

  // Takes the deepest operand out as long as the expression nests too many brackets. A condition is never taken out: it
  // is no value.
  ExpressionId within(ExpressionId id, std::uint32_t budget) {
    for (int pass = 0; pass < kMostPasses && ExpressionPrinter(program_, grammar_).depth(id) > budget; ++pass) {
      id = shallower(id, budget);
    }
    return id;
  }

  ExpressionId shallower(ExpressionId id, std::uint32_t budget) {
    ir::Expression e = program_.at(id);
    ExpressionId* operands[] = {&e.a, &e.b};
    if (e.op == Operator::variable) {
      ir::Variable v = program_.at(e.variable);
      if (v.index == ExpressionId::none) return id;
      v.index = held(v.index);
      return program_.add_variable(v);
    }
    const ExpressionPrinter printer(program_, grammar_);
    ExpressionId* deepest_operand = nullptr;
    for (int i = 0; i < std::min(2, ir::operand_count(e.op)); ++i) {
      if (deepest_operand == nullptr || printer.depth(*operands[i]) > printer.depth(*deepest_operand)) {
        deepest_operand = operands[i];
      }
    }
    if (deepest_operand == nullptr) return id;
    // Go down until what is left fits, so that the part taken out is as large as it may be.
    const std::uint32_t inner = printer.depth(*deepest_operand);
    const bool take = !is_truth(*deepest_operand) && inner <= deepest();
    *deepest_operand =
        take && !is_leaf(*deepest_operand) ? held(*deepest_operand) : shallower(*deepest_operand, budget);
    return program_.add(e);
  }

  static constexpr int kMostPasses = 64;

  ir::Program& program_;
  const ir::Control& from_;
  const ir::Control& to_;
  const Grammar& grammar_;
  passes::FreeNumbers& numbers_;
  passes::Rewrite out_;
  std::vector<text::Diagnostic> diagnostics_;
  std::unordered_map<std::uint32_t, std::uint32_t> label_after_;  // lowered WHILE -> label after its end
  std::uint32_t index_ = 0;
  std::uint32_t made_ = 0;
};

}  // namespace

std::vector<text::Diagnostic> flatten_expressions(ir::Program& program, const ir::Control& from, const ir::Control& to,
                                                  const Grammar& grammar, passes::FreeNumbers& numbers) {
  return Flattener(program, from, to, grammar, numbers).run();
}

}  // namespace dripfeed::macro_b
