// Stock, nominal and tools of a bound family as plain data, in mm: what the checks of accuracy and gouge measure
// against.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dialects/curves/height_field.h"
#include "dialects/curves/parametric_curve.h"
#include "dialects/curves/profile.h"
#include "dialects/family/bind.h"

namespace dripfeed::family {

// Around the z axis of the active work offset.
struct CylinderStock {
  double diameter_mm = 0.0;
  double bore_mm = 0.0;  // diameter; 0: solid
  curves::Range z_mm;
};
struct BoxStock {
  curves::Range x_mm, y_mm, z_mm;
};
using Stock = std::variant<CylinderStock, BoxStock>;

// A tool as the body names it, for the checks that need its nose.
struct ToolShape {
  std::int32_t number = 0;
  double nose_radius_mm = 0.0;  // 0: not given
  std::int32_t tip = 0;         // imaginary tip 0 to 9
  double diameter_mm = 0.0;     // 0: not given
  double corner_radius_mm = 0.0;
};

// A nominal curve of the x-y plane; its points' z is the plane's x, their x its y.
struct PlaneCurve {
  curves::ParametricCurve curve;
  double tolerance_mm = 0.0;
  bool of_center = false;  // of the tool's centre
};

struct Geometry {
  ir::MachineKind machine = ir::MachineKind::mill;  // that the family is for
  std::optional<Stock> stock;
  // x = f(z), x as radius, pieces in the order of z; empty when the family has none. Slopes are exact and second
  // derivatives are enclosed. The functions are pure and may be called from several threads.
  curves::Profile nominal;
  std::vector<curves::HeightField> surfaces;  // in the order of the family
  std::vector<PlaneCurve> curves;
  std::vector<ToolShape> tools;  // in the order of the body, each number once
};

Geometry geometry(const BoundFamily& bound);

// What is wrong with the points, weights and knots of a curve with these values; empty for none.
std::string fault_of(const BoundFamily& bound, const CurveShape& shape);
std::string fault_of(const BoundFamily& bound, const NurbsSurfaceShape& shape);

}  // namespace dripfeed::family
