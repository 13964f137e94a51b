// With w = (z - z0)/B, e = ±1 and s = sqrt(1 + e·w²): f = x0 + A·s, f' = e·A·w/(B·s), f'' = e·A/(B²·s³). The second
// derivative depends on |w| alone and monotonically, which makes its ranges exact.
#include "dialects/curves/conic.h"

#include <algorithm>
#include <cmath>

namespace dripfeed::curves {

namespace {

double sign_of(const Conic& conic) { return conic.kind == ConicKind::hyperbola ? 1.0 : -1.0; }

double root_of(const Conic& conic, double w) { return std::sqrt(std::max(0.0, 1.0 + sign_of(conic) * w * w)); }

}  // namespace

ExplicitPoint Conic::at(double z) const {
  const double w = (z - center.z) / half_axis_z;
  const double s = root_of(*this, w);
  return {center.x + half_axis_x * s, sign_of(*this) * half_axis_x * w / (half_axis_z * s)};
}

double Conic::second_derivative(double z) const {
  const double s = root_of(*this, (z - center.z) / half_axis_z);
  return sign_of(*this) * half_axis_x / (half_axis_z * half_axis_z * s * s * s);
}

Range Conic::second_derivatives(double z_low, double z_high) const {
  const double a = second_derivative(z_low);
  const double b = second_derivative(z_high);
  Range range{std::min(a, b), std::max(a, b)};
  if (z_low < center.z && center.z < z_high) {
    const double top = second_derivative(center.z);
    range = {std::min(range.low, top), std::max(range.high, top)};
  }
  return range;
}

double Conic::curvature(double z) const {
  const double slope = at(z).slope;
  if (!std::isfinite(slope)) {  // the ellipse's end: A²/B³ turned around, B over A squared
    return std::copysign(half_axis_z / (half_axis_x * half_axis_x), second_derivative(center.z));
  }
  const double square = 1.0 + slope * slope;
  return second_derivative(z) / (square * std::sqrt(square));
}

ExplicitCurve curve_of(const Conic& conic, Range z) {
  ExplicitCurve curve{z, [conic](double at) { return conic.at(at); },
                      [conic](double low, double high) { return conic.second_derivatives(low, high); }};
  curve.second_limit = second_limit_of(curve);
  return curve;
}

}  // namespace dripfeed::curves
