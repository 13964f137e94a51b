// NURBS surfaces: control points in rows, weights and two lists of knots; and the heights of one over the x-y plane,
// for surfaces that face up everywhere.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dialects/curves/height_field.h"

namespace dripfeed::curves {

struct SpacePoint {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

struct NurbsSurface {
  std::size_t order = 4;  // degree + 1, of both directions
  std::size_t row = 0;    // points of a row; a row goes along v, and u from row to row
  std::vector<SpacePoint> points;
  std::vector<double> weights;  // empty: all 1
  std::vector<double> knots_u;  // rows + order of them; empty: clamped and uniform
  std::vector<double> knots_v;  // row + order
};

// What is wrong with it, in one sentence; empty when it is a surface that faces up: u, v and z make a right-hand
// system.
std::string fault_of(const NurbsSurface& surface);

// A point of the surface and how it moves along u and v.
struct SurfacePoint {
  SpacePoint at;
  SpacePoint along_u;
  SpacePoint along_v;
};
// u and v within the range of their knots, which the surface states; it must have no other fault. (The NURBS Book, A2.2
// and A4.4.)
SurfacePoint point_of(const NurbsSurface& surface, double u, double v);

// Its heights, in the region that its control points span; none where no point of the surface lies above or below. The
// function may be called from several threads.
HeightField heights_of(NurbsSurface surface, double tolerance);

}  // namespace dripfeed::curves
