// Clockwise is counterclockwise with y mirrored.
#include "dialects/interpreter/cycles/mill_outline.h"

#include <algorithm>

namespace dripfeed::interpreter {

MillOutline MillOutline::inside(double by_mm) const {
  return {std::max(0.0, half_length - by_mm), std::max(0.0, half_width - by_mm), std::max(0.0, corner - by_mm)};
}

void cut_around(const MillOutline& outline, Turn turn, double feed, MillTool& tool) {
  const double side = turn == Turn::counterclockwise ? 1.0 : -1.0;
  const double x = outline.half_length;
  const double y = outline.half_width * side;
  const double c = outline.corner;
  const double cy = c * side;
  tool.cut({x, y - cy}, feed);
  tool.arc({x - c, y}, {x - c, y - cy}, turn, feed);
  tool.cut({c - x, y}, feed);
  tool.arc({-x, y - cy}, {c - x, y - cy}, turn, feed);
  tool.cut({-x, cy - y}, feed);
  tool.arc({c - x, -y}, {c - x, cy - y}, turn, feed);
  tool.cut({x - c, -y}, feed);
  tool.arc({x, cy - y}, {x - c, cy - y}, turn, feed);
  tool.cut({x, 0.0}, feed);
}

}  // namespace dripfeed::interpreter
