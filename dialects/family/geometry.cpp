// The nominal keeps the family alive that its expression stands in.
#include "dialects/family/geometry.h"

#include <algorithm>
#include <utility>

#include "dialects/curves/nurbs.h"
#include "dialects/curves/nurbs_surface.h"
#include "dialects/family/evaluate.h"
#include "dialects/family/formula.h"
#include "dialects/family/second_derivative.h"

namespace dripfeed::family {

namespace {

using curves::Range;

double value_of(const BoundFamily& bound, ir::ExpressionId expression) {
  return expression == ir::ExpressionId::none ? 0.0 : evaluate(bound.family->arena, expression, bound.values).value;
}

Range range(const BoundFamily& bound, const ExpressionRange& expressions) {
  const double a = value_of(bound, expressions.low);
  const double b = value_of(bound, expressions.high);
  return a <= b ? Range{a, b} : Range{b, a};
}

Stock stock(const BoundFamily& bound, const StockShape& shape) {
  if (shape.kind == StockKind::box) {
    return BoxStock{range(bound, shape.x), range(bound, shape.y), range(bound, shape.z)};
  }
  return CylinderStock{value_of(bound, shape.diameter), value_of(bound, shape.bore), range(bound, shape.z)};
}

// The expression is in x as the machine has it; curves are in radius.
curves::ProfilePiece piece(const BoundFamily& bound, const NominalShape& shape) {
  const double scale = bound.family->x_is_diameter ? 0.5 : 1.0;
  const ir::SymbolId z = bound.family->z_variable;
  curves::ProfilePiece out;
  out.tolerance = value_of(bound, shape.tolerance);
  out.curve.z = range(bound, shape.z);
  out.curve.at = [x = Formula(bound.family->arena, shape.x, bound.values, z), scale](double z_mm) {
    const Dual at = x.at(z_mm);
    return curves::ExplicitPoint{scale * at.value, scale * at.slope};
  };
  out.curve.second_derivatives = [family = bound.family, values = bound.values, z, x = shape.x, scale](double low,
                                                                                                       double high) {
    const Range second = second_derivative(family->arena, x, values, z, {low, high});
    return Range{scale * second.low, scale * second.high};
  };
  out.curve.second_limit = curves::second_limit_of(out.curve);
  return out;
}

curves::HeightField surface(const BoundFamily& bound, const SurfaceShape& shape) {
  const Family& family = *bound.family;
  const auto of_x = [&](ir::ExpressionId id) { return Formula(family.arena, id, bound.values, family.x_variable); };
  curves::HeightField out;
  out.x = range(bound, shape.x);
  // A square root of less than nothing at the very rim: no surface there.
  out.y = [low = of_x(shape.y.low), high = of_x(shape.y.high)](double x) {
    return Range{low.at(x).value, high.at(x).value};
  };
  out.z = [z = Formula(family.arena, shape.z, bound.values, family.x_variable, family.y_variable)](double x, double y) {
    return z.at(x, y).value;
  };
  out.tolerance = value_of(bound, shape.tolerance);
  return out;
}

std::span<const double> numbers_of(const BoundFamily& bound, ir::SymbolId list) {
  return list == ir::SymbolId::none ? std::span<const double>() : list_in(bound.values, list);
}

// Lists of points of two lengths leave a surface without points, which is a fault.
curves::NurbsSurface nurbs_surface(const BoundFamily& bound, const NurbsSurfaceShape& shape) {
  const auto copy = [&](ir::SymbolId list) {
    const std::span<const double> numbers = numbers_of(bound, list);
    return std::vector<double>(numbers.begin(), numbers.end());
  };
  curves::NurbsSurface out;
  out.order = static_cast<std::size_t>(shape.order);
  const double row = value_of(bound, shape.row);
  out.row = row >= 1.0 ? static_cast<std::size_t>(row) : 0;
  out.weights = copy(shape.weight_list);
  out.knots_u = copy(shape.knot_u_list);
  out.knots_v = copy(shape.knot_v_list);
  const std::span<const double> x = numbers_of(bound, shape.x_list);
  const std::span<const double> y = numbers_of(bound, shape.y_list);
  const std::span<const double> z = numbers_of(bound, shape.z_list);
  if (x.size() != y.size() || y.size() != z.size()) return out;
  for (std::size_t i = 0; i < x.size(); ++i) out.points.push_back({x[i], y[i], z[i]});
  return out;
}

// Later ones are carved into earlier ones, whichever kind they are of.
std::vector<curves::HeightField> surfaces(const BoundFamily& bound) {
  std::vector<std::pair<std::uint32_t, curves::HeightField>> by_line;
  for (const SurfaceShape& shape : bound.family->surfaces) by_line.emplace_back(shape.line, surface(bound, shape));
  for (const NurbsSurfaceShape& shape : bound.family->nurbs_surfaces)
    if (fault_of(bound, shape).empty())
      by_line.emplace_back(shape.line,
                           curves::heights_of(nurbs_surface(bound, shape), value_of(bound, shape.tolerance)));
  std::ranges::sort(by_line, {}, &std::pair<std::uint32_t, curves::HeightField>::first);
  std::vector<curves::HeightField> out;
  out.reserve(by_line.size());
  for (auto& [line, field] : by_line) out.push_back(std::move(field));
  return out;
}

// The points, weights and knots that are given as lists. Lists of two lengths leave an empty curve, which is a fault.
void add_lists(const BoundFamily& bound, const CurveShape& shape, curves::Nurbs& out) {
  const auto numbers = [&](ir::SymbolId list) { return numbers_of(bound, list); };
  const std::span<const double> x = numbers(shape.x_list);
  const std::span<const double> y = numbers(shape.y_list);
  const std::span<const double> weight = numbers(shape.weight_list);
  if (x.size() != y.size() || (!weight.empty() && weight.size() != x.size())) return;
  for (std::size_t i = 0; i < x.size(); ++i) {
    out.points.push_back({x[i], y[i]});
    out.weights.push_back(weight.empty() ? 1.0 : weight[i]);
  }
  const std::span<const double> knots = numbers(shape.knot_list);
  out.knots.insert(out.knots.end(), knots.begin(), knots.end());
}

// Bezier curves have an order of their points, and knots 0 and 1.
curves::Nurbs nurbs(const BoundFamily& bound, const CurveShape& shape) {
  curves::Nurbs out;
  for (const CurvePoint& point : shape.points) {
    out.points.push_back({value_of(bound, point.x), value_of(bound, point.y)});
    out.weights.push_back(point.weight == ir::ExpressionId::none ? 1.0 : value_of(bound, point.weight));
  }
  for (const ir::ExpressionId knot : shape.knots) out.knots.push_back(value_of(bound, knot));
  add_lists(bound, shape, out);
  out.order = shape.order == 0 ? out.points.size() : static_cast<std::size_t>(shape.order);
  return out;
}

// The derivatives of both formulas; the second one from its enclosure, which is exact at a place.
curves::ParametricCurve formula_curve(const BoundFamily& bound, const CurveShape& shape) {
  const auto of_t = [&](ir::ExpressionId id) {
    return Formula(bound.family->arena, id, bound.values, shape.parameter);
  };
  const auto second = [family = bound.family, values = bound.values, shape](double low, double high) {
    const auto of = [&](ir::ExpressionId id) {
      return second_derivative(family->arena, id, values, shape.parameter, {low, high});
    };
    return curves::Box{of(shape.x), of(shape.y)};
  };
  curves::ParametricCurve out;
  out.t = range(bound, shape.t);
  out.at = [x = of_t(shape.x), y = of_t(shape.y), second](double t) {
    const Dual at_x = x.at(t);
    const Dual at_y = y.at(t);
    const curves::Box here = second(t, t);
    const auto middle = [](Range a) { return 0.5 * (a.low + a.high); };
    return curves::ParametricPoint{
        {at_x.value, at_y.value}, {at_x.slope, at_y.slope}, {middle(here.z), middle(here.x)}};
  };
  out.second_derivatives = second;
  return out;
}

PlaneCurve plane_curve(const BoundFamily& bound, const CurveShape& shape) {
  const bool by_formula = shape.parameter != ir::SymbolId::none;
  return {by_formula ? formula_curve(bound, shape) : curves::curve_of(nurbs(bound, shape)),
          value_of(bound, shape.tolerance), shape.of_center};
}

std::vector<ToolShape> tools(const BoundFamily& bound) {
  std::vector<ToolShape> out;
  for (const Step& step : bound.family->steps) {
    if (step.kind != StepKind::tool) continue;
    const std::int32_t number = tool_number(bound, step);
    if (number == 0 && !step.text.empty()) continue;  // by a name, and no machine is known
    if (std::ranges::find(out, number, &ToolShape::number) != out.end()) continue;
    out.push_back({number, value_of(bound, step.values[2]), step.tip, value_of(bound, step.values[0]),
                   value_of(bound, step.values[1])});
  }
  return out;
}

}  // namespace

std::string fault_of(const BoundFamily& bound, const CurveShape& shape) {
  if (shape.parameter == ir::SymbolId::none) return curves::fault_of(nurbs(bound, shape));
  return range(bound, shape.t).width() > 0.0 ? "" : "the curve's parameter has no range";
}

std::string fault_of(const BoundFamily& bound, const NurbsSurfaceShape& shape) {
  return curves::fault_of(nurbs_surface(bound, shape));
}

Geometry geometry(const BoundFamily& bound) {
  Geometry out;
  out.machine = bound.family->machine;
  if (bound.family->stock) out.stock = stock(bound, *bound.family->stock);
  for (const NominalShape& shape : bound.family->nominals) out.nominal.pieces.push_back(piece(bound, shape));
  std::ranges::sort(out.nominal.pieces, {}, [](const curves::ProfilePiece& p) { return p.curve.z.low; });
  out.surfaces = surfaces(bound);
  for (const CurveShape& shape : bound.family->curves) {
    if (fault_of(bound, shape).empty()) out.curves.push_back(plane_curve(bound, shape));
  }
  out.tools = tools(bound);
  return out;
}

}  // namespace dripfeed::family
