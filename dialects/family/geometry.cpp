// The nominal keeps the family alive that its expression stands in.
#include "dialects/family/geometry.h"

#include <algorithm>
#include <utility>

#include "dialects/family/evaluate.h"

namespace dripfeed::family {

namespace {

double value_of(const BoundFamily& bound, ir::ExpressionId expression) {
  return expression == ir::ExpressionId::none ? 0.0 : evaluate(bound.family->arena, expression, bound.values).value;
}

Interval interval(const BoundFamily& bound, const ExpressionRange& range) {
  const double a = value_of(bound, range.low);
  const double b = value_of(bound, range.high);
  return a <= b ? Interval{a, b} : Interval{b, a};
}

Stock stock(const BoundFamily& bound, const StockShape& shape) {
  if (shape.kind == StockKind::box) {
    return BoxStock{interval(bound, shape.x), interval(bound, shape.y), interval(bound, shape.z)};
  }
  return CylinderStock{value_of(bound, shape.diameter), value_of(bound, shape.bore), interval(bound, shape.z)};
}

NominalPiece piece(const BoundFamily& bound, const NominalShape& shape) {
  const ir::SymbolId z = bound.family->nominal_variable;
  return {interval(bound, shape.z), value_of(bound, shape.tolerance),
          [family = bound.family, values = bound.values, z, x = shape.x](double z_mm) {
            std::vector<double> here = values;
            here[static_cast<std::size_t>(z)] = z_mm;
            const Dual at = evaluate(family->arena, x, here, z);
            return ProfilePoint{at.value, at.slope};
          }};
}

}  // namespace

Geometry geometry(const BoundFamily& bound) {
  Geometry out;
  out.x_is_diameter = bound.family->x_is_diameter;
  if (bound.family->stock) out.stock = stock(bound, *bound.family->stock);
  for (const NominalShape& shape : bound.family->nominals) out.nominal.push_back(piece(bound, shape));
  for (const Step& step : bound.family->steps) {
    if (step.kind != StepKind::tool ||
        std::ranges::find(out.tools, step.number, &ToolShape::number) != out.tools.end()) {
      continue;
    }
    out.tools.push_back({step.number, step.nose_radius_mm, step.tip});
  }
  return out;
}

}  // namespace dripfeed::family
