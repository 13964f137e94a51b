// A contour as a cut along its travel meets it: what can be reached from in front, level by level, and the relief cuts
// after its heights.
//
//          ____              the travel goes to the right, levels rise upward
//   ______/    \    _____/   front: up to the height, straight on (bridge) to where the contour is as high again
//               \__/         relief: down and up again
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/interpreter/cycles/shape.h"

namespace dripfeed::interpreter {

// A segment with the direction in which its motion turns.
struct ContourPiece {
  ShapeSegment segment;
  bool ccw = false;
};

struct Relief {
  std::vector<ContourPiece> down;  // from the height to the bottom, its floor included
  std::vector<ContourPiece> up;    // to the height again
  [[nodiscard]] ShapePoint begin() const { return down.front().segment.from; }
  [[nodiscard]] ShapePoint end() const { return up.back().segment.to; }
  [[nodiscard]] double bottom_level() const { return down.back().segment.to.level; }
};

struct ContourSections {
  std::vector<ContourPiece> front;
  std::vector<Relief> reliefs;
  std::string not_interpreted;  // why there are none
};

// `rise` is 1 where levels count away from the material, otherwise -1.
ContourSections sections_of(const std::vector<ContourPiece>& contour, double rise);

}  // namespace dripfeed::interpreter
