// Slopes at the points, then Hermite's polynomials between them.
#include "dialects/interpreter/motion/spline_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dialects/interpreter/motion/nurbs_block.h"
#include "dialects/ir/spline_use.h"

namespace dripfeed::interpreter {

namespace {

// b m = r with the three diagonals; the first and the last row have two entries.
struct Tridiagonal {
  std::vector<double> below, main, above, right;

  explicit Tridiagonal(std::size_t n) : below(n), main(n), above(n), right(n) {}
  [[nodiscard]] std::vector<double> solve() && {
    const std::size_t n = main.size();
    for (std::size_t i = 1; i < n; ++i) {
      const double factor = below[i] / main[i - 1];
      main[i] -= factor * above[i - 1];
      right[i] -= factor * right[i - 1];
    }
    right[n - 1] /= main[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) right[i] = (right[i] - above[i] * right[i + 1]) / main[i];
    return std::move(right);
  }
};

}  // namespace

SplineCurve::SplineCurve(std::int16_t kind, std::size_t degree, std::vector<SplinePoint> points, const SplineEnd& begin,
                         const SplineEnd& end, bool x_is_diameter)
    : points_(std::move(points)),
      is_b_(kind == ir::kSplineB),
      is_akima_(kind == ir::kSplineAkima),
      factor_(x_is_diameter ? 2.0 : 1.0) {
  if (is_b_) {
    make_b(degree);
    return;
  }
  find_chords();
  for (std::size_t axis = 0; axis < kSplineAxes; ++axis) find_slopes(axis, begin, end);
}

void SplineCurve::find_chords() {
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < kSplineAxes; ++axis) {
      const double d = (points_[i + 1].at[axis] - points_[i].at[axis]) / (axis == 0 ? factor_ : 1.0);
      sum += d * d;
    }
    lengths_.push_back(std::sqrt(sum));
  }
}

void SplineCurve::find_slopes(std::size_t axis, const SplineEnd& begin, const SplineEnd& end) {
  Slopes chords;
  for (std::size_t i = 0; i < lengths_.size(); ++i)
    chords.push_back((points_[i + 1].at[axis] - points_[i].at[axis]) / lengths_[i]);
  const auto tangent = [&](const SplineEnd& e) -> std::optional<double> {
    if (e.kind != ir::kSplineTangent || !e.direction.has_value()) return std::nullopt;
    const Vector& d = *e.direction;
    return d[axis] / std::hypot(d[0], d[1], d[2]) * (axis == 0 ? factor_ : 1.0);
  };
  const std::optional<double> first = tangent(begin);
  const std::optional<double> last = tangent(end);
  const bool first_natural = begin.kind == ir::kSplineNatural;
  const bool last_natural = end.kind == ir::kSplineNatural;
  if (!is_akima_) {
    slopes_[axis] = cubic(chords, first, first_natural, last, last_natural);
    return;
  }
  Slopes m = akima(chords);
  // Without curvature: the second derivative of the first or last polynomial is 0 at its end.
  if (first_natural) m.front() = (3.0 * chords.front() - m[1]) / 2.0;
  if (last_natural) m.back() = (3.0 * chords.back() - m[m.size() - 2]) / 2.0;
  m.front() = first.value_or(m.front());
  m.back() = last.value_or(m.back());
  slopes_[axis] = std::move(m);
}

// H. Akima, A New Method of Interpolation and Smooth Curve Fitting Based on Local Procedures, JACM 17 (1970): two
// chords more at each end, on the parabola through the last three points.
SplineCurve::Slopes SplineCurve::akima(const Slopes& chords) const {
  const std::size_t n = chords.size();
  const double first_step = n > 1 ? chords[0] - chords[1] : 0.0;
  const double last_step = n > 1 ? chords[n - 1] - chords[n - 2] : 0.0;
  Slopes d = {chords.front() + 2.0 * first_step, chords.front() + first_step};
  d.insert(d.end(), chords.begin(), chords.end());
  d.insert(d.end(), {chords.back() + last_step, chords.back() + 2.0 * last_step});
  Slopes m;
  for (std::size_t i = 0; i <= n; ++i) {
    const double before = std::abs(d[i + 3] - d[i + 2]);
    const double after = std::abs(d[i + 1] - d[i]);
    const double sum = before + after;
    // Two straight lines meet: half of each.
    const bool straight = sum <= 1e-12 * (std::abs(d[i + 1]) + std::abs(d[i + 2]));
    m.push_back(straight || sum == 0.0 ? (d[i + 1] + d[i + 2]) / 2.0 : (before * d[i + 1] + after * d[i + 2]) / sum);
  }
  return m;
}

// Second derivatives without a jump at the inner points. At an end the slope, no curvature, or one polynomial for the
// last two pieces (of two points a line, of three a parabola).
SplineCurve::Slopes SplineCurve::cubic(const Slopes& d, std::optional<double> first, bool first_natural,
                                       std::optional<double> last, bool last_natural) const {
  const std::vector<double>& h = lengths_;
  const std::size_t n = d.size();
  Tridiagonal rows(n + 1);
  for (std::size_t i = 1; i < n; ++i) {
    rows.below[i] = h[i];
    rows.main[i] = 2.0 * (h[i - 1] + h[i]);
    rows.above[i] = h[i - 1];
    rows.right[i] = 3.0 * (h[i] * d[i - 1] + h[i - 1] * d[i]);
  }
  const auto end_row = [&](std::size_t row, double& neighbour, std::optional<double> slope, bool natural, double own,
                           double next, double own_h, double next_h) {
    rows.main[row] = 1.0;
    if (slope.has_value()) {
      rows.right[row] = *slope;
    } else if (natural) {
      rows.main[row] = 2.0;
      neighbour = 1.0;
      rows.right[row] = 3.0 * own;
    } else if (n <= 2) {
      neighbour = n == 1 && !first.has_value() && !last.has_value() && !first_natural && !last_natural ? 0.0 : 1.0;
      rows.right[row] = (1.0 + neighbour) * own;
    } else {
      const double both = own_h + next_h;
      rows.main[row] = next_h;
      neighbour = both;
      rows.right[row] = ((own_h + 2.0 * both) * next_h * own + own_h * own_h * next) / both;
    }
  };
  end_row(0, rows.above[0], first, first_natural, d[0], d[n > 1 ? 1 : 0], h[0], h[n > 1 ? 1 : 0]);
  end_row(n, rows.below[n], last, last_natural, d[n - 1], d[n > 1 ? n - 2 : 0], h[n - 1], h[n > 1 ? n - 2 : 0]);
  return std::move(rows).solve();
}

// The points are the polygon of control; it begins in the first and ends in the last. The knot distance that a block
// names is that of the piece that ends with it, 1 where none does.
void SplineCurve::make_b(std::size_t degree) {
  const std::size_t n = points_.size();
  order_ = std::min(degree, n - 1) + 1;
  b_.order = order_;
  for (const SplinePoint& p : points_) {
    b_.points.push_back(p.at);
    b_.weights.push_back(p.weight);
  }
  b_.knots.assign(order_, 0.0);
  for (std::size_t i = order_ - 1; i < n; ++i)
    b_.knots.push_back(b_.knots.back() + (points_[i].distance >= 0.0 ? points_[i].distance : 1.0));
  b_.knots.insert(b_.knots.end(), order_ - 1, b_.knots.back());
}

AxisValues SplineCurve::at(std::size_t i, double share) const {
  if (is_b_) {
    const double from = b_.knots[i + 1];
    const double width = b_.knots[i + 2] - from;
    const AxisValues out = point_of_curve(b_, i + 1, from + share * width);
    // In a last point without weight the curve has a limit only.
    return std::isfinite(out[0]) ? out : point_of_curve(b_, i + 1, from + (1.0 - 1e-9) * width);
  }
  AxisValues out{};
  const AxisValues& a = points_[i].at;
  const AxisValues& b = points_[i + 1].at;
  for (std::size_t axis = kSplineAxes; axis < out.size(); ++axis) out[axis] = a[axis] + share * (b[axis] - a[axis]);
  const double t = share;
  const double rest = 1.0 - t;
  for (std::size_t axis = 0; axis < kSplineAxes; ++axis) {
    const double h = lengths_[i];
    out[axis] = rest * rest * (1.0 + 2.0 * t) * a[axis] + t * t * (3.0 - 2.0 * t) * b[axis] +
                h * t * rest * (rest * slopes_[axis][i] - t * slopes_[axis][i + 1]);
  }
  if (share >= 1.0) return b;  // to the last bit
  return share <= 0.0 ? a : out;
}

}  // namespace dripfeed::interpreter
