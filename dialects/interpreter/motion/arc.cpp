// The centre of an arc by radius: of the two on the chord's perpendicular bisector, a short counterclockwise arc takes
// the one to the left of the path, a short clockwise arc the one to the right, long arcs the other one.
//
//            centre (left)
//              |
//   start -----+----- end
#include "dialects/interpreter/motion/arc.h"

#include <algorithm>
#include <numbers>

#include "dialects/interpreter/arithmetic/arithmetic.h"

namespace dripfeed::interpreter {

std::optional<PlanePoint> center_by_radius(PlanePoint chord, double radius, Turn turn, double tolerance) {
  const double length = length_of(chord);
  const double half = length / 2.0;
  const double r = std::abs(radius);
  if (length == 0.0 || half - r > tolerance) return std::nullopt;
  const double height = std::sqrt(std::max(0.0, (r - half) * (r + half)));
  const bool left = (turn == Turn::counterclockwise) == (radius > 0.0);
  const double along = (left ? height : -height) / length;
  return PlanePoint{chord.p / 2.0 - along * chord.q, chord.q / 2.0 + along * chord.p};
}

std::optional<double> radius_by_opening(double chord_length, double opening_deg) {
  if (opening_deg <= 0.0 || opening_deg >= 360.0 || chord_length == 0.0) return std::nullopt;
  const double radius = chord_length / (2.0 * sine_deg(opening_deg / 2.0));
  return opening_deg > 180.0 ? -radius : radius;
}

PlanePoint end_by_opening(PlanePoint center, double opening_deg, Turn turn) {
  const double cosine = cosine_deg(opening_deg);
  const double sine = turn == Turn::counterclockwise ? sine_deg(opening_deg) : -sine_deg(opening_deg);
  // The start seen from the centre, turned, and back to the start.
  const PlanePoint from_center{-center.p, -center.q};
  return {center.p + from_center.p * cosine - from_center.q * sine,
          center.q + from_center.p * sine + from_center.q * cosine};
}

double opening_of(PlanePoint center, PlanePoint chord, Turn turn) {
  const double begin = std::atan2(-center.q, -center.p);
  const double end = std::atan2(chord.q - center.q, chord.p - center.p);
  double angle = (turn == Turn::counterclockwise ? end - begin : begin - end) * 180.0 / std::numbers::pi;
  if (chord.p == 0.0 && chord.q == 0.0) return 360.0;
  while (angle <= 0.0) angle += 360.0;
  return angle;
}

}  // namespace dripfeed::interpreter
