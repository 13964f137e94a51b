// A height is found by Newton's steps in u and v from the nearest of the points of a net that were put into the cells
// of a grid in x and y.
#include "dialects/curves/nurbs_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "dialects/curves/bezier.h"
#include "dialects/curves/nurbs.h"

namespace dripfeed::curves {

namespace {

constexpr std::size_t kMostOrder = BezierPiece::kMostPoints;
constexpr int kStepsOfSpan = 8;     // of the net, between two knots
constexpr std::size_t kCells = 64;  // of the grid, along each axis
constexpr int kMostNewtonSteps = 40;
constexpr double kFound_mm = 1e-9;
constexpr double kStill = 1e-13;     // of the range of u and v
constexpr double kOffRim_mm = 1e-6;  // a place this far outside is on the rim

// The functions of the `order` points that count at t, and their slopes. (The NURBS Book, A2.2 and equation 2.7.)
struct Basis {
  std::size_t first = 0;  // of the points that count
  std::array<double, kMostOrder> value{};
  std::array<double, kMostOrder> slope{};
};

Basis basis_at(const std::vector<double>& knots, std::size_t points, std::size_t order, double t) {
  const std::size_t degree = order - 1;
  const auto inner = std::ranges::upper_bound(knots.begin() + static_cast<std::ptrdiff_t>(order),
                                              knots.begin() + static_cast<std::ptrdiff_t>(points), t);
  auto span = static_cast<std::size_t>(inner - knots.begin()) - 1;
  while (span > degree && !(knots[span] < knots[span + 1])) --span;  // the last knots may stand once more
  Basis out{.first = span - degree};
  std::array<double, kMostOrder> lower{};  // of one degree less
  out.value[0] = 1.0;
  for (std::size_t d = 1; d <= degree; ++d) {
    if (d == degree) lower = out.value;
    double carried = 0.0;
    for (std::size_t i = 0; i < d; ++i) {
      const double right = knots[span + i + 1];
      const double left = knots[span + 1 + i - d];
      const double part = out.value[i] / (right - left);
      out.value[i] = carried + (right - t) * part;
      carried = (t - left) * part;
    }
    out.value[d] = carried;
  }
  for (std::size_t i = 0; i <= degree; ++i) {
    const auto share = [&](std::size_t n) {  // of function n of the lower degree
      return lower[n] / (knots[span + n + 1] - knots[span + n + 1 - degree]);
    };
    const double before = i > 0 ? share(i - 1) : 0.0;
    const double after = i < degree ? share(i) : 0.0;
    out.slope[i] = static_cast<double>(degree) * (before - after);
  }
  return out;
}

struct Weighted {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double weight = 0.0;

  void add(double by, const SpacePoint& point, double point_weight) {
    const double all = by * point_weight;
    x += all * point.x;
    y += all * point.y;
    z += all * point.z;
    weight += all;
  }
};

Range span_of(const std::vector<double>& knots, std::size_t points, std::size_t order) {
  return {knots[order - 1], knots[points]};
}

// The places of the net along one direction: some between each two knots.
std::vector<double> net_of(const std::vector<double>& knots, std::size_t points, std::size_t order) {
  std::vector<double> out;
  for (std::size_t i = order - 1; i < points; ++i) {
    const double width = knots[i + 1] - knots[i];
    for (int n = 0; n < kStepsOfSpan && width > 0.0; ++n) out.push_back(knots[i] + width * n / kStepsOfSpan);
  }
  out.push_back(knots[points]);
  return out;
}

struct Place {
  double u = 0.0;
  double v = 0.0;
};

// How the x-y plane is covered by a step of u and one of v: 0 or less where the surface does not face up.
double area_of(const SurfacePoint& point) {
  return point.along_u.x * point.along_v.y - point.along_u.y * point.along_v.x;
}

class Heights {
 public:
  explicit Heights(NurbsSurface surface) : surface_(std::move(surface)), rows_(surface_.points.size() / surface_.row) {
    u_ = span_of(surface_.knots_u, rows_, surface_.order);
    v_ = span_of(surface_.knots_v, surface_.row, surface_.order);
    x_ = {surface_.points.front().x, surface_.points.front().x};
    y_ = {surface_.points.front().y, surface_.points.front().y};
    for (const SpacePoint& point : surface_.points) {
      x_ = {std::min(x_.low, point.x), std::max(x_.high, point.x)};
      y_ = {std::min(y_.low, point.y), std::max(y_.high, point.y)};
    }
    fill_grid();
  }

  [[nodiscard]] Range x() const { return x_; }
  [[nodiscard]] Range y() const { return y_; }

  // Not a number: no surface there.
  [[nodiscard]] double at(double x, double y) const {
    Place place = grid_[cell(y, y_) * kCells + cell(x, x_)];
    for (int step = 0; step < kMostNewtonSteps; ++step) {
      const SurfacePoint here = point_of(surface_, place.u, place.v);
      const double dx = x - here.at.x;
      const double dy = y - here.at.y;
      const double area = area_of(here);
      if (!(area > 0.0)) return kNone;
      if (std::hypot(dx, dy) < kFound_mm) return here.at.z;
      const Place wanted = {place.u + (dx * here.along_v.y - dy * here.along_v.x) / area,
                            place.v + (dy * here.along_u.x - dx * here.along_u.y) / area};
      const Place next = {std::clamp(wanted.u, u_.low, u_.high), std::clamp(wanted.v, v_.low, v_.high)};
      const double moved = std::fabs(next.u - place.u) / u_.width() + std::fabs(next.v - place.v) / v_.width();
      if (moved < kStill) return std::hypot(dx, dy) < kOffRim_mm ? here.at.z : kNone;
      place = next;
    }
    return kNone;
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  static std::size_t cell(double value, Range range) {
    const double part = range.width() > 0.0 ? (value - range.low) / range.width() : 0.0;
    return static_cast<std::size_t>(std::lround(std::clamp(part, 0.0, 1.0) * (static_cast<double>(kCells) - 1.0)));
  }

  // Each cell gets the point of the net that is nearest to its middle.
  void fill_grid() {
    struct NetPoint {
      Place place;
      SpacePoint at;
    };
    std::vector<NetPoint> net;
    for (const double u : net_of(surface_.knots_u, rows_, surface_.order))
      for (const double v : net_of(surface_.knots_v, surface_.row, surface_.order))
        net.push_back({{u, v}, point_of(surface_, u, v).at});
    const auto middle = [](std::size_t n, Range range) {
      return range.low + range.width() * static_cast<double>(n) / (static_cast<double>(kCells) - 1.0);
    };
    for (std::size_t row = 0; row < kCells; ++row)
      for (std::size_t column = 0; column < kCells; ++column) {
        const double x = middle(column, x_);
        const double y = middle(row, y_);
        const auto far = [&](const NetPoint& one) { return std::hypot(one.at.x - x, one.at.y - y); };
        grid_.push_back(std::ranges::min_element(net, {}, far)->place);
      }
  }

  NurbsSurface surface_;
  std::size_t rows_;
  Range u_, v_, x_, y_;
  std::vector<Place> grid_;  // row by row
};

// In one direction, which `which` names.
std::string fault_along(const std::vector<double>& knots, std::size_t points, std::size_t order,
                        const std::string& which) {
  if (points < order) return which + ": a surface needs at least as many points as its order";
  const std::string fault = knots.empty() ? "" : fault_of_knots(knots, points, order);
  return fault.empty() ? fault : which + ": " + fault;
}

NurbsSurface with_knots(NurbsSurface surface) {
  if (surface.knots_u.empty()) surface.knots_u = clamped_knots(surface.points.size() / surface.row, surface.order);
  if (surface.knots_v.empty()) surface.knots_v = clamped_knots(surface.row, surface.order);
  return surface;
}

double in_thousandths(double value) { return std::round(value * 1000.0) / 1000.0; }

// Looked at on the net.
std::string fault_of_direction(const NurbsSurface& surface) {
  for (const double u : net_of(surface.knots_u, surface.points.size() / surface.row, surface.order))
    for (const double v : net_of(surface.knots_v, surface.row, surface.order))
      if (const SurfacePoint point = point_of(surface, u, v); !(area_of(point) > 0.0))
        return fmt::format("it does not face up at x {} y {}: u, v and z make no right-hand system there",
                           in_thousandths(point.at.x), in_thousandths(point.at.y));
  return {};
}

}  // namespace

std::string fault_of(const NurbsSurface& surface) {
  if (surface.order < 2 || surface.order > kMostOrder) return "the order must be 2 to 16";
  if (surface.row == 0 || surface.points.empty() || surface.points.size() % surface.row != 0)
    return "the points are not whole rows";
  if (!surface.weights.empty() && surface.weights.size() != surface.points.size())
    return "there must be a weight a point";
  const auto is_weight = [](double weight) { return std::isfinite(weight) && weight > 0.0; };
  if (!std::ranges::all_of(surface.weights, is_weight)) return "weights must be above 0";
  const auto is_fine = [](const SpacePoint& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  if (!std::ranges::all_of(surface.points, is_fine)) return "a point is not finite";
  std::string across =
      fault_along(surface.knots_u, surface.points.size() / surface.row, surface.order, "across the rows");
  if (!across.empty()) return across;
  std::string along = fault_along(surface.knots_v, surface.row, surface.order, "along a row");
  return along.empty() ? fault_of_direction(with_knots(surface)) : along;
}

SurfacePoint point_of(const NurbsSurface& surface, double u, double v) {
  const Basis across = basis_at(surface.knots_u, surface.points.size() / surface.row, surface.order, u);
  const Basis along = basis_at(surface.knots_v, surface.row, surface.order, v);
  Weighted all;
  Weighted by_u;
  Weighted by_v;
  for (std::size_t i = 0; i < surface.order; ++i)
    for (std::size_t k = 0; k < surface.order; ++k) {
      const std::size_t n = (across.first + i) * surface.row + along.first + k;
      const double weight = surface.weights.empty() ? 1.0 : surface.weights[n];
      all.add(across.value[i] * along.value[k], surface.points[n], weight);
      by_u.add(across.slope[i] * along.value[k], surface.points[n], weight);
      by_v.add(across.value[i] * along.slope[k], surface.points[n], weight);
    }
  const SpacePoint at = {all.x / all.weight, all.y / all.weight, all.z / all.weight};
  const auto slope = [&](const Weighted& by) {
    return SpacePoint{(by.x - by.weight * at.x) / all.weight, (by.y - by.weight * at.y) / all.weight,
                      (by.z - by.weight * at.z) / all.weight};
  };
  return {at, slope(by_u), slope(by_v)};
}

HeightField heights_of(NurbsSurface surface, double tolerance) {
  const auto heights = std::make_shared<const Heights>(with_knots(std::move(surface)));
  return {.x = heights->x(),
          .y = [heights](double /*x*/) { return heights->y(); },
          .z = [heights](double x, double y) { return heights->at(x, y); },
          .tolerance = tolerance};
}

}  // namespace dripfeed::curves
