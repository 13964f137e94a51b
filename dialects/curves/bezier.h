// Rational Bezier curves: the pieces that every NURBS curve consists of, and curves of their own.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "dialects/curves/arc.h"
#include "dialects/curves/parametric_curve.h"
#include "dialects/curves/point.h"

namespace dripfeed::curves {

// A point times its weight, and the weight.
struct WeightedPoint {
  Point point;
  double weight = 1.0;

  friend constexpr WeightedPoint operator+(WeightedPoint a, WeightedPoint b) {
    return {a.point + b.point, a.weight + b.weight};
  }
  friend constexpr WeightedPoint operator*(double k, WeightedPoint a) { return {k * a.point, k * a.weight}; }
};

// One piece over a range of t; all weights > 0.
struct BezierPiece {
  static constexpr std::size_t kMostPoints = 16;

  Range t;
  std::size_t count = 0;  // points: degree + 1, at least 2
  std::array<WeightedPoint, kMostPoints> points{};

  // Value and derivatives by t, which lies within the range.
  [[nodiscard]] ParametricPoint at(double t_at) const;
  // The same curve between two values of t.
  [[nodiscard]] BezierPiece part(double t_low, double t_high) const;
  // A box of all second derivatives: differences of the control points enclose the derivatives of numerator and
  // denominator (convex hull), and interval arithmetic does the rest. Infinite where it cannot be bounded.
  [[nodiscard]] Box second_derivatives(double t_low, double t_high) const;
};

}  // namespace dripfeed::curves
