// Expressions of the family language: read, checked for dimensions, and kept as nodes of the arena in stored units.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dialects/family/cursor.h"
#include "dialects/family/model.h"
#include "dialects/family/scope.h"
#include "dialects/family/unit.h"
#include "dialects/ir/program.h"

namespace dripfeed::family {

inline constexpr std::uint32_t kLargestTree = 2000;  // nodes; powers and functions multiply them

// What an expression is: its node and dimension. After a fault the id may be none; readers check Cursor::line_failed.
struct Typed {
  ir::ExpressionId id = ir::ExpressionId::none;
  Dimension dimension = {};
  bool is_condition = false;
  bool is_bare = false;    // made of numbers without unit only
  std::uint32_t size = 1;  // nodes of its tree
  text::Span span = {};
};

// A number as written, with its unit.
struct Literal {
  double written = 0.0;
  const Unit* unit = nullptr;  // nullptr: none was written
  text::Span span = {};
};

// The expression itself: reading stands in expression_reader.cpp, numbers and names in operand_reader.cpp, functions in
// function_reader.cpp.
class ExpressionReader {
 public:
  ExpressionReader(Cursor& cursor, Scope& scope, Family& family)
      : cursor_(cursor), scope_(scope), family_(family), arena_(family.arena) {}

  // A value of any dimension.
  Typed value();
  // A value of that dimension, a fault otherwise.
  Typed value_of(Dimension dimension);
  // A comparison or several joined.
  Typed condition();
  // Either of them.
  Typed value_or_condition() { return disjunction(); }
  // The unit that stands here; nullptr, and nothing taken, where none does.
  const Unit* unit();
  // A number with the unit after it, sign allowed; nothing after a fault.
  std::optional<Literal> literal(bool unit_allowed);

  // Axis letters that are lengths in what is read next: those of a nominal. None: they are not names.
  struct AxisVariable {
    std::string_view word;
    ir::SymbolId symbol = ir::SymbolId::none;
  };
  void set_axis_variables(std::vector<AxisVariable> variables) { axis_variables_ = std::move(variables); }

  // "name[" index "]" of a list, or "name" alone of another name: where a value can be put. Nothing after a fault.
  struct Place {
    Scope::Name name;
    ir::ExpressionId index = ir::ExpressionId::none;
  };
  std::optional<Place> place();

  // A fault unless `typed` has the dimension: missing unit for a bare number (with the fix), else wrong unit.
  bool require_dimension(const Typed& typed, Dimension wanted);

 private:
  // Nested brackets, signs and functions go down the stack: this counts them.
  class Depth {
   public:
    explicit Depth(ExpressionReader& reader);
    ~Depth() { --depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    int& depth_;
  };

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
  Typed known_name(const Scope::Name& known, ir::Variable variable);
  Typed choice(const Scope::Name& known, ir::Variable variable);
  Typed unknown_name(std::string_view word, text::Span span);
  ir::ExpressionId index_of(const Scope::Name& list);
  Typed function();
  Typed count();
  Typed interpolate(text::Span span);
  const Scope::Name* list_name();
  Typed built_in(std::string_view name, text::Span span);
  Typed user_function(const UserFunction& function, text::Span span);
  std::vector<Typed> arguments(std::size_t count);
  bool function_dimension(std::string_view name, const Typed& a, const Typed& b, Dimension& out);
  Typed constant(double stored, Dimension dimension, text::Span span);

  // A node over its operands: spans joined, sizes added, bare when all are.
  Typed make(ir::Operator op, std::initializer_list<Typed> operands, Dimension dimension);
  Typed product_of(ir::Operator op, const Typed& a, const Typed& b);
  Typed scaled(const Typed& typed, double factor);
  bool same_dimension(const Typed& a, const Typed& b);
  bool is_condition(const Typed& typed);
  bool is_value(const Typed& typed);
  void wrong_unit(const Typed& typed, std::string wanted);
  [[nodiscard]] const Unit* unit_here(std::size_t& lexemes) const;

  Cursor& cursor_;
  Scope& scope_;
  Family& family_;
  ir::Program& arena_;
  std::vector<AxisVariable> axis_variables_;
  int depth_ = 0;
};

}  // namespace dripfeed::family
