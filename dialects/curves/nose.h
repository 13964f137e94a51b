// The surface that a round nose leaves when it is led along a path without compensation. The path is that of the
// imaginary tip; the nose's centre lies next to it; what is cut is the line at the nose's radius from the centre's
// path, on the side of the material.
#pragma once

#include <cstdint>
#include <optional>

#include "dialects/curves/path.h"
#include "dialects/curves/point.h"

namespace dripfeed::curves {

// A nose of radius 0 cuts where its tip is.
struct Nose {
  double radius = 0.0;  // mm
  Point tip;            // from the centre to the imaginary tip in radii: {-1, -1} is tip 3, {0, 0} the centre itself

  [[nodiscard]] Point center(Point tip_at) const { return tip_at - radius * tip; }
};

// The tip of a tool's quadrant number 0..9 as in checks' tables: 1 {+1,+1}, 2 {-1,+1}, 3 {-1,-1}, 4 {+1,-1},
// 5 {+1,0}, 6 {0,+1}, 7 {-1,0}, 8 {0,-1}, 0 and 9 {0,0}; in z and x. Nothing for another number.
std::optional<Point> tip_of(int quadrant);

// Unit normal of a direction that points into the material: downwards (-x); for a path straight along x to the side
// where the tip is, -z when it has none.
Point into_material(const Nose& nose, Point direction);

// The cut surface of one piece of the tip's path. Nothing for an arc that is tighter than the nose on its hollow side:
// there the nose cuts its own end points' circles only.
std::optional<PathPiece> cut_surface(const Nose& nose, const PathPiece& tip_path);

// How two pieces of cut surface meet at the end of one and the start of the next.
//
//        gap: the path turns away from the material        overlap: it turns towards it
//             ____ . C                                          \   C   /   each runs on below
//            /    / \   the nose rounds the corner               \_/ \_/    where the other has
//        ___/    (___)  with its own circle                      _____X_    cut already: both are
//                                                                           trimmed at X
struct Corner {
  Point center;         // of the nose
  Point normal_before;  // into the material, unit
  Point normal_after;
  double trimmed = 0.0;  // mm that each piece loses at the overlap; 0 at a gap
  bool is_gap = false;
};
Corner corner_of(const Nose& nose, Point tip_at, Point direction_before, Point direction_after);

}  // namespace dripfeed::curves
