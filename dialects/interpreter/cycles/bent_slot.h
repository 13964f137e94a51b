// The path of a tool's centre in a slot that lies on a circle, around the circle's centre. The slot's middle runs from
// angle 0 counterclockwise; its ends are half circles around the first and the last point of the middle. One of 360
// degrees is a ring.
#pragma once

#include "dialects/interpreter/cycles/mill_tool.h"

namespace dripfeed::interpreter {

struct BentSlot {
  double radius = 0.0;     // of the middle
  double angle_deg = 0.0;  // along the middle
  double off = 0.0;        // of the path from the middle

  [[nodiscard]] bool is_ring() const { return angle_deg >= 360.0; }
  [[nodiscard]] PlanePoint middle() const { return {radius, 0.0}; }
  [[nodiscard]] PlanePoint start() const { return {radius + off, 0.0}; }
};

// Along the middle and back; the tool stands at its first point.
void cut_along(const BentSlot& slot, double feed, MillTool& tool);

// The tool stands at the start and comes back to it. Of a ring, around the outside and around the inside.
void cut_around(const BentSlot& slot, Turn turn, double feed, MillTool& tool);

}  // namespace dripfeed::interpreter
