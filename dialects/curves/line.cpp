// The foot of a perpendicular, held between the ends.
#include "dialects/curves/line.h"

#include <algorithm>

namespace dripfeed::curves {

double closest_parameter(const Segment& segment, Point point) {
  const Point along = segment.b - segment.a;
  const double square = dot(along, along);
  return square > 0.0 ? std::clamp(dot(point - segment.a, along) / square, 0.0, 1.0) : 0.0;
}

double distance(const Segment& segment, Point point) {
  return distance(segment.at(closest_parameter(segment, point)), point);
}

}  // namespace dripfeed::curves
