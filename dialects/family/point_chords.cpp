// The pieces between knots are found in two planes, x with y and z alone, which have the same weights and knots.
#include "dialects/family/point_chords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "dialects/curves/nurbs.h"
#include "dialects/family/evaluate.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

using curves::BezierPiece;

constexpr double kMostOfPoints = 100'000.0;
constexpr double kHull_mm = 1e-9;  // of the control points that are found
constexpr int kQuarters = 4;

std::span<const double> numbers(const BoundFamily& bound, ir::SymbolId list) {
  return list == ir::SymbolId::none ? std::span<const double>() : list_in(bound.values, list);
}

std::size_t order_of(const BoundFamily& bound, const PointCurve& curve) {
  return curve.is_bezier() ? numbers(bound, curve.axes.front().list).size() : static_cast<std::size_t>(curve.order);
}

// The coordinates of two of its axes, all in mm and radius; an axis that it lacks is 0.
curves::Nurbs plane_of(const BoundFamily& bound, const PointCurve& curve, ir::Address first, ir::Address second) {
  curves::Nurbs out;
  out.order = order_of(bound, curve);
  out.points.resize(numbers(bound, curve.axes.front().list).size());
  for (const PointCurve::Axis& axis : curve.axes) {
    const std::span<const double> at = numbers(bound, axis.list);
    const double scale = axis.address == ir::Address::x && bound.family->x_is_diameter ? 0.5 : 1.0;
    for (std::size_t i = 0; i < out.points.size() && i < at.size(); ++i) {
      if (axis.address == first) out.points[i].z = scale * at[i];
      if (axis.address == second) out.points[i].x = scale * at[i];
    }
  }
  const std::span<const double> weights = numbers(bound, curve.weights);
  out.weights.assign(out.points.size(), 1.0);
  std::copy_n(weights.begin(), std::min(weights.size(), out.weights.size()), out.weights.begin());
  const std::span<const double> knots = curve.has_own_knots ? std::span<const double>() : numbers(bound, curve.knots);
  out.knots.assign(knots.begin(), knots.end());
  return out;
}

// Or a vector.
struct SpacePlace {
  double x, y, z;
};
// From a to b.
SpacePlace between(SpacePlace a, SpacePlace b) { return {b.x - a.x, b.y - a.y, b.z - a.z}; }
double product(SpacePlace a, SpacePlace b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
SpacePlace part_of(SpacePlace a, double part) { return {part * a.x, part * a.y, part * a.z}; }

double apart(SpacePlace from, SpacePlace a, SpacePlace b) {
  const SpacePlace along = between(a, b);
  const double square = product(along, along);
  const double part = square > 0.0 ? std::clamp(product(between(a, from), along) / square, 0.0, 1.0) : 0.0;
  const SpacePlace across = between(part_of(along, part), between(a, from));
  return std::sqrt(product(across, across));
}

struct SpacePiece {
  BezierPiece xy, z;

  [[nodiscard]] SpacePiece part(double low, double high) const { return {xy.part(low, high), z.part(low, high)}; }
  [[nodiscard]] SpacePlace point(std::size_t i) const {
    const double w = xy.points[i].weight;
    return {xy.points[i].point.z / w, xy.points[i].point.x / w, z.points[i].point.z / w};
  }
  [[nodiscard]] SpacePlace first() const { return point(0); }
  [[nodiscard]] SpacePlace last() const { return point(xy.count - 1); }
  // Of its middle control points none is farther from the chord between its ends, by quarters of the piece.
  [[nodiscard]] double height() const { return height_over(first(), last()); }
  [[nodiscard]] double height_over(SpacePlace a, SpacePlace b) const {
    double most = 0.0;
    for (int i = 0; i < kQuarters; ++i) {
      const auto t = [this](int quarter) { return xy.t.low + xy.t.width() * quarter / kQuarters; };
      const SpacePiece one = part(t(i), i + 1 == kQuarters ? xy.t.high : t(i + 1));
      for (std::size_t n = 0; n < xy.count; ++n) most = std::max(most, apart(one.point(n), a, b));
    }
    return most;
  }
};

// The greatest height of so many chords.
double highest(const SpacePiece& piece, double chords, double enough_mm) {
  double most = 0.0;
  const auto count = static_cast<int>(chords);
  for (int i = 0; i < count && most <= enough_mm * 4.0; ++i) {
    const auto t = [&](int at) {
      return at == count ? piece.xy.t.high : piece.xy.t.low + piece.xy.t.width() * at / chords;
    };
    most = std::max(most, piece.part(t(i), t(i + 1)).height());
  }
  return most;
}

// Heights go down with the square of the count.
double chords_of(const SpacePiece& piece, double error_mm) {
  for (double chords = 1.0; chords <= kMostOfPoints;) {
    const double height = highest(piece, chords, error_mm);
    if (height <= error_mm) return chords;
    chords = std::max(chords + 1.0, std::floor(chords * std::min(2.0, std::sqrt(height / error_mm))));
  }
  return kMostOfPoints + 1.0;
}

// The pieces of a curve in both planes.
std::vector<SpacePiece> pieces_of(const BoundFamily& bound, const PointCurve& curve) {
  const std::vector<BezierPiece> xy = curves::pieces_of(plane_of(bound, curve, ir::Address::x, ir::Address::y));
  const std::vector<BezierPiece> z = curves::pieces_of(plane_of(bound, curve, ir::Address::z, ir::Address::z));
  std::vector<SpacePiece> out;
  for (std::size_t i = 0; i < xy.size() && i < z.size(); ++i) out.push_back({xy[i], z[i]});
  return out;
}

}  // namespace

std::string fault_of(const BoundFamily& bound, const PointCurve& curve) {
  const std::size_t count = numbers(bound, curve.axes.front().list).size();
  for (const PointCurve::Axis& axis : curve.axes)
    if (numbers(bound, axis.list).size() != count)
      return "the axes of this curve have not as many points as each other";
  if (curve.weights != ir::SymbolId::none && numbers(bound, curve.weights).size() != count)
    return "there must be a weight a point";
  const curves::Nurbs xy = plane_of(bound, curve, ir::Address::x, ir::Address::y);
  const curves::Nurbs z = plane_of(bound, curve, ir::Address::z, ir::Address::z);
  // A curve may stand still in one of both planes.
  std::string in_xy = curves::fault_of(xy);
  if (!in_xy.empty() && (in_xy != "all points are the same" || !curves::fault_of(z).empty())) return in_xy;
  const std::size_t order = xy.order;
  if (!xy.knots.empty() && (xy.knots[order - 1] == xy.knots[order] || xy.knots[count - 1] == xy.knots[count]))
    return "more knots are equal at an end of the curve than its order";
  return {};
}

std::size_t count_of_found(const BoundFamily& bound, const PointCurve& curve, const List& list) {
  const std::size_t points = numbers(bound, curve.axes.front().list).size();
  const std::size_t order = order_of(bound, curve);
  if (!list.counts_chords) return points + order;
  if (curve.is_bezier()) return kCurvePieces;
  return points < order ? 1 : static_cast<std::size_t>(kSpanPieces) * (points - order + 1);
}

std::vector<double> own_knots(const BoundFamily& bound, const PointCurve& curve) {
  return curves::clamped_knots(numbers(bound, curve.axes.front().list).size(), order_of(bound, curve));
}

ChordCounts point_chord_counts(const BoundFamily& bound, const PointCurve& curve) {
  const double error_mm = evaluate(bound.family->arena, curve.error, bound.values).value;
  if (!(error_mm > 0.0)) return {{}, fmt::format("the error of a curve is {}", text::format_shortest(error_mm))};
  const curves::Nurbs plane = plane_of(bound, curve, ir::Address::x, ir::Address::y);
  const std::vector<BezierPiece> xy = curves::pieces_of(plane);
  const std::vector<BezierPiece> z = curves::pieces_of(plane_of(bound, curve, ir::Address::z, ir::Address::z));
  const std::vector<double> knots =
      plane.knots.empty() ? curves::clamped_knots(plane.points.size(), plane.order) : plane.knots;
  const int pieces = curve.is_bezier() ? kCurvePieces : kSpanPieces;
  ChordCounts out;
  double sum = 0.0;
  std::size_t next = 0;
  for (std::size_t span = plane.order - 1; span < plane.points.size(); ++span) {
    const bool is_empty = knots[span] == knots[span + 1];
    for (int i = 0; i < pieces; ++i) {
      if (is_empty || sum > kMostOfPoints) {
        out.by_piece.push_back(0.0);
        continue;
      }
      const SpacePiece whole{xy[next], z[next]};
      const auto t = [&](int at) {
        return at == pieces ? whole.xy.t.high : whole.xy.t.low + whole.xy.t.width() * at / pieces;
      };
      out.by_piece.push_back(chords_of(whole.part(t(i), t(i + 1)), error_mm - kHull_mm));
      sum += out.by_piece.back();
    }
    if (!is_empty) ++next;
  }
  if (sum > kMostOfPoints) return {{}, "this curve takes more than 100,000 chords for its error"};
  return out;
}

// A chord may lie over a knot: then over parts of two pieces and more.
double equal_steps_height(const BoundFamily& bound, const PointCurve& curve, double count) {
  const std::vector<SpacePiece> pieces = pieces_of(bound, curve);
  if (pieces.empty() || !(count >= 1.0)) return 0.0;
  const double low = pieces.front().xy.t.low;
  const double high = pieces.back().xy.t.high;
  double most = 0.0;
  std::size_t piece = 0;
  double from = low;
  const auto steps = static_cast<int>(std::ceil(std::min(count, kMostOfPoints)));
  for (int i = 1; i <= steps; ++i) {
    const double to = i == steps ? high : low + (high - low) * i / count;
    std::vector<SpacePiece> parts;
    for (;; ++piece) {
      const curves::Range t = pieces[piece].xy.t;
      const double end = std::min(t.high, to);
      if (end > std::max(t.low, from)) parts.push_back(pieces[piece].part(std::max(t.low, from), end));
      if (t.high >= to || piece + 1 == pieces.size()) break;
    }
    for (const SpacePiece& one : parts)
      most = std::max(most, one.height_over(parts.front().first(), parts.back().last()));
    from = to;
  }
  return most;
}

}  // namespace dripfeed::family
