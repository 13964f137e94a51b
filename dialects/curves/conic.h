// Hyperbolas and ellipses with their axes along z and x, as curves x = f(z):
//   hyperbola  x = x0 + A·sqrt(1 + ((z - z0)/B)²)
//   ellipse    x = x0 + A·sqrt(1 - ((z - z0)/B)²),  |z - z0| <= B
// A negative A gives the branch below the centre. Derivatives and their ranges are in closed form.
#pragma once

#include <cstdint>

#include "dialects/curves/explicit_curve.h"
#include "dialects/curves/point.h"

namespace dripfeed::curves {

enum class ConicKind : std::uint8_t { hyperbola, ellipse };

struct Conic {
  ConicKind kind = ConicKind::hyperbola;
  double half_axis_x = 0.0;  // A, mm
  double half_axis_z = 0.0;  // B, mm, > 0
  Point center;              // z0, x0

  // Beyond the ellipse's ends x is that of the end; the slope at an end is infinite.
  [[nodiscard]] ExplicitPoint at(double z) const;
  // d²x/dz², 1/mm
  [[nodiscard]] double second_derivative(double z) const;
  // Exact range of the second derivative between two places, low <= high.
  [[nodiscard]] Range second_derivatives(double z_low, double z_high) const;
  // Curvature with sign of the second derivative, 1/mm.
  [[nodiscard]] double curvature(double z) const;
};

ExplicitCurve curve_of(const Conic& conic, Range z);

}  // namespace dripfeed::curves
