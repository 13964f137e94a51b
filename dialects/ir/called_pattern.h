// The holes of a pattern that is called by name with numbers: a row, or a circle.
#pragma once

#include <optional>
#include <vector>

#include "dialects/ir/called_cycle.h"

namespace dripfeed::ir {

// In the program's unit, along the first and the second axis of the plane.
struct PlanePoint {
  double first = 0.0;
  double second = 0.0;
};

struct CalledPattern {
  PlanePoint origin;  // of the row, or the circle's centre
  double angle_deg = 0.0;
  double start = 0.0;  // distance from the origin to the first hole of a row
  double step = 0.0;   // distance, or degrees
  double radius = 0.0;
  double count = 0.0;
  bool is_circle = false;
};

// Nothing where the call is of no row or circle, or a value is computed; what is left out is 0.
std::optional<CalledPattern> called_pattern(const Program& program, const Call& call);

// In the order in which they are made. A row begins at the end that is nearer to `from` (PGZ, "Row of holes - HOLES1"):
// nothing where that is not known and matters. `count` must be at least 1.
std::optional<std::vector<PlanePoint>> holes_of(const CalledPattern& pattern, std::optional<PlanePoint> from);

}  // namespace dripfeed::ir
