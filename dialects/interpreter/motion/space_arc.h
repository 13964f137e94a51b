// Arcs and helices in any plane of space. Radius values, mm; all but angles are vectors from where the arc starts.
#pragma once

#include <optional>

#include "dialects/interpreter/motion/arc.h"
#include "dialects/interpreter/state/frame.h"

namespace dripfeed::interpreter {

struct SpaceArc {
  Vector center{};
  Vector across{};  // where the radius to the start points after a quarter turn
  Vector rise{};    // of a helix, on its whole path
  double sweep_rad = 0.0;

  // Where it is after the share t of its path, 0 to 1.
  [[nodiscard]] Vector at(double t) const;
  // Its direction at its end.
  [[nodiscard]] Vector end_tangent() const;
};

// From the start through `via` to `end`; nothing where the three lie on a line.
std::optional<SpaceArc> arc_through(const Vector& via, const Vector& end);

// An arc in a plane: `center` and `chord` (end minus start) in it, `rise` along its normal.
SpaceArc arc_in_plane(PlaneAxes axes, PlanePoint center, PlanePoint chord, double rise, Turn turn);

// As the matrix turns, mirrors and scales it.
SpaceArc image_of(const SpaceArc& arc, const Matrix& m);

}  // namespace dripfeed::interpreter
