// A straight piece between two points.
#pragma once

#include "dialects/curves/point.h"

namespace dripfeed::curves {

struct Segment {
  Point a;
  Point b;

  [[nodiscard]] double length() const { return curves::distance(a, b); }
  // t in 0..1; the ends are exact.
  [[nodiscard]] Point at(double t) const { return t >= 1.0 ? b : a + t * (b - a); }
  [[nodiscard]] Point direction() const { return unit(b - a); }
};

// Parameter in 0..1 of the point of the segment that is nearest to `point`; 0 for a segment without length.
double closest_parameter(const Segment& segment, Point point);
double distance(const Segment& segment, Point point);

}  // namespace dripfeed::curves
