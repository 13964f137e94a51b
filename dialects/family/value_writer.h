// A family's expressions in its program. They are copied node by node, because passes rewrite a statement's expression
// in place; minimum and maximum, which not every control has, become an assignment and an IF before the statement, and
// an interpolation the search for its two points.
#pragma once

#include <optional>
#include <string_view>

#include "dialects/family/build_names.h"
#include "dialects/family/emitter.h"

namespace dripfeed::family {

class ValueWriter {
 public:
  ValueWriter(const BoundFamily& bound, const BuildNames& names, ir::Program& program, Emitter& emit)
      : family_(*bound.family), names_(names), program_(program), emit_(emit) {}

  // A copy; what must be computed before is emitted meanwhile.
  ir::ExpressionId copy(ir::ExpressionId id);
  // Whether that would emit statements.
  [[nodiscard]] bool needs_statements(ir::ExpressionId id) const;
  // target = value
  void assign(ir::SymbolId target, ir::ExpressionId id);

  // Of expressions of the program: a op b, without what changes nothing: 0 + x, x - 0, 1*x, x/1; and 360/6 as 60,
  // where the decimals stay few.
  ir::ExpressionId calculate(ir::Operator op, ir::ExpressionId a, ir::ExpressionId b);
  // The value of a number; nothing for what the control computes.
  [[nodiscard]] std::optional<double> number(ir::ExpressionId id) const;
  // A number without a decimal point: an index.
  ir::ExpressionId whole(double value) { return program_.add_constant(value, {}, false); }

  // What a value is named by: itself when it is a number or a name that stays, otherwise a variable that is computed
  // once.
  struct Bound {
    ir::SymbolId symbol = ir::SymbolId::none;
    double value = 0.0;  // of a number; of a list's: its index
    bool is_of_list = false;
  };
  Bound bound(ir::ExpressionId id, std::string_view stem);
  ir::ExpressionId say(const Bound& bound);

 private:
  ir::ExpressionId copy_variable(const ir::Variable& v);
  ir::ExpressionId interpolate(const ir::Expression& along);
  void limit(ir::SymbolId value, ir::Operator beyond, ir::SymbolId list, double index);
  ir::ExpressionId negated(ir::ExpressionId id);
  // What a value is the negative of, where it is written so.
  std::optional<ir::ExpressionId> negative(ir::ExpressionId id);
  ir::ExpressionId choose(ir::Operator op, ir::ExpressionId a, ir::ExpressionId b);

  const Family& family_;
  const BuildNames& names_;
  ir::Program& program_;
  Emitter& emit_;
};

}  // namespace dripfeed::family
