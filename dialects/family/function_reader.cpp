// Functions in expressions. Those of the language are a table: what their arguments must be and what they give. The
// value of a family's own function stands, with the arguments in it, where the function is used.
#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/evaluate.h"
#include "dialects/family/expression_reader.h"

namespace dripfeed::family {

namespace {

using ir::Operator;

enum class Rule : std::uint8_t { angle_to_ratio, ratio_to_angle, ratio_to_ratio, root, same, legs_to_angle };
struct FunctionRow {
  std::string_view name;
  Operator op;
  int arguments;
  Rule rule;
};
constexpr auto kFunctions = std::to_array<FunctionRow>({
    {"sin", Operator::sin, 1, Rule::angle_to_ratio},
    {"cos", Operator::cos, 1, Rule::angle_to_ratio},
    {"tan", Operator::tan, 1, Rule::angle_to_ratio},
    {"asin", Operator::asin, 1, Rule::ratio_to_angle},
    {"acos", Operator::acos, 1, Rule::ratio_to_angle},
    {"atan", Operator::atan, 1, Rule::ratio_to_angle},
    {"atan2", Operator::atan2, 2, Rule::legs_to_angle},
    {"sqrt", Operator::sqrt, 1, Rule::root},
    {"abs", Operator::abs, 1, Rule::same},
    {"min", Operator::minimum, 2, Rule::same},
    {"max", Operator::maximum, 2, Rule::same},
    {"round", Operator::round, 1, Rule::ratio_to_ratio},
    {"trunc", Operator::truncate, 1, Rule::ratio_to_ratio},
    {"ln", Operator::ln, 1, Rule::ratio_to_ratio},
    {"exp", Operator::exp, 1, Rule::ratio_to_ratio},
    {"radians", Operator::multiply, 1, Rule::angle_to_ratio},  // by pi/180
});

const FunctionRow* find_function(std::string_view name) {
  const auto row = std::ranges::find(kFunctions, name, &FunctionRow::name);
  return row == kFunctions.end() ? nullptr : &*row;
}

constexpr std::int8_t half(std::int8_t exponent) { return static_cast<std::int8_t>(exponent / 2); }

constexpr std::string_view kCount = "count";
constexpr std::string_view kInterpolate = "interpolate";
constexpr std::uint32_t kInterpolationSize = 30;  // nodes, as the control computes it

// Copies of a tree in its own arena with expressions in place of symbols. What was one node stays one: a power
// multiplies a node with itself.
class Substitution {
 public:
  Substitution(ir::Program& arena, std::map<ir::SymbolId, ir::ExpressionId> by) : arena_(arena), by_(std::move(by)) {}

  ir::ExpressionId of(ir::ExpressionId id) {
    if (const auto known = made_.find(id); known != made_.end()) return known->second;
    const ir::ExpressionId made = copy(id);
    made_.emplace(id, made);
    return made;
  }

 private:
  ir::ExpressionId copy(ir::ExpressionId id) {
    const ir::Expression e = arena_.at(id);
    const int operands = ir::operand_count(e.op);
    if (operands > 0) {
      const ir::ExpressionId a = of(e.a);
      return arena_.add_operator(e.op, a, operands > 1 ? of(e.b) : ir::ExpressionId::none, e.span);
    }
    if (e.op != Operator::variable) return id;
    ir::Variable v = arena_.at(e.variable);
    if (const auto argument = by_.find(v.symbol); argument != by_.end()) return argument->second;
    if (v.index == ir::ExpressionId::none) return id;
    v.index = of(v.index);
    return arena_.add_variable(v);
  }

  ir::Program& arena_;
  std::map<ir::SymbolId, ir::ExpressionId> by_;
  std::map<ir::ExpressionId, ir::ExpressionId> made_;
};

}  // namespace

Typed ExpressionReader::function() {
  const text::Span at = cursor_.peek().span;
  const std::string name(cursor_.word());
  const UserFunction* own = family_.find_function(name);
  if (name != kCount && name != kInterpolate && own == nullptr && find_function(name) == nullptr) {
    cursor_.report(text::DiagnosticId::family_unknown_name, at, {name});
    return {.span = at};
  }
  const Depth depth(*this);
  cursor_.advance();
  cursor_.expect_symbol("(");
  if (cursor_.line_failed()) return {.span = at};
  Typed out = name == kCount         ? count()
              : name == kInterpolate ? interpolate(at)
              : own != nullptr       ? user_function(*own, at)
                                     : built_in(name, at);
  out.span = {at.begin, cursor_.last_span().end};
  return out;
}

// Up to and with the closing bracket; fewer after a fault.
std::vector<Typed> ExpressionReader::arguments(std::size_t count) {
  std::vector<Typed> out;
  for (std::size_t i = 0; i < count && !cursor_.line_failed(); ++i) {
    if (i > 0) cursor_.expect_symbol(",");
    if (!cursor_.line_failed()) out.push_back(sum());
    if (!cursor_.line_failed() && !is_value(out.back())) return out;
  }
  cursor_.expect_symbol(")");
  return out;
}

// The list whose name stands here, without an index; nullptr, and a fault, where none does. The cursor stays.
const Scope::Name* ExpressionReader::list_name() {
  const Scope::Name* known = cursor_.peek().kind == LexemeKind::word ? scope_.find(cursor_.word()) : nullptr;
  if (known != nullptr && known->kind == NameKind::list) return known;
  cursor_.expected("the name of a list");
  return nullptr;
}

// interpolate(xs, ys, x)
Typed ExpressionReader::interpolate(text::Span span) {
  Typed out{.size = kInterpolationSize, .span = span};
  ir::ExpressionId lists[2] = {ir::ExpressionId::none, ir::ExpressionId::none};
  Dimension dimensions[2];
  for (int i = 0; i < 2; ++i) {
    const Scope::Name* list = list_name();
    if (list == nullptr) return out;
    ir::Variable variable;
    variable.bank = ir::Bank::named;
    variable.symbol = list->symbol;
    variable.span = cursor_.peek().span;
    dimensions[i] = list->dimension;
    lists[i] = arena_.add_variable(variable);
    cursor_.advance();
    cursor_.expect_symbol(",");
    if (cursor_.line_failed()) return out;
  }
  const Typed x = sum();
  if (!is_value(x) || !require_dimension(x, dimensions[0])) return out;
  cursor_.expect_symbol(")");
  if (cursor_.line_failed()) return out;
  const text::Span whole{span.begin, cursor_.last_span().end};
  out.size += x.size;
  out.dimension = dimensions[1];
  out.id = arena_.add_operator(kAlong, x.id, arena_.add_operator(kPoints, lists[0], lists[1], whole), whole);
  return out;
}

// count(list): how many numbers or points it has.
Typed ExpressionReader::count() {
  const PointParameter* points = family_.find_points(cursor_.word());
  const Scope::Name* known = points == nullptr ? list_name() : nullptr;
  if (known == nullptr && points == nullptr) return {};
  ir::Variable variable;
  variable.bank = ir::Bank::named;
  variable.symbol =
      family_.find_list(points == nullptr ? known->symbol : family_.parameters[points->first].symbol)->count;
  variable.span = cursor_.peek().span;
  cursor_.advance();
  cursor_.expect_symbol(")");
  return {.id = arena_.add_variable(variable), .dimension = kRatio};
}

Typed ExpressionReader::user_function(const UserFunction& function, text::Span span) {
  Typed out{
      .dimension = function.dimension, .is_condition = function.is_condition, .size = function.size, .span = span};
  const std::vector<Typed> given = arguments(function.parameters.size());
  std::map<ir::SymbolId, ir::ExpressionId> by;
  for (std::size_t i = 0; i < given.size() && !cursor_.line_failed(); ++i) {
    if (!require_dimension(given[i], function.parameters[i].dimension)) return out;
    by.emplace(function.parameters[i].symbol, given[i].id);
    out.size += given[i].size * function.parameters[i].uses;
  }
  if (cursor_.line_failed()) return out;
  if (out.size > kLargestTree) {
    cursor_.syntax(span, "the expression is too long");
    return out;
  }
  out.id = Substitution(arena_, std::move(by)).of(function.value);
  return out;
}

Typed ExpressionReader::built_in(std::string_view name, text::Span span) {
  const FunctionRow& row = *find_function(name);
  const std::vector<Typed> given = arguments(static_cast<std::size_t>(row.arguments));
  Typed out{.span = span};
  if (cursor_.line_failed() || !function_dimension(row.name, given.front(), given.back(), out.dimension)) return out;
  if (row.name == "radians") {
    out = scaled(given.front(), std::numbers::pi / 180.0);
    out.dimension = kRatio;
    return out;
  }
  return row.arguments == 1 ? make(row.op, {given[0]}, out.dimension)
                            : make(row.op, {given[0], given[1]}, out.dimension);
}

bool ExpressionReader::function_dimension(std::string_view name, const Typed& a, const Typed& b, Dimension& out) {
  switch (find_function(name)->rule) {
    case Rule::angle_to_ratio: out = kRatio; return require_dimension(a, kAngle);
    case Rule::ratio_to_angle: out = kAngle; return require_dimension(a, kRatio);
    case Rule::ratio_to_ratio: out = kRatio; return require_dimension(a, kRatio);
    case Rule::same: out = a.dimension; return same_dimension(a, b);
    case Rule::legs_to_angle: out = kAngle; return same_dimension(a, b);
    case Rule::root: break;
  }
  const Dimension d = a.dimension;
  out = {half(d.length), half(d.angle), half(d.time), half(d.revolution), half(d.surface)};
  if (out + out == d && time_scale(d) == 1.0 && time_scale(out) == 1.0) return true;
  wrong_unit(a, "something that has a square root");
  return false;
}

}  // namespace dripfeed::family
