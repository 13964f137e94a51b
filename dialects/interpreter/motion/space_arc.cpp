// point(t) = center - center cos(t sweep) + across sin(t sweep) + t rise, as -center leads from the centre to the
// start.
#include "dialects/interpreter/motion/space_arc.h"

#include <cmath>
#include <numbers>

namespace dripfeed::interpreter {

namespace {

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector sum(const Vector& a, double factor_a, const Vector& b, double factor_b) {
  Vector out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = factor_a * a[i] + factor_b * b[i];
  return out;
}

}  // namespace

Vector SpaceArc::at(double t) const {
  const double angle = t * sweep_rad;
  return sum(sum(center, 1.0 - std::cos(angle), across, std::sin(angle)), 1.0, rise, t);
}

Vector SpaceArc::end_tangent() const {
  const Vector turning = sum(center, std::sin(sweep_rad), across, std::cos(sweep_rad));
  return sum(turning, sweep_rad, rise, 1.0);
}

// The centre of the circle round a triangle with a corner at the origin; from there through `via` to `end` it goes
// counterclockwise about their cross product.
std::optional<SpaceArc> arc_through(const Vector& via, const Vector& end) {
  constexpr double kFlat = 1e-9;  // of a triangle, relative
  const Vector normal = cross(via, end);
  const double area2 = dot(normal, normal);
  const double via2 = dot(via, via);
  const double end2 = dot(end, end);
  if (!(area2 > kFlat * kFlat * via2 * end2)) return std::nullopt;
  const Vector toward = sum(end, via2, via, -end2);
  SpaceArc arc;
  arc.center = sum(cross(toward, normal), 0.5 / area2, {}, 0.0);
  arc.across = sum(cross(arc.center, normal), 1.0 / std::sqrt(area2), {}, 0.0);
  const Vector out = sum(end, 1.0, arc.center, -1.0);
  arc.sweep_rad = std::atan2(dot(out, arc.across), -dot(out, arc.center));
  if (arc.sweep_rad <= 0.0) arc.sweep_rad += 2.0 * std::numbers::pi;
  return arc;
}

SpaceArc arc_in_plane(PlaneAxes axes, PlanePoint center, PlanePoint chord, double rise, Turn turn) {
  const double sign = turn == Turn::counterclockwise ? 1.0 : -1.0;
  SpaceArc arc;
  arc.center[axes.p] = center.p;
  arc.center[axes.q] = center.q;
  // The radius to the start, (-p, -q), a quarter turn on.
  arc.across[axes.p] = sign * center.q;
  arc.across[axes.q] = -sign * center.p;
  arc.rise[axes.normal] = rise;
  arc.sweep_rad = opening_of(center, chord, turn) / 180.0 * std::numbers::pi;
  return arc;
}

SpaceArc image_of(const SpaceArc& arc, const Matrix& m) {
  return {multiply(m, arc.center), multiply(m, arc.across), multiply(m, arc.rise), arc.sweep_rad};
}

}  // namespace dripfeed::interpreter
