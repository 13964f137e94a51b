// A piece of a circle, from an angle through a signed sweep, counterclockwise positive.
#pragma once

#include <cstdint>

#include "dialects/curves/point.h"

namespace dripfeed::curves {

enum class Turn : std::uint8_t { clockwise, counterclockwise };

struct Arc {
  Point center;
  double radius = 0.0;       // > 0
  double start_angle = 0.0;  // rad, from +z towards +x
  double sweep = 0.0;        // rad, -2π..2π

  [[nodiscard]] double length() const { return radius * std::fabs(sweep); }
  // t in 0..1.
  [[nodiscard]] Point at(double t) const;
  // Unit vector in which the arc is run through at t.
  [[nodiscard]] Point direction(double t) const;
};

// The arc as programs give it: from `start` to `end` around `center`. The radius is the mean of both distances; start
// and end that are less than 1e-9 mm apart make a full circle.
Arc arc_between(Point start, Point end, Point center, Turn turn);

// Parameter in 0..1 of the point of the arc that is nearest to `point`.
double closest_parameter(const Arc& arc, Point point);
double distance(const Arc& arc, Point point);

// Smallest and largest z and x that the arc reaches.
struct Box {
  Range z;
  Range x;
};
Box box_of(const Arc& arc);

}  // namespace dripfeed::curves
