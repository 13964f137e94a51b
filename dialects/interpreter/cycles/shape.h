// A shape to be cut away to, as a chain of lines and arcs in a plane of levels and travels: the travel is the direction
// that passes cut along, the level the one that they are stepped in. G71 has Z as travel and the radius as level, G72
// the radius as travel and Z as level.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dialects/ir/motion.h"

namespace dripfeed::interpreter {

struct ShapePoint {
  double travel = 0.0;
  double level = 0.0;
};
struct ShapeSegment {
  ShapePoint from;
  ShapePoint to;
  ShapePoint center;  // arcs
  bool arc = false;
  double turn = 0.0;  // arcs: angle from the start's to the end's direction, radians, positive from travel to level
  std::uint32_t line = 0;
};

// An arc's turn from its ends and centre; `positive`: from travel to level. Counterclockwise in the ZX plane, from Z to
// X, is positive where the travel is Z and negative where it is X.
double turn_of(const ShapeSegment& arc, bool positive);
// Where it cuts the level, as a travel; the first place in the direction of the segment. Nothing when it does not.
std::optional<double> travel_at(const ShapeSegment& segment, double level);
// The same in pieces of which both coordinates only rise or only fall.
std::vector<ShapeSegment> split_at_turns(const ShapeSegment& segment);
// True when both coordinates only rise or only fall; what goes back by no more than `tolerance_mm` does not count.
bool is_monotonic(const std::vector<ShapeSegment>& shape, double tolerance_mm, std::uint32_t& line, bool& in_level);

}  // namespace dripfeed::interpreter
