// A curve t -> (z, x) over a range of t, given by a function object, and the point of it that is nearest to a given
// one.
#pragma once

#include <functional>

#include "dialects/curves/point.h"

namespace dripfeed::curves {

struct ParametricPoint {
  Point point;
  Point derivative;  // d/dt
  Point second;      // d²/dt²
};

struct ParametricCurve {
  Range t;
  std::function<ParametricPoint(double t)> at;
};

// With sign: positive where the curve turns counterclockwise; 1/mm, 0 where the curve stands still.
double curvature(const ParametricPoint& point);

struct ParametricFoot {
  double t = 0.0;
  Point point;
  double distance = 0.0;  // mm, positive to the left of the direction of t
  bool at_end = false;    // it is an end of the curve
};

// The nearest point: the range is scanned in `pieces`, and the best ones are refined by safeguarded Newton steps. True
// as long as no piece hides two feet; the distance is never below the true one.
ParametricFoot closest(const ParametricCurve& curve, Point point, int pieces = 64);

}  // namespace dripfeed::curves
