// The programmable frame: where a programmed position lies in the active work offset. Position = matrix · programmed +
// shift for X Y Z, shift alone for the other axes. Radius values, mm.
#pragma once

#include <array>
#include <cmath>

#include "dialects/ir/semantics.h"

namespace dripfeed::interpreter {

using Vector = std::array<double, 3>;
using Matrix = std::array<double, 9>;  // row by row

inline constexpr Matrix kIdentity = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};

Matrix multiply(const Matrix& a, const Matrix& b);
Vector multiply(const Matrix& m, const Vector& v);
// Of a matrix that is not singular; a singular one gives the identity.
Matrix inverse_of(const Matrix& m);

// Turns by these angles in degrees about X, Y and Z: first Z, then the new Y, then the new X (ROT, "RPY angles").
Matrix rotation_of(const Vector& angles_deg);
Matrix rotation_in(ir::Plane plane, double angle_deg);
// About an axis through the origin, which is not of length 0, by the right hand.
Matrix rotation_about(const Vector& axis, double angle_deg);
Matrix diagonal_of(const Vector& factors);

// The axes of a plane as indices: p, q and the one that stands on it.
struct PlaneAxes {
  std::size_t p = 0;
  std::size_t q = 1;
  std::size_t normal = 2;
};
constexpr PlaneAxes axes_of(ir::Plane plane) {
  if (plane == ir::Plane::zx) return {2, 0, 1};
  return plane == ir::Plane::yz ? PlaneAxes{1, 2, 0} : PlaneAxes{0, 1, 2};
}

// What a frame does to arcs in a plane.
struct PlaneImage {
  bool tilted = false;    // the plane is not parallel to itself any more
  bool stays = true;      // it is, and circles stay circles
  bool mirrored = false;  // clockwise becomes counterclockwise
  double scale = 1.0;     // of radii
};
PlaneImage image_of(const Matrix& m, PlaneAxes axes);
// Whether every circle stays a circle, wherever it lies: it turns, mirrors and scales all axes alike.
bool keeps_shapes(const Matrix& m);

}  // namespace dripfeed::interpreter
