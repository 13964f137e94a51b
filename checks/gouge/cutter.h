// The lower side of a mill: flat, ball or bull nose, around its axis.
#pragma once

#include <cmath>

namespace dripfeed::gouge {

//     flat             bull              ball
//    |     |          |     |          |     |
//    |     |          |     |          |     |      corner: of the rounding at the edge, 0 to radius
//    |_____|          (_____)           ' . '
//
struct Cutter {
  double radius = 0.0;  // mm, > 0
  double corner = 0.0;

  // Height of the lower side above the tip at a distance from the axis, which is at most the radius.
  [[nodiscard]] double rise(double distance) const {
    const double beyond = distance - (radius - corner);
    if (!(beyond > 0.0) || !(corner > 0.0)) return 0.0;
    return corner - std::sqrt(std::fmax(0.0, corner * corner - beyond * beyond));
  }
  // Smaller on all sides by `by`: its tip then stands higher by as much.
  [[nodiscard]] Cutter shrunk(double by) const {
    return {std::fmax(0.0, radius - by), std::fmin(std::fmax(0.0, corner - by), std::fmax(0.0, radius - by))};
  }
  friend bool operator==(const Cutter&, const Cutter&) = default;
};

}  // namespace dripfeed::gouge
