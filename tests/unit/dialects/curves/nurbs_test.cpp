// NURBS against de Boor's recursion, Bezier pieces against their polynomials, enclosures against samples.
#include "dialects/curves/nurbs.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "dialects/curves/height_field.h"
#include "tests/unit/dialects/curves/de_boor.h"

namespace dripfeed::curves {
namespace {

const std::vector<Point> kPoints = {{25, 50},      {42.7, 24.4},  {70.7, 72.2}, {86.5, 165.4},
                                    {112.5, 38.3}, {132.4, 35.2}, {175, 150}};

Point de_boor(const Nurbs& nurbs, double t) {
  const auto knots = nurbs.knots.empty() ? clamped_knots(nurbs.points.size(), nurbs.order) : nurbs.knots;
  Point sum;
  double weight = 0.0;
  for (std::size_t i = 0; i < nurbs.points.size(); ++i) {
    const double w = nurbs.weights.empty() ? 1.0 : nurbs.weights[i];
    const double n = basis(knots, i, nurbs.order - 1, t);
    sum = sum + n * w * nurbs.points[i];
    weight += n * w;
  }
  return (1.0 / weight) * sum;
}

TEST(Nurbs, IsWhatDeBoorSays) {
  const std::vector<Nurbs> all = {
      {4, kPoints, {}, {}},
      {4, kPoints, {1, 1, 1, 1, 1, 3, 1}, {}},
      {4, kPoints, {1, 3, 1, 1, 1, 3, 1}, {0, 0, 0, 0, 0.3, 0.3, 0.9, 1, 1, 1, 1}},
      {3, kPoints, {1, 0.5, 1, 2, 1, 3, 1}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}},  // not clamped
      {2, kPoints, {}, {}},
      {7, kPoints, {}, {}},
  };
  for (const Nurbs& nurbs : all) {
    ASSERT_EQ(fault_of(nurbs), "");
    const ParametricCurve curve = curve_of(nurbs);
    for (int k = 0; k <= 200; ++k) {
      const double t = curve.t.low + curve.t.width() * k / 200;
      const Point wanted = de_boor(nurbs, t);
      const ParametricPoint found = curve.at(t);
      EXPECT_NEAR(found.point.z, wanted.z, 1e-10) << nurbs.order << " " << t;
      EXPECT_NEAR(found.point.x, wanted.x, 1e-10) << nurbs.order << " " << t;
    }
  }
}

TEST(Nurbs, DerivativesAgreeWithDifferences) {
  const ParametricCurve curve = curve_of({4, kPoints, {1, 3, 1, 1, 1, 3, 1}, {}});
  for (double t = 0.05; t < 3.95; t += 0.13) {
    const double h = 1e-5;
    const ParametricPoint before = curve.at(t - h), here = curve.at(t), after = curve.at(t + h);
    EXPECT_LT(distance(here.derivative, 0.5 / h * (after.point - before.point)), 1e-4);
    EXPECT_LT(distance(here.second, 0.5 / h * (after.derivative - before.derivative)), 0.05);
  }
}

TEST(Nurbs, ARationalQuadraticIsACircle) {
  const double w = std::sqrt(0.5);
  const ParametricCurve quarter = curve_of({3, {{10, 0}, {10, 10}, {0, 10}}, {1, w, 1}, {}});
  for (double t = 0; t <= 1; t += 0.01) {
    EXPECT_NEAR(norm(quarter.at(t).point), 10, 1e-12);
    EXPECT_NEAR(curvature(quarter.at(t)), 0.1, 1e-12);
  }
}

TEST(Nurbs, EnclosuresHoldEverySecondDerivativeAndGetNarrow) {
  std::mt19937 random(5);
  const ParametricCurve curve = curve_of({4, kPoints, {1, 3, 1, 0.4, 1, 3, 1}, {}});
  std::uniform_real_distribution<double> any(0, 1);
  for (int i = 0; i < 300; ++i) {
    const double piece = std::floor(any(random) * 4), a = any(random), b = any(random);
    const double low = piece + std::min(a, b), high = piece + std::max(a, b);
    const Box box = curve.second_derivatives(low, high);
    for (int k = 0; k <= 20; ++k) {
      const Point second = curve.at(low + (high - low) * k / 20).second;
      EXPECT_LE(box.z.low, second.z + 1e-9);
      EXPECT_GE(box.z.high, second.z - 1e-9);
      EXPECT_LE(box.x.low, second.x + 1e-9);
      EXPECT_GE(box.x.high, second.x - 1e-9);
    }
  }
  const Box narrow = curve.second_derivatives(1.5, 1.501);
  const Point there = curve.at(1.5005).second;
  EXPECT_LT(narrow.x.width(), 0.05 * std::fabs(there.x));
  const Box point = curve.second_derivatives(1.5, 1.5);
  EXPECT_EQ(point.x.low, point.x.high);
}

TEST(Nurbs, FaultsAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(fault_of({4, {{0, 0}, {1, 1}, {2, 2}}, {}, {}}), "");
  EXPECT_NE(fault_of({1, kPoints, {}, {}}), "");
  EXPECT_NE(fault_of({17, std::vector<Point>(20, {1, 2}), {}, {}}), "");
  EXPECT_NE(fault_of({4, kPoints, {1, 1, 1, 1, 1, 1}, {}}), "");
  EXPECT_NE(fault_of({4, kPoints, {1, 1, 1, 0, 1, 1, 1}, {}}), "");
  EXPECT_NE(fault_of({4, kPoints, {1, 1, 1, nan, 1, 1, 1}, {}}), "");
  EXPECT_NE(fault_of({4, std::vector<Point>(7, {3, 3}), {}, {}}), "");
  EXPECT_NE(fault_of({2, {{0, 0}, {nan, 1}}, {}, {}}), "");
  EXPECT_NE(fault_of({4, kPoints, {}, {0, 1}}), "");
  EXPECT_NE(fault_of({4, kPoints, {}, {0, 0, 0, 0, 3, 2, 1, 4, 4, 4, 4}}), "");
  EXPECT_NE(fault_of({4, kPoints, {}, std::vector<double>(11, 1.0)}), "");
  EXPECT_NE(fault_of({4,
                      {{0, 0}, {1, 1}, {2, 1}, {3, 0}, {4, 0}, {5, 0}, {6, 0}, {7, 0}},
                      {},
                      {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2}}),
            "");
  EXPECT_EQ(fault_of({4, kPoints, {}, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}}), "");  // bends at 1, and holds together
}

TEST(Bezier, PartsAreTheSameCurve) {
  const BezierPiece piece{{2, 5}, 4, {{{{0, 0}, 1}, {{2, 6}, 2}, {{5, -3}, 1}, {{4, 4}, 0.5}}}};
  const BezierPiece part = piece.part(2.7, 4.1);
  for (double t = 2.7; t <= 4.1; t += 0.1) EXPECT_LT(distance(part.at(t).point, piece.at(t).point), 1e-12);
  EXPECT_LT(distance(piece.at(2).point, {0, 0}), 1e-15);
  EXPECT_LT(distance(piece.at(5).point, {8, 8}), 1e-14);
}

TEST(ClosestFrom, FollowsAPathOfPlaces) {
  const ParametricCurve curve = curve_of({4, kPoints, {}, {}});
  double t = 0;
  for (int i = 0; i <= 400; ++i) {
    const ParametricPoint on = curve.at(4.0 * i / 400);
    const Point normal = unit({-on.derivative.x, on.derivative.z});
    const ParametricFoot foot = closest_from(curve, on.point + 0.5 * normal, t);
    EXPECT_NEAR(foot.distance, 0.5, 1e-9);
    EXPECT_NEAR(foot.t, 4.0 * i / 400, 1e-7);
    t = foot.t;
  }
  const ParametricFoot beyond = closest_from(curve, {20, 55}, 0.1);
  EXPECT_TRUE(beyond.at_end);
  EXPECT_GT(beyond.overhang, 1.0);
}

TEST(ClosestFrom, LeavesACurveAtItsEnd) {
  const ParametricCurve line = curve_of({2, {{0, 0}, {100, 0}}, {}, {}});
  const ParametricFoot last = closest_from(line, {100, 0.01}, 0.5);
  const ParametricFoot beyond = closest_from(line, {101, 0.01}, last.t);
  EXPECT_TRUE(beyond.at_end);
  EXPECT_NEAR(beyond.overhang, 1, 1e-12);
}

TEST(ClosestFrom, StandsStillOnACurveThatDoes) {
  const ParametricCurve point{{0, 1}, [](double) { return ParametricPoint{{3, 4}, {}, {}}; }};
  EXPECT_NEAR(std::fabs(closest_from(point, {0, 0}, 0.5).distance), 5, 1e-12);
}

TEST(HeightField, TheLastOneCounts) {
  const auto all = [](double) { return Range{-10, 10}; };
  const std::vector<HeightField> fields = {
      {{-10, 10}, all, [](double, double) { return 0.0; }, 0.1},
      {{-5, 5},
       [](double x) { return Range{-std::sqrt(25 - x * x), std::sqrt(25 - x * x)}; },
       [](double, double) { return -3.0; },
       0.2}};
  EXPECT_EQ(surface_at(fields, 0, 0)->z, -3);
  EXPECT_EQ(surface_at(fields, 4, 4)->z, 0);
  EXPECT_EQ(surface_at(fields, 4, 4)->tolerance, 0.1);
  EXPECT_FALSE(surface_at(fields, 11, 0));
}

}  // namespace
}  // namespace dripfeed::curves
