// The nominal keeps the family alive that its expression stands in.
#include "dialects/family/geometry.h"

#include <algorithm>
#include <utility>

#include "dialects/family/evaluate.h"
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
  const ir::SymbolId z = bound.family->nominal_variable;
  curves::ProfilePiece out;
  out.tolerance = value_of(bound, shape.tolerance);
  out.curve.z = range(bound, shape.z);
  out.curve.at = [family = bound.family, values = bound.values, z, x = shape.x, scale](double z_mm) {
    std::vector<double> here = values;
    here[static_cast<std::size_t>(z)] = z_mm;
    const Dual at = evaluate(family->arena, x, here, z);
    return curves::ExplicitPoint{scale * at.value, scale * at.slope};
  };
  out.curve.second_derivatives = [family = bound.family, values = bound.values, z, x = shape.x, scale](double low,
                                                                                                       double high) {
    const Range second = second_derivative(family->arena, x, values, z, {low, high});
    return Range{scale * second.low, scale * second.high};
  };
  return out;
}

std::vector<ToolShape> tools(const Family& family) {
  std::vector<ToolShape> out;
  for (const Step& step : family.steps) {
    if (step.kind != StepKind::tool || std::ranges::find(out, step.number, &ToolShape::number) != out.end()) continue;
    out.push_back({step.number, step.nose_radius_mm, step.tip});
  }
  return out;
}

}  // namespace

Geometry geometry(const BoundFamily& bound) {
  Geometry out;
  if (bound.family->stock) out.stock = stock(bound, *bound.family->stock);
  for (const NominalShape& shape : bound.family->nominals) out.nominal.pieces.push_back(piece(bound, shape));
  std::ranges::sort(out.nominal.pieces, {}, [](const curves::ProfilePiece& p) { return p.curve.z.low; });
  out.tools = tools(*bound.family);
  return out;
}

}  // namespace dripfeed::family
