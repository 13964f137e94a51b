// A milling cycle that is called with values, as what it does, whatever the control calls it: a form at each of its
// places, cut down to a depth. A dialect's table makes it of a call's values; the motions are the interpreter's
// (dialects/interpreter/cycles/milling.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace dripfeed::ir {

// Each lies with its length along the first axis of the plane, turned by the angle of its place.
enum class MillShape : std::uint8_t {
  pocket,     // a rectangle with rounded corners is emptied; a circle or a slot is one by its radius
  spigot,     // … is left standing, and cut around once at each depth
  long_hole,  // as wide as the tool: there and back along its middle
  bent_slot,  // a slot on a circle around its place, from the place's angle counterclockwise, is emptied
  face,       // a rectangle is faced by straight cuts that go beyond it
  path,       // the tool's centre goes along a contour that the program states
};
// Which side of the tool cuts, or the sense in which it goes around.
enum class MillDirection : std::uint8_t { climb, conventional, clockwise, counterclockwise };
// How the tool comes to its next depth inside of a pocket.
enum class MillEntry : std::uint8_t { rapid, straight, helix, oscillation };
// Of a face: along which axis its cuts lie, and whether they are cut in both directions.
enum class FaceCuts : std::uint8_t { first, second, first_to_and_fro, second_to_and_fro };

// How the tool comes to a path at its depth, and leaves it. straight: along the tangent.
enum class MillApproach : std::uint8_t { straight, vertical };
// Where it goes after a path, before the next depth.
enum class MillLift : std::uint8_t { return_level, in_front, clearance, none };

// Where one stands: its centre in the plane of the program, and its length's angle to the first axis.
struct MillPlace {
  double first = 0.0;
  double second = 0.0;
  double angle_deg = 0.0;
};

// Lengths in mm; levels are programmed coordinates along the tool.
struct MillCycle {
  MillShape shape = MillShape::pocket;
  std::vector<MillPlace> places;
  double return_level = 0.0;
  double surface = 0.0;
  double clearance = 0.0;  // distance in front of the surface
  double depth = 0.0;      // level of the base
  double length = 0.0;
  double width = 0.0;
  double corner_radius = 0.0;
  double bend_radius = 0.0;   // of a bent slot: of the circle in its middle
  double bend_deg = 0.0;      // … from the centre of its first end to that of its last; 360: a ring
  double blank_length = 0.0;  // of a spigot before; 0: not given
  double blank_width = 0.0;
  bool roughs = true;
  bool finishes_side = false;
  bool finishes_base = false;
  double allowance_side = 0.0;  // that roughing leaves
  double allowance_base = 0.0;
  double infeed = 0.0;         // deepest at once; 0: all at once
  double finish_infeed = 0.0;  // … of the side
  double step = 0.0;           // widest at once; 0: as the control does
  double step_of_tool = 0.0;   // … as a share of the tool's diameter, where `step` is 0
  double feed = 0.0;           // in the plane, mm/min or mm/rev; 0: the one in effect
  double feed_in = 0.0;        // along the tool; 0: `feed`
  double finish_feed = 0.0;    // 0: `feed`
  MillDirection direction = MillDirection::climb;
  MillEntry entry = MillEntry::straight;
  double entry_radius = 0.0;     // of the helix, of the tool's centre
  double entry_depth = 0.0;      // of each turn
  double entry_angle_deg = 0.0;  // steepest of an oscillation
  FaceCuts cuts = FaceCuts::first;
  MillApproach approach = MillApproach::vertical;  // of a path
  MillApproach retract = MillApproach::vertical;
  MillLift lift = MillLift::return_level;
  double approach_length = 0.0;
  double retract_length = 0.0;
  double beyond_end = 0.0;   // of a face: distance from its edge to the tool's, where a cut ends
  double beyond_side = 0.0;  // … of the last cut, across the cuts
};

// Values of a call by place; NaN: left out.
using MillValues = std::span<const double>;

// What came of them: `cycle` where neither an alarm nor a reason stands.
struct MillReading {
  MillCycle cycle;
  std::uint32_t alarm = 0;                // that the control raises for them
  std::string_view not_interpreted = {};  // "with …", of the call
};

// What the values are counted in, and what of the modal state they depend on.
struct MillUnits {
  double mm = 1.0;       // of a length
  double feed_mm = 1.0;  // of a feed
  int plane = 1;         // in effect: 1 to 3 for the first and second, third and first, second and third axis
};
using ReadMillCycle = MillReading (*)(MillValues values, const MillUnits& units);

}  // namespace dripfeed::ir
