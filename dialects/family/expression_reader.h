// Expressions of the family language: read, checked for dimensions, and kept as nodes of the arena in stored units.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "dialects/family/cursor.h"
#include "dialects/family/scope.h"
#include "dialects/family/unit.h"
#include "dialects/ir/program.h"

namespace dripfeed::family {

// What an expression is: its node and dimension. After a fault `id` is none; readers check Cursor::line_failed.
struct Typed {
  ir::ExpressionId id = ir::ExpressionId::none;
  Dimension dimension;
  bool is_condition = false;
  bool is_bare = false;  // made of numbers without unit only
  text::Span span;
};

class ExpressionReader {
 public:
  ExpressionReader(Cursor& cursor, const Scope& scope, ir::Program& arena)
      : cursor_(cursor), scope_(scope), arena_(arena) {}

  // A value of any dimension.
  Typed value();
  // A value of that dimension, a fault otherwise.
  Typed value_of(Dimension dimension);
  // A comparison or several joined.
  Typed condition();
  // A number with the unit after it, sign allowed; nothing after a fault.
  struct Literal {
    double written = 0.0;
    const Unit* unit = nullptr;
    text::Span span;
  };
  std::optional<Literal> literal(bool unit_allowed);

  // The variable `z` of a nominal; none: z is no name here.
  void set_free_variable(ir::SymbolId symbol) { free_variable_ = symbol; }

  // A fault unless `typed` has the dimension: missing unit for a bare number (with the fix), else wrong unit.
  bool require_dimension(const Typed& typed, Dimension wanted);

 private:
  Typed disjunction();
  Typed conjunction();
  Typed negation();
  Typed comparison();
  Typed sum();
  Typed product();
  Typed sign();
  Typed power();
  Typed primary();
  Typed number();
  Typed name();
  Typed function();
  Typed logic(ir::Operator op, const Typed& a, const Typed& b);
  Typed scaled(Typed typed, double factor);
  Typed combine(ir::Operator op, const Typed& a, const Typed& b);
  bool same_dimension(const Typed& a, const Typed& b);
  void wrong_unit(const Typed& typed, std::string wanted);
  bool is_value(const Typed& typed);
  [[nodiscard]] const Unit* unit_here(std::size_t& lexemes) const;
  Typed constant(double stored, Dimension dimension, text::Span span);

  Cursor& cursor_;
  const Scope& scope_;
  ir::Program& arena_;
  ir::SymbolId free_variable_ = ir::SymbolId::none;
};

}  // namespace dripfeed::family
