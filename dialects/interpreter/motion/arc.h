// Arcs in their plane: the centre from a radius or an opening angle, the end from a centre and an angle. Coordinates
// are (p, q), the plane's axes in right-handed order: G17 X Y, G18 Z X, G19 Y Z. Radius geometry, any unit.
#pragma once

#include <cmath>
#include <optional>

namespace dripfeed::interpreter {

struct PlanePoint {
  double p = 0.0;
  double q = 0.0;
};
inline double length_of(PlanePoint v) { return std::hypot(v.p, v.q); }

enum class Turn : unsigned char { clockwise, counterclockwise };

// Centre minus start of the arc over `chord` (end minus start) with that radius; a negative radius takes the longer
// path. Nothing when the chord is longer than the diameter by more than twice the tolerance, or has no length.
std::optional<PlanePoint> center_by_radius(PlanePoint chord, double radius, Turn turn, double tolerance);

// Radius (with sign, as above) of an arc over that chord that opens by an angle of 0 to 360 degrees, both excluded.
std::optional<double> radius_by_opening(double chord_length, double opening_deg);

// End minus start of an arc that turns by `opening_deg` about a centre given as centre minus start.
PlanePoint end_by_opening(PlanePoint center, double opening_deg, Turn turn);

// Angle in degrees that the arc turns by, above 0 and up to 360: a full circle when end and start agree.
double opening_of(PlanePoint center, PlanePoint chord, Turn turn);

}  // namespace dripfeed::interpreter
