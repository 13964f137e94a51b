// How far a path runs from a profile: extremes with their positions, and integrals along the path for mean and mean
// square.
#pragma once

#include <algorithm>
#include <cstdint>

#include "dialects/curves/path.h"
#include "dialects/curves/profile.h"

namespace dripfeed::curves {

struct Extreme {
  double value = 0.0;      // mm, signed: positive above the profile
  Point at;                // on the path
  double tolerance = 0.0;  // of the profile there
};

// Of one piece of path. Without any point on the profile, `points` is 0 and the extremes say nothing.
struct Deviation {
  std::uint32_t points = 0;  // points that were measured on the profile
  Extreme highest;
  Extreme lowest;
  double length = 0.0;           // mm of path on the profile
  double integral = 0.0;         // of |deviation| along it, mm²
  double integral_square = 0.0;  // mm³
  double overhang = 0.0;         // farthest reach beyond the profile's ends, mm
  Range z;                       // of the feet on the profile
  ProfileFoot first;             // of both ends of the piece
  ProfileFoot last;

  [[nodiscard]] double largest() const { return std::max(highest.value, -lowest.value); }
};

// Measures at equal steps along the piece, at least 3, from a quarter of a millimetre on 5, and one a millimetre (at
// most 129), integrates by Simpson's rule, and refines the extremes by parabolas where they could pass `refine_above`
// in size (0: always). On a piece whose deviation has one top and no bend between two steps, the extreme is good to
// about 1e-3 of itself or better.
Deviation measure(const Profile& profile, const PathPiece& piece, double refine_above = 0.0);

// One place alone: no length.
Deviation measure(const Profile& profile, Point point);

}  // namespace dripfeed::curves
