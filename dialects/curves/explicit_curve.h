// A curve x = f(z) over a range of z, given by a function object, and the point of it that is nearest to a given one.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "dialects/curves/point.h"

namespace dripfeed::curves {

struct ExplicitPoint {
  double x = 0.0;      // mm, a radius on lathes
  double slope = 0.0;  // dx/dz
};

struct ExplicitCurve {
  Range z;
  std::function<ExplicitPoint(double z)> at;
  // A range that holds every second derivative, 1/mm, between two places of z: what chord bounds are proved from. May
  // be empty: then nothing is proved.
  std::function<Range(double z_low, double z_high)> second_derivatives = {};
  // No second derivative is larger in size, over the whole range; infinity: not known. Makes feet of near points quick.
  double second_limit = std::numeric_limits<double>::infinity();
};

// The largest of `second_derivatives` over the whole range; infinity without.
double second_limit_of(const ExplicitCurve& curve);

// Which end of the curve a foot lies at, where the point lies beyond it and has no perpendicular.
enum class Beyond : std::uint8_t { none, low, high };

struct Foot {
  double z = 0.0;
  ExplicitPoint curve;    // there
  double distance = 0.0;  // mm, positive above the curve (larger x), negative below
  Beyond beyond = Beyond::none;
  double overhang = 0.0;  // mm along the end's tangent, when beyond

  [[nodiscard]] Point point() const { return {z, curve.x}; }
};

// The nearest point of the whole curve, its distance good to rounding. A curve that bends twice within a 16th of the
// vertical gap may give the nearest point of a neighbouring bend, never a distance below the true one.
Foot closest(const ExplicitCurve& curve, Point point);

}  // namespace dripfeed::curves
