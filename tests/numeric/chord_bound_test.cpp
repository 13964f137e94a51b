// Proved chord bounds against dense sampling: on conics, Bezier and NURBS curves, for chords and for arcs as paths,
// with ends on the curve and next to it. Never below what sampling finds, never more than 5 % above.
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "dialects/curves/conic.h"
#include "dialects/curves/gap.h"
#include "dialects/curves/nurbs.h"

namespace dripfeed::curves {
namespace {

ParametricCurve parametric(const Conic& conic, Range z) {
  return {z,
          [conic](double t) {
            const ExplicitPoint at = conic.at(t);
            return ParametricPoint{{t, at.x}, {1, at.slope}, {0, conic.second_derivative(t)}};
          },
          [conic](double low, double high) { return Box{{0, 0}, conic.second_derivatives(low, high)}; },
          {}};
}

// Largest distance of a place of the path from the curve. The foot is sought with a ternary search among samples, with
// nothing of what is tested.
double oracle(const ParametricCurve& curve, Range t, const PathPiece& piece) {
  constexpr int kPlaces = 400;
  double largest = 0.0;
  for (int i = 0; i <= kPlaces; ++i) {
    const Point point = point_at(piece, static_cast<double>(i) / kPlaces);
    const double guess = t.low + t.width() * i / kPlaces;
    double low = std::max(t.low, guess - 0.3 * t.width()), high = std::min(t.high, guess + 0.3 * t.width());
    for (int step = 0; step < 80; ++step) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      if (distance(curve.at(a).point, point) < distance(curve.at(b).point, point)) {
        high = b;
      } else {
        low = a;
      }
    }
    largest = std::max(largest, distance(curve.at(0.5 * (low + high)).point, point));
  }
  return largest;
}

struct Sample {
  const char* name;
  ParametricCurve curve;
  double shortest;  // in t
  double longest;
};

std::vector<Sample> samples() {
  const std::vector<Point> points = {{25, 50},      {42.7, 24.4},  {70.7, 72.2}, {86.5, 165.4},
                                     {112.5, 38.3}, {132.4, 35.2}, {175, 150}};
  std::vector<Sample> all = {
      {"hyperbola", parametric({ConicKind::hyperbola, 100, 202.4, {0, 0}}, {-98, 98}), 1, 30},
      {"steep hyperbola", parametric({ConicKind::hyperbola, 40, 20, {5, 3}}, {-60, 60}), 1, 15},
      {"ellipse", parametric({ConicKind::ellipse, 30, 50, {0, 0}}, {-45, 45}), 1, 15},
      {"hollow ellipse", parametric({ConicKind::ellipse, -25, 60, {0, 70}}, {-50, 50}), 1, 20},
      {"cubic Bezier", curve_of({4, {{0, 0}, {10, 40}, {50, 45}, {70, 0}}, {}, {}}), 0.01, 0.2},
      {"quintic Bezier", curve_of({6, {{0, 0}, {10, 30}, {30, -20}, {50, 45}, {60, 10}, {80, 20}}, {}, {}}), 0.01, 0.1},
      {"rational Bezier", curve_of({4, {{0, 0}, {10, 40}, {50, 45}, {70, 0}}, {1, 3, 0.5, 1}, {}}), 0.01, 0.1},
  };
  for (const std::vector<double>& weights : {std::vector<double>{}, {1, 1, 1, 1, 1, 3, 1}, {1, 3, 1, 1, 1, 3, 1}}) {
    all.push_back({"NURBS", curve_of({4, points, weights, {}}), 0.01, 0.15});
  }
  return all;
}

double bound_of(const ParametricCurve& curve, Range t, const PathPiece& piece) {
  const auto range = gap_range(curve, t, piece);
  if (!range) return -1.0;
  const double ends = std::max(distance(curve.at(t.low).point, point_at(piece, 0.0)),
                               distance(curve.at(t.high).point, point_at(piece, 1.0)));
  return std::max({std::fabs(range->low), std::fabs(range->high), ends});
}

// Chords of a curve from a random place, over a random length.
void try_chords(const std::function<PathPiece(const ParametricCurve&, Range)>& path_of, int count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(0, 1);
  for (const Sample& sample : samples()) {
    for (int i = 0; i < count; ++i) {
      const double width = sample.shortest + any(random) * (sample.longest - sample.shortest);
      const double low = sample.curve.t.low + any(random) * (sample.curve.t.width() - width);
      const Range t{low, low + width};
      const PathPiece piece = path_of(sample.curve, t);
      const double bound = bound_of(sample.curve, t, piece);
      const double seen = oracle(sample.curve, t, piece);
      EXPECT_GE(bound, seen - 1e-9) << sample.name << " from " << low << " over " << width;
      EXPECT_LE(bound, 1.05 * seen + (std::holds_alternative<Arc>(piece) ? 2e-6 : 2e-8))
          << sample.name << " from " << low << " over " << width;
    }
  }
}

TEST(ChordBound, OfChordsWithTheirEndsOnTheCurve) {
  try_chords(
      [](const ParametricCurve& curve, Range t) { return Segment{curve.at(t.low).point, curve.at(t.high).point}; }, 40);
}

TEST(ChordBound, OfLinesNextToTheCurve) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> off(-0.5, 0.5);
  try_chords(
      [&](const ParametricCurve& curve, Range t) {
        // Next to it along the normals, so that the feet of both ends are where they should be.
        const auto next_to_it = [&](double at) {
          const ParametricPoint on = curve.at(at);
          return on.point + off(random) * unit({-on.derivative.x, on.derivative.z});
        };
        return Segment{next_to_it(t.low), next_to_it(t.high)};
      },
      40);
}

TEST(ChordBound, OfArcsThroughThreePlaces) {
  try_chords(
      [](const ParametricCurve& curve, Range t) -> PathPiece {
        const Point a = curve.at(t.low).point, b = curve.at(0.5 * (t.low + t.high)).point, c = curve.at(t.high).point;
        const double twice = 2 * cross(b - a, c - a);
        if (std::fabs(twice) < 1e-6) return Segment{a, c};
        const Point ab = b - a, ac = c - a;
        const Point center =
            a + 1.0 / twice * Point{dot(ab, ab) * ac.x - dot(ac, ac) * ab.x, dot(ac, ac) * ab.z - dot(ab, ab) * ac.z};
        return arc_between(a, c, center, twice > 0 ? Turn::counterclockwise : Turn::clockwise);
      },
      20);
}

TEST(ChordBound, NothingWhereNothingIsProved) {
  const ParametricCurve curve = samples()[4].curve;
  EXPECT_FALSE(gap_range(curve, {0.2, 0.3}, Segment{{1, 1}, {1, 1}}));
  ParametricCurve bare = curve;
  bare.second_derivatives = {};
  EXPECT_FALSE(gap_range(bare, {0.2, 0.3}, Segment{{0, 0}, {9, 9}}));
  bare.second_derivatives = [](double, double) {
    const double infinity = std::numeric_limits<double>::infinity();
    return Box{{-infinity, infinity}, {-infinity, infinity}};
  };
  EXPECT_FALSE(gap_range(bare, {0.2, 0.3}, Segment{{0, 0}, {9, 9}}));
  EXPECT_FALSE(gap_range(curve, {0.0, 1.0}, Arc{curve.at(0.5).point, 5, 0, 1}));  // the curve runs through the centre
}

}  // namespace
}  // namespace dripfeed::curves
