// A curve t -> (z, x) over a range of t, given by a function object, and the point of it that is nearest to a given
// one.
#pragma once

#include <functional>
#include <vector>

#include "dialects/curves/arc.h"
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
  // A box that holds every second derivative between two values of t with no break strictly between them: what chord
  // bounds are proved from. May be empty: then nothing is proved.
  std::function<Box(double t_low, double t_high)> second_derivatives = {};
  // The same, wider, and found sooner: what is known of a larger part. May be empty.
  std::function<Box(double t_low, double t_high)> wide_second_derivatives = {};
  // Inner values of t at which the derivatives may jump, in order.
  std::vector<double> breaks = {};
};

// With sign: positive where the curve turns counterclockwise; 1/mm, 0 where the curve stands still.
double curvature(const ParametricPoint& point);

struct ParametricFoot {
  double t = 0.0;
  Point point;
  double distance = 0.0;  // mm, positive to the left of the direction of t
  bool at_end = false;    // it is an end of the curve
  double overhang = 0.0;  // mm along the end's tangent, where the point lies beyond an end
  bool settled = true;    // no Newton step would lead further
};

// The nearest point: the range is scanned in `pieces`, and the best ones are refined by safeguarded Newton steps. True
// as long as no piece hides two feet; the distance is never below the true one.
ParametricFoot closest(const ParametricCurve& curve, Point point, int pieces = 64);

// The foot that Newton's steps reach from `t_near`: that of a path which is followed from place to place. At most a
// curve's own bend away from the nearest point; its distance is never below the true one, and may be far above it where
// the foot is not settled.
ParametricFoot closest_from(const ParametricCurve& curve, Point point, double t_near);

}  // namespace dripfeed::curves
