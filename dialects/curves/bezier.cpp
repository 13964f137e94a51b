// De Casteljau throughout. With C = N/w (both Bezier polynomials): C' = (N' - C·w')/w and C'' = (N'' - 2C'·w' -
// C·w'')/w. For the enclosure the origin is laid onto the piece, so that C, which multiplies w'', is small.
#include "dialects/curves/bezier.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dripfeed::curves {

namespace {

using Points = std::array<WeightedPoint, BezierPiece::kMostPoints>;

constexpr double kRounding = 1e-13;  // relative, of what the enclosures are made of

Range hull(Range a, double value) { return {std::min(a.low, value), std::max(a.high, value)}; }
Range widened(Range a) {
  const double more = kRounding * std::max(std::fabs(a.low), std::fabs(a.high));
  return {a.low - more, a.high + more};
}
Range operator+(Range a, Range b) { return widened({a.low + b.low, a.high + b.high}); }
Range operator-(Range a, Range b) { return widened({a.low - b.high, a.high - b.low}); }
Range operator*(Range a, Range b) {
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return widened({low, high});
}
Range operator*(double k, Range a) { return Range{k, k} * a; }

struct Hull {
  Range z;
  Range x;
  Range weight;
};

// Of `count` points, each times `factor`.
Hull hull_of(const Points& points, std::size_t count, double factor) {
  Hull out{{factor * points[0].point.z, factor * points[0].point.z},
           {factor * points[0].point.x, factor * points[0].point.x},
           {factor * points[0].weight, factor * points[0].weight}};
  for (std::size_t i = 1; i < count; ++i) {
    out.z = hull(out.z, factor * points[i].point.z);
    out.x = hull(out.x, factor * points[i].point.x);
    out.weight = hull(out.weight, factor * points[i].weight);
  }
  return {widened(out.z), widened(out.x), widened(out.weight)};
}

Points differences(const Points& points, std::size_t count) {
  Points out;
  for (std::size_t i = 0; i + 1 < count; ++i) out[i] = points[i + 1] + -1.0 * points[i];
  return out;
}

// (n - c)/w for one coordinate.
Range derivative_of(Range n, Range others, Range weight) {
  return (n - others) * Range{1.0 / weight.high, 1.0 / weight.low};
}

}  // namespace

ParametricPoint BezierPiece::at(double t_at) const {
  const double width = t.width();
  const double u = width > 0.0 ? (t_at - t.low) / width : 0.0;
  Points p = points;
  const auto degree = static_cast<double>(count - 1);
  WeightedPoint first{};
  WeightedPoint second{};
  for (std::size_t left = count; left > 1; --left) {
    if (left == 3 && width > 0.0) {
      second = degree * (degree - 1.0) / (width * width) * (p[2] + -2.0 * p[1] + p[0]);
    }
    if (left == 2 && width > 0.0) first = degree / width * (p[1] + -1.0 * p[0]);
    for (std::size_t i = 0; i + 1 < left; ++i) p[i] = (1.0 - u) * p[i] + u * p[i + 1];
  }
  const double w = p[0].weight;
  ParametricPoint out;
  out.point = (1.0 / w) * p[0].point;
  out.derivative = (1.0 / w) * (first.point - first.weight * out.point);
  out.second = (1.0 / w) * (second.point - 2.0 * first.weight * out.derivative - second.weight * out.point);
  return out;
}

BezierPiece BezierPiece::part(double t_low, double t_high) const {
  BezierPiece out{{t_low, t_high}, count, {}};
  const double u_low = (t_low - t.low) / t.width();
  const double u_high = (t_high - t.low) / t.width();
  // The left part up to u_high: the first of each row of the scheme.
  Points p = points;
  Points kept;
  for (std::size_t left = count; left > 0; --left) {
    kept[count - left] = p[0];
    for (std::size_t i = 0; i + 1 < left; ++i) p[i] = (1.0 - u_high) * p[i] + u_high * p[i + 1];
  }
  // Of that the right part from u_low: the last of each row.
  const double u = u_high > 0.0 ? u_low / u_high : 0.0;
  for (std::size_t left = count; left > 0; --left) {
    out.points[left - 1] = kept[left - 1];
    for (std::size_t i = 0; i + 1 < left; ++i) kept[i] = (1.0 - u) * kept[i] + u * kept[i + 1];
  }
  return out;
}

Box BezierPiece::second_derivatives(double t_low, double t_high) const {
  const double infinity = std::numeric_limits<double>::infinity();
  const Box anything{{-infinity, infinity}, {-infinity, infinity}};
  const double width = t_high - t_low;
  if (!(width > 0.0)) {
    const Point second = at(t_low).second;
    return {{second.z, second.z}, {second.x, second.x}};
  }
  BezierPiece here = part(t_low, t_high);
  const Point origin = at(0.5 * (t_low + t_high)).point;
  for (std::size_t i = 0; i < count; ++i) {
    here.points[i].point = here.points[i].point - here.points[i].weight * origin;
  }
  const auto degree = static_cast<double>(count - 1);
  const Points one = differences(here.points, count);
  const Hull w = hull_of(here.points, count, 1.0);
  const Hull n1 = hull_of(one, count - 1, degree / width);
  Hull n2{};
  if (count > 2) n2 = hull_of(differences(one, count - 1), count - 2, degree * (degree - 1.0) / (width * width));
  if (!(w.weight.low > 0.0)) return anything;
  if (w.weight.low == w.weight.high && n1.weight.low == 0.0 && n1.weight.high == 0.0) {
    return {widened((1.0 / w.weight.low) * n2.z), widened((1.0 / w.weight.low) * n2.x)};
  }
  Range c_z{infinity, -infinity};
  Range c_x{infinity, -infinity};
  for (std::size_t i = 0; i < count; ++i) {
    c_z = hull(c_z, here.points[i].point.z / here.points[i].weight);
    c_x = hull(c_x, here.points[i].point.x / here.points[i].weight);
  }
  const Range d_z = derivative_of(n1.z, c_z * n1.weight, w.weight);
  const Range d_x = derivative_of(n1.x, c_x * n1.weight, w.weight);
  return {derivative_of(n2.z, 2.0 * (d_z * n1.weight) + c_z * n2.weight, w.weight),
          derivative_of(n2.x, 2.0 * (d_x * n1.weight) + c_x * n2.weight, w.weight)};
}

}  // namespace dripfeed::curves
