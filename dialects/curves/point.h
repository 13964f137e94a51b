// A point or vector of a plane, named as on a lathe: z is the abscissa, x (a radius) the ordinate; and a closed range
// of numbers. Angles count from +z towards +x.
#pragma once

#include <cmath>

namespace dripfeed::curves {

struct Point {
  double z = 0.0;
  double x = 0.0;

  friend constexpr Point operator+(Point a, Point b) { return {a.z + b.z, a.x + b.x}; }
  friend constexpr Point operator-(Point a, Point b) { return {a.z - b.z, a.x - b.x}; }
  friend constexpr Point operator*(double k, Point a) { return {k * a.z, k * a.x}; }
  friend constexpr bool operator==(Point, Point) = default;
};

constexpr double dot(Point a, Point b) { return a.z * b.z + a.x * b.x; }
// Positive when b lies to the left of a (counterclockwise).
constexpr double cross(Point a, Point b) { return a.z * b.x - a.x * b.z; }
inline double norm(Point a) { return std::hypot(a.z, a.x); }
inline double distance(Point a, Point b) { return norm(a - b); }
// The vector with length 1; {0, 0} for one without length.
inline Point unit(Point a) {
  const double length = norm(a);
  return length > 0.0 ? (1.0 / length) * a : Point{};
}

struct Range {
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] constexpr double width() const { return high - low; }
  [[nodiscard]] constexpr bool contains(double value) const { return low <= value && value <= high; }
};

}  // namespace dripfeed::curves
