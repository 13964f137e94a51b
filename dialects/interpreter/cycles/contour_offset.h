// A contour at an equal distance next to itself, on the side of the tool (FAL of CYCLE95).
#pragma once

#include <optional>
#include <vector>

#include "dialects/interpreter/cycles/contour_sections.h"

namespace dripfeed::interpreter {

struct ContourSide {
  double forward = 1.0;  // in which the travel goes
  double rise = 1.0;     // in which levels go away from the material
  bool along_z = true;   // the travel is Z
};

// Hollow corners are where the two offset lines meet, the others are rounded about the corner. Nothing when a piece is
// too short for it.
std::optional<std::vector<ContourPiece>> offset_contour(const std::vector<ContourPiece>& contour, double distance_mm,
                                                        const ContourSide& side);

}  // namespace dripfeed::interpreter
