// From the steps back to the declarations: what nothing names is not in the program.
#include "dialects/family/build_names.h"

#include <algorithm>

#include "dialects/family/evaluate.h"

namespace dripfeed::family {

using ir::ExpressionId;
using ir::Operator;

std::size_t skip_branch(const std::vector<Step>& steps, std::size_t at) {
  std::size_t depth = 0;
  for (++at;; ++at) {
    const StepKind kind = steps[at].kind;
    if (depth == 0 && kind == StepKind::if_else) return at;
    if (depth == 0 && kind == StepKind::if_end) return at - 1;
    if (kind == StepKind::if_begin) ++depth;
    if (kind == StepKind::if_end) --depth;
  }
}

BuildNames::BuildNames(const BoundFamily& bound)
    : bound_(bound),
      family_(*bound.family),
      fixed_(family_.arena.symbols.size()),
      needed_(family_.arena.symbols.size()) {
  find_fixed();
  find_needed();
  find_whole_counters();
}

// Outer loops stand before inner ones. A name that counts two loops is whole only where both are.
void BuildNames::find_whole_counters() {
  std::set<ir::SymbolId> others;
  std::size_t before = 0;
  do {
    before = others.size();
    whole_counters_.clear();
    for (const Step& step : family_.steps) {
      const bool assigns = step.kind == StepKind::let || step.kind == StepKind::set;
      if (assigns || step.kind == StepKind::for_in_begin || (step.kind == StepKind::for_begin && !counts_whole(step)))
        others.insert(step.target);
      if (step.kind == StepKind::for_begin && !others.contains(step.target)) whole_counters_.insert(step.target);
    }
    std::erase_if(whole_counters_, [&](ir::SymbolId one) { return others.contains(one); });
  } while (others.size() != before);
}

bool BuildNames::counts_whole(const Step& loop) const {
  const ir::Expression& by = family_.arena.at(loop.values[2]);
  return by.op == Operator::constant && by.value == 1.0 && is_always_whole(loop.values[0]) &&
         is_always_whole(loop.values[1]);
}

void BuildNames::find_fixed() {
  const auto fix = [this](ir::SymbolId symbol) { fixed_[static_cast<std::size_t>(symbol)] = 1; };
  for (const Parameter& one : family_.parameters)
    if (one.kind == ParameterKind::choice || one.kind == ParameterKind::yes_no || one.kind == ParameterKind::tool)
      fix(one.symbol);
  for (const Definition& one : family_.definitions)
    if (one.is_constant) fix(one.symbol);
  for (const List& one : family_.lists) fix(one.count);
  for (const OffsetContour& contour : family_.offsets)
    for (const OffsetContour::Item& one : contour.items)
      for (const ir::SymbolId symbol : {one.corner, one.direction})
        if (symbol != ir::SymbolId::none) fix(symbol);
}

void BuildNames::need(ExpressionId id) {
  if (id == ExpressionId::none) return;
  const ir::Expression& e = family_.arena.at(id);
  const int operands = ir::operand_count(e.op);
  if (operands > 0) need(e.a);
  if (operands > 1) need(e.b);
  if (e.op != Operator::variable) return;
  const ir::Variable& v = family_.arena.at(e.variable);
  need(v.index);
  need(v.symbol);
}

void BuildNames::need(const Step& step) {
  // The shape of a tool is for the checks, and a message is a text when it is written.
  if (step.kind == StepKind::tool || step.kind == StepKind::message || step.kind == StepKind::require) return;
  if (step.kind == StepKind::cylinder_begin) return;  // its diameter is a number in the text
  for (const ExpressionId value : step.values) need(value);
  for (std::uint32_t i = 0; i < step.word_count; ++i) {
    const StepWord& word = family_.words[step.first_word + i];
    if (step.kind != StepKind::drill_begin || !is_number_of_cycle(word.address)) need(word.value);
  }
  if (step.kind == StepKind::for_in_begin) need(family_.lists[static_cast<std::size_t>(step.number)].symbol);
  if (step.kind != StepKind::set) return;
  need(step.target);  // a list's other numbers stay as they are
  set_.insert(step.target);
}

void BuildNames::need_numbers(const List& list) {
  if (!is_needed(list.symbol)) return;
  for (const ExpressionId element : list.elements) need(element);
}

// What stands in a branch that is decided against is not in the program.
void BuildNames::need_steps() {
  std::vector<bool> decided;  // of open `if`s
  for (std::size_t at = 0; at < family_.steps.size(); ++at) {
    const Step& step = family_.steps[at];
    if (step.kind == StepKind::if_begin) {
      decided.push_back(is_decided(step.values[0]));
      if (decided.back() && evaluate(family_.arena, step.values[0], bound_.values).value == 0.0)
        at = skip_branch(family_.steps, at);
      else if (!decided.back())
        need(step);
    } else if (step.kind == StepKind::if_else && decided.back()) {
      at = skip_branch(family_.steps, at);
    } else {
      if (step.kind == StepKind::if_end) decided.pop_back();
      need(step);
    }
  }
}

void BuildNames::find_needed() {
  need_steps();
  // What stands lower uses what stands above.
  auto list = family_.lists.rbegin();
  for (auto one = family_.definitions.rbegin(); one != family_.definitions.rend(); ++one) {
    for (; list != family_.lists.rend() && list->line > one->line; ++list) need_numbers(*list);
    if (is_needed(one->symbol)) need(one->value);
  }
  for (; list != family_.lists.rend(); ++list) need_numbers(*list);
}

bool BuildNames::is_decided(ExpressionId id) const {
  const ir::Expression& e = family_.arena.at(id);
  const int operands = ir::operand_count(e.op);
  if (operands > 0) return is_decided(e.a) && (operands == 1 || is_decided(e.b));
  return e.op == Operator::constant || (e.op == Operator::variable && is_fixed(family_.arena.at(e.variable).symbol));
}

bool BuildNames::is_always_whole(ExpressionId id) const {
  const ir::Expression& e = family_.arena.at(id);
  if (e.op == Operator::constant) return is_whole(e.value);
  if (e.op == Operator::negate) return is_always_whole(e.a);
  if (e.op == Operator::add || e.op == Operator::subtract || e.op == Operator::multiply)
    return is_always_whole(e.a) && is_always_whole(e.b);
  if (e.op != Operator::variable) return false;
  const ir::SymbolId symbol = family_.arena.at(e.variable).symbol;
  if (is_fixed(symbol)) return is_whole(value_of(symbol));
  if (whole_counters_.contains(symbol)) return true;
  if (const List* list = family_.find_list(symbol); list != nullptr && list->counts_chords) return true;
  const auto parameter = std::ranges::find(family_.parameters, symbol, &Parameter::symbol);
  return parameter != family_.parameters.end() && parameter->kind == ParameterKind::number && parameter->whole;
}

}  // namespace dripfeed::family
