// Every inner knot is inserted until it stands `degree` times: the control points between are then those of Bezier
// pieces (The NURBS Book, A5.6, says the same by rows).
#include "dialects/curves/nurbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace dripfeed::curves {

namespace {

struct Spline {
  std::size_t degree = 0;
  std::vector<WeightedPoint> points;
  std::vector<double> knots;

  // Inserts the value once (Boehm): knots[span] <= value < knots[span + 1].
  void insert(double value) {
    const auto above = std::ranges::upper_bound(knots, value);
    const auto span = static_cast<std::size_t>(above - knots.begin()) - 1;
    std::vector<WeightedPoint> more;
    more.reserve(points.size() + 1);
    for (std::size_t i = 0; i <= points.size(); ++i) {
      if (i + degree <= span) {
        more.push_back(points[i]);
      } else if (i > span || knots[i] == value) {
        more.push_back(points[i - 1]);
      } else {
        const double part = (value - knots[i]) / (knots[i + degree] - knots[i]);
        more.push_back((1.0 - part) * points[i - 1] + part * points[i]);
      }
    }
    points = std::move(more);
    knots.insert(above, value);
  }
  [[nodiscard]] std::size_t times(double value) const {
    return static_cast<std::size_t>(std::ranges::count(knots, value));
  }
};

const BezierPiece& piece_at(const std::vector<BezierPiece>& pieces, double t) {
  const auto found = std::ranges::lower_bound(pieces, t, {}, [](const BezierPiece& piece) { return piece.t.high; });
  return found == pieces.end() ? pieces.back() : *found;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Box kAnything{{-kInfinity, kInfinity}, {-kInfinity, kInfinity}};
constexpr int kCells = 16;  // of a piece

// All second derivatives up to `high`, from where the cell before ends.
struct Cell {
  double high = 0.0;
  Box box;
};
std::vector<Cell> cells_of(const std::vector<BezierPiece>& pieces) {
  std::vector<Cell> cells;
  for (const BezierPiece& piece : pieces) {
    for (int i = 0; i < kCells; ++i) {
      const double low = piece.t.low + piece.t.width() * i / kCells;
      const double high = i + 1 == kCells ? piece.t.high : piece.t.low + piece.t.width() * (i + 1) / kCells;
      cells.push_back({high, piece.second_derivatives(low, high)});
    }
  }
  return cells;
}

Box around(const Box& a, const Box& b) {
  return {{std::min(a.z.low, b.z.low), std::max(a.z.high, b.z.high)},
          {std::min(a.x.low, b.x.low), std::max(a.x.high, b.x.high)}};
}

bool all_finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

}  // namespace

std::vector<double> clamped_knots(std::size_t points, std::size_t order) {
  std::vector<double> knots(order, 0.0);
  const std::size_t spans = points - order + 1;
  for (std::size_t i = 1; i < spans; ++i) knots.push_back(static_cast<double>(i));
  knots.insert(knots.end(), order, static_cast<double>(spans));
  return knots;
}

std::string fault_of_knots(const std::vector<double>& knots, std::size_t points, std::size_t order) {
  if (knots.size() != points + order) return "there must be as many knots as points and order";
  if (!all_finite(knots) || !std::ranges::is_sorted(knots)) return "knots must not decrease";
  const double low = knots[order - 1];
  const double high = knots[points];
  if (!(low < high)) return "the knots leave no range";
  for (std::size_t i = 1; i + order < knots.size(); ++i) {
    // As often as the order would tear the curve apart; at the outer ends it is usual.
    const bool inner = knots[i] > low && knots[i] < high;
    if (inner && knots[i] == knots[i + order - 1]) return "an inner knot stands too often";
  }
  return {};
}

std::string fault_of(const Nurbs& nurbs) {
  if (nurbs.order < 2 || nurbs.order > BezierPiece::kMostPoints) return "the order must be 2 to 16";
  if (nurbs.points.size() < nurbs.order) return "a curve needs at least as many points as its order";
  if (!nurbs.weights.empty() && nurbs.weights.size() != nurbs.points.size()) return "there must be a weight a point";
  if (!all_finite(nurbs.weights) || std::ranges::any_of(nurbs.weights, [](double w) { return !(w > 0.0); })) {
    return "weights must be above 0";
  }
  const auto is_fine = [](Point point) { return std::isfinite(point.z) && std::isfinite(point.x); };
  if (!std::ranges::all_of(nurbs.points, is_fine)) return "a point is not finite";
  if (std::ranges::all_of(nurbs.points, [&](Point point) { return point == nurbs.points.front(); })) {
    return "all points are the same";
  }
  return nurbs.knots.empty() ? std::string() : fault_of_knots(nurbs.knots, nurbs.points.size(), nurbs.order);
}

std::vector<BezierPiece> pieces_of(const Nurbs& nurbs) {
  Spline spline;
  spline.degree = nurbs.order - 1;
  spline.knots = nurbs.knots.empty() ? clamped_knots(nurbs.points.size(), nurbs.order) : nurbs.knots;
  for (std::size_t i = 0; i < nurbs.points.size(); ++i) {
    const double weight = nurbs.weights.empty() ? 1.0 : nurbs.weights[i];
    spline.points.push_back({weight * nurbs.points[i], weight});
  }
  const double low = spline.knots[spline.degree];
  const double high = spline.knots[nurbs.points.size()];
  std::vector<double> places;
  for (const double knot : spline.knots) {
    if (knot >= low && knot <= high && (places.empty() || places.back() < knot)) places.push_back(knot);
  }
  for (const double place : places) {
    while (spline.times(place) < spline.degree) spline.insert(place);
  }
  std::vector<BezierPiece> pieces;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    // The last of the knots at its beginning: the piece's points end `degree` after its first.
    const auto above = std::ranges::upper_bound(spline.knots, places[i]);
    const auto first = static_cast<std::size_t>(above - spline.knots.begin()) - 1 - spline.degree;
    BezierPiece piece{{places[i], places[i + 1]}, nurbs.order, {}};
    for (std::size_t k = 0; k < nurbs.order; ++k) piece.points[k] = spline.points[first + k];
    pieces.push_back(piece);
  }
  return pieces;
}

ParametricCurve curve_of(const Nurbs& nurbs) {
  const auto pieces = std::make_shared<const std::vector<BezierPiece>>(pieces_of(nurbs));
  ParametricCurve curve;
  curve.t = {pieces->front().t.low, pieces->back().t.high};
  curve.at = [pieces](double t) { return piece_at(*pieces, t).at(t); };
  curve.second_derivatives = [pieces](double low, double high) {
    return piece_at(*pieces, 0.5 * (low + high)).second_derivatives(low, high);
  };
  curve.wide_second_derivatives = [cells = cells_of(*pieces)](double low, double high) {
    const auto first = std::ranges::upper_bound(cells, low, {}, &Cell::high);
    Box box = kAnything;
    if (first == cells.end()) return box;
    box = first->box;
    for (auto cell = first; cell->high < high; box = around(box, cell->box)) {
      if (++cell == cells.end()) return kAnything;
    }
    return box;
  };
  for (std::size_t i = 1; i < pieces->size(); ++i) curve.breaks.push_back((*pieces)[i].t.low);
  return curve;
}

}  // namespace dripfeed::curves
