// NURBS curves: control points, weights and knots, turned into rational Bezier pieces once and evaluated from those.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dialects/curves/bezier.h"
#include "dialects/curves/parametric_curve.h"
#include "dialects/curves/point.h"

namespace dripfeed::curves {

struct Nurbs {
  std::size_t order = 4;  // degree + 1, 2 to BezierPiece::kMostPoints
  std::vector<Point> points;
  std::vector<double> weights;  // empty: all 1
  std::vector<double> knots;    // points + order of them; empty: clamped and uniform, 0 to points - order + 1
};

// The knots 0 (order times), 1, 2, …, and the last one order times.
std::vector<double> clamped_knots(std::size_t points, std::size_t order);

// What is wrong with the knots of so many points, in one sentence; empty for nothing.
std::string fault_of_knots(const std::vector<double>& knots, std::size_t points, std::size_t order);

// What is wrong with it, in one sentence; empty when it is a curve.
std::string fault_of(const Nurbs& nurbs);

// The pieces between distinct knots (Boehm's knot insertion), from knot order-1 to the last but order-1; never empty
// for a curve without fault.
std::vector<BezierPiece> pieces_of(const Nurbs& nurbs);

// The whole curve; its breaks are the inner knots. `nurbs` must have no fault.
ParametricCurve curve_of(const Nurbs& nurbs);

}  // namespace dripfeed::curves
