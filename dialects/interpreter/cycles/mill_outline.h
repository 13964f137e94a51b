// The path of a tool's centre along a rectangle with rounded corners, inside or outside of it, around its centre:
//
//       .-----------.         half_length and half_width of the path; a corner of 0 is sharp. Around from the middle
//      /             \        of the side at +x.
//     |       +       o  ->
//      \             /
//       '-----------'
#pragma once

#include "dialects/interpreter/cycles/mill_tool.h"

namespace dripfeed::interpreter {

struct MillOutline {
  double half_length = 0.0;
  double half_width = 0.0;
  double corner = 0.0;

  // The path that lies inside by that distance.
  [[nodiscard]] MillOutline inside(double by_mm) const;
  [[nodiscard]] PlanePoint start() const { return {half_length, 0.0}; }
  // Of the two, and how far the middle is from the path at most.
  [[nodiscard]] double smaller_half() const { return half_width < half_length ? half_width : half_length; }
};

// The tool stands at the start and comes back to it.
void cut_around(const MillOutline& outline, Turn turn, double feed, MillTool& tool);

}  // namespace dripfeed::interpreter
