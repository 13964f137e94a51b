// Operators that SINUMERIK lacks or that give other values here are written with those that it has:
//   x^n             POT(x), x*x*x …, or EXP(n*LN(x))
//   ATAN[x]         ATAN2(x,1)
//   angle 0…360     a + 360*ROUNDUP(MAXVAL(-a,0)/180), because the last factor is 1 for negative a and 0 otherwise
//   ROUND, FUP of negative numbers, which Fanuc takes away from zero: f(MAXVAL(x,0)) - f(MAXVAL(-x,0))
#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "dialects/ir/axis_letters.h"
#include "dialects/passes/foreign_variables.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/value_facts.h"
#include "dialects/passes/walk.h"
#include "dialects/sinumerik/tables/keywords.h"
#include "dialects/sinumerik/tables/system_variables.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

namespace {

using ir::ExpressionId;
using ir::Operator;

constexpr double kHighestProduct = 6.0;  // x^6 is written as a product, above as EXP and LN

class ExpressionRaiser {
 public:
  explicit ExpressionRaiser(const Raising& raising) : raising_(raising), program_(raising.program) {}

  void run() {
    std::set<std::uint32_t> used;
    for (const ir::Statement& s : program_.statements) {
      passes::for_each_root(
          program_, s,
          [&](ExpressionId& root) {
            passes::for_each_node(program_, root,
                                  [&](ExpressionId id) { used.insert(static_cast<std::uint32_t>(id)); });
          },
          [&](ir::VariableId target) {
            passes::for_each_node(program_, program_.at(target).index,
                                  [&](ExpressionId id) { used.insert(static_cast<std::uint32_t>(id)); });
            system_target(target);
          });
    }
    for (const std::uint32_t id : used) raise(id);
  }

 private:
  ExpressionId constant(double value) { return program_.add_constant(value, {}, false); }
  ExpressionId of(Operator op, ExpressionId a, ExpressionId b = ExpressionId::none) {
    return program_.add_operator(op, a, b);
  }
  // The old node under a new number, so that the node itself can be put around it.
  ExpressionId moved(std::uint32_t id) { return program_.add(ir::Expression(program_.expressions[id])); }
  void become(std::uint32_t id, ExpressionId by) {
    const text::Span span = program_.expressions[id].span;
    program_.expressions[id] = ir::Expression(program_.at(by));
    program_.expressions[id].span = span;
  }

  [[nodiscard]] bool never_negative(ExpressionId id) const { return passes::never_negative(program_, id); }

  // Operators without a row are the same here.
  using Step = void (ExpressionRaiser::*)(std::uint32_t, const ir::Expression&);
  struct Row {
    Operator op;
    Step step;
  };
  static std::span<const Row> rows();

  void raise(std::uint32_t id) {
    const ir::Expression e = program_.expressions[id];
    const auto row = std::ranges::find(rows(), e.op, &Row::op);
    if (row != rows().end()) (this->*row->step)(id, e);
  }

  void refuse(std::uint32_t, const ir::Expression& e) {
    raising_.cannot(passes::of_value(e.op == Operator::vacant ? "an empty value (#0)"
                                     : e.op == Operator::bcd  ? "BCD"
                                                              : "BIN"),
                    e.span);
  }

  void atan(std::uint32_t id, const ir::Expression&) {
    const ExpressionId one = constant(1.0);
    program_.expressions[id].op = Operator::atan2;
    program_.expressions[id].b = one;
  }

  void atan2(std::uint32_t id, const ir::Expression&) {
    if (raising_.from.semantics.atan_full_circle && !raising_.to.semantics.atan_full_circle) full_circle(id, 180.0);
  }

  void asin(std::uint32_t id, const ir::Expression& e) {
    const bool other_range = raising_.from.semantics.asin_from_90_to_270 && !raising_.to.semantics.asin_from_90_to_270;
    if (other_range && !never_negative(e.a)) full_circle(id, 90.0);
  }

  void round(std::uint32_t id, const ir::Expression& e) {
    const ir::Semantics& from = raising_.from.semantics;
    const ir::Semantics& to = raising_.to.semantics;
    const bool same = e.op == Operator::round ? from.round_half == to.round_half : from.round_up == to.round_up;
    if (!same) away_from_zero(id, e);
  }

  void power(std::uint32_t id, const ir::Expression& e) {
    const ir::Expression exponent = program_.at(e.b);
    const bool whole = exponent.op == Operator::constant && exponent.value == std::floor(exponent.value);
    if (whole && exponent.value == 2.0) {
      program_.expressions[id].op = Operator::square;
      program_.expressions[id].b = ExpressionId::none;
    } else if (whole && exponent.value >= 1.0 && exponent.value <= kHighestProduct) {
      ExpressionId product = e.a;
      for (int i = 1; i < static_cast<int>(exponent.value); ++i) product = of(Operator::multiply, product, e.a);
      become(id, product);
    } else {
      become(id, of(Operator::exp, of(Operator::multiply, e.b, of(Operator::ln, e.a))));
    }
  }

  // An angle that is negative here and lies above 180 there.
  void full_circle(std::uint32_t id, double largest_negative) {
    const ExpressionId angle = moved(id);
    const ExpressionId below = of(Operator::maximum, of(Operator::negate, angle), constant(0.0));
    const ExpressionId is_below = of(Operator::round_up, of(Operator::divide, below, constant(largest_negative)));
    become(id, of(Operator::add, angle, of(Operator::multiply, constant(360.0), is_below)));
  }

  void away_from_zero(std::uint32_t id, const ir::Expression& e) {
    if (never_negative(e.a)) return;
    const ExpressionId above = of(Operator::maximum, e.a, constant(0.0));
    const ExpressionId below = of(Operator::maximum, of(Operator::negate, e.a), constant(0.0));
    become(id, of(Operator::subtract, of(e.op, above), of(e.op, below)));
  }

  // #5041 and the like: the position of an axis has a name here.
  void system_variable(std::uint32_t id, const ir::Expression& e) {
    const ir::Variable v = program_.at(e.variable);
    const ir::SystemVariableRow* row = row_of(v);
    const bool parameter = v.bank == ir::Bank::system && v.number == ir::kNoIndex;  // PRM of a '#' control
    if (row == nullptr && (parameter || passes::is_foreign_variable(v, raising_.from)))
      return raising_.cannot(passes::of_value("the variable " + std::string(raising_.text_of(e.span))), e.span);
    if (row == nullptr) return;
    const bool position = row->kind == ir::SystemValue::end_position || row->kind == ir::SystemValue::machine_position;
    const std::uint32_t axis = v.number - row->first;
    if (!position || row->first == 0 || axis >= raising_.from.axes.size()) {
      return raising_.cannot(passes::of_value("the variable " + std::string(raising_.text_of(e.span))), e.span);
    }
    ir::Variable own;
    own.bank = ir::Bank::system;
    own.number = find_system_variable(row->kind == ir::SystemValue::end_position ? "$P_EP" : "$AA_IM");
    own.index = constant(static_cast<double>(ir::kAxisLetters.find(raising_.from.axes[axis])));
    program_.expressions[id].variable = program_.add(own);
  }

  void system_target(ir::VariableId target) {
    const ir::Variable v = program_.at(target);
    if (row_of(v) != nullptr || passes::is_foreign_variable(v, raising_.from))
      raising_.cannot(passes::of_value("the variable " + std::string(raising_.text_of(v.span))), v.span);
  }

  // The row of a system variable of the control that the program is from. One that goes by its name where that control
  // has numbers was put there when the program was raised.
  [[nodiscard]] const ir::SystemVariableRow* row_of(const ir::Variable& v) const {
    const auto rows = raising_.from.system_variables;
    if (v.bank == ir::Bank::system)
      return v.number < rows.size() && !rows[v.number].name.empty() ? &rows[v.number] : nullptr;
    if (v.bank != ir::Bank::hash || v.index != ExpressionId::none) return nullptr;
    const auto row = std::ranges::find_if(rows, [&](const ir::SystemVariableRow& r) {
      return r.first != 0 && r.first <= v.number && v.number <= r.last;
    });
    return row == rows.end() ? nullptr : &*row;
  }

  const Raising& raising_;
  ir::Program& program_;
};

std::span<const ExpressionRaiser::Row> ExpressionRaiser::rows() {
  static constexpr Row kRows[] = {
      {Operator::vacant, &ExpressionRaiser::refuse}, {Operator::bcd, &ExpressionRaiser::refuse},
      {Operator::bin, &ExpressionRaiser::refuse},    {Operator::variable, &ExpressionRaiser::system_variable},
      {Operator::power, &ExpressionRaiser::power},   {Operator::atan, &ExpressionRaiser::atan},
      {Operator::atan2, &ExpressionRaiser::atan2},   {Operator::asin, &ExpressionRaiser::asin},
      {Operator::round, &ExpressionRaiser::round},   {Operator::round_up, &ExpressionRaiser::round},
  };
  return kRows;
}

}  // namespace

void raise_expressions(const Raising& raising) { ExpressionRaiser(raising).run(); }

}  // namespace dripfeed::sinumerik
