// Nearest points of explicit and parametric curves against a dense sampling, on tame and on wild curves.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "dialects/curves/conic.h"
#include "dialects/curves/explicit_curve.h"
#include "dialects/curves/parametric_curve.h"
#include "dialects/curves/profile.h"

namespace dripfeed::curves {
namespace {

// Distance to the polyline through n + 1 places of the curve: off by at most the chord error.
double dense_distance(const ExplicitCurve& curve, Point point, int n = 20000) {
  double nearest = 1e300;
  Point before{curve.z.low, curve.at(curve.z.low).x};
  for (int i = 1; i <= n; ++i) {
    const double z = curve.z.low + 0.5 * curve.z.width() * (1 - std::cos(std::numbers::pi * i / n));  // dense at ends
    const Point here{z, curve.at(z).x};
    const Point along = here - before;
    const double t = std::clamp(dot(point - before, along) / dot(along, along), 0.0, 1.0);
    nearest = std::min(nearest, distance(before + t * along, point));
    before = here;
  }
  return nearest;
}

TEST(Closest, IsExactOnALine) {
  const ExplicitCurve line{{-10, 10}, [](double z) { return ExplicitPoint{5 + 0.75 * z, 0.75}; }, {}};
  const Foot foot = closest(line, {0.0, 6.25});
  EXPECT_NEAR(foot.distance, 1.0, 1e-12);
  EXPECT_NEAR(foot.z, 0.6, 1e-9);
  EXPECT_EQ(foot.beyond, Beyond::none);
  EXPECT_NEAR(closest(line, {0.0, 3.75}).distance, -1.0, 1e-12);
  EXPECT_EQ(closest(line, {2.0, 6.5}).distance, 0.0);
}

TEST(Closest, SaysWhenAPointLiesBeyondAnEnd) {
  const ExplicitCurve line{{0, 10}, [](double) { return ExplicitPoint{5, 0}; }, {}};
  const Foot high = closest(line, {13, 6});
  EXPECT_EQ(high.beyond, Beyond::high);
  EXPECT_DOUBLE_EQ(high.overhang, 3.0);
  EXPECT_DOUBLE_EQ(high.distance, std::hypot(3.0, 1.0));
  const Foot low = closest(line, {-2, 4});
  EXPECT_EQ(low.beyond, Beyond::low);
  EXPECT_DOUBLE_EQ(low.overhang, 2.0);
  EXPECT_LT(low.distance, 0.0);
  EXPECT_EQ(closest(line, {0, 6}).beyond, Beyond::none);
  EXPECT_EQ(closest(line, {10, 6}).beyond, Beyond::none);
}

TEST(Closest, AgreesWithADenseSamplingOnConics) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit_range(0.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    const bool is_ellipse = i % 2 == 0;
    const Conic conic{is_ellipse ? ConicKind::ellipse : ConicKind::hyperbola,
                      5 + 100 * unit_range(random),
                      50 + 200 * unit_range(random),
                      {0, 0}};
    const double reach = is_ellipse ? conic.half_axis_z : 2 * conic.half_axis_z;
    ExplicitCurve curve = curve_of(conic, {-reach, reach});
    if (i % 3 == 0) curve.second_derivatives = nullptr;
    const double z = (2.4 * unit_range(random) - 1.2) * reach;
    const double span = i % 5 == 0 ? 100.0 : 0.5;
    const Point point{z, curve.at(std::clamp(z, -reach, reach)).x + span * (unit_range(random) - 0.5)};
    const Foot foot = closest(curve, point);
    const double dense = dense_distance(curve, point);
    EXPECT_NEAR(std::fabs(foot.distance), dense, 1e-5) << i;
    EXPECT_NEAR(distance(foot.point(), point), std::fabs(foot.distance), 1e-12);
  }
}

TEST(Closest, FindsTheRightBendOfAWave) {
  const ExplicitCurve wave{{-20, 20}, [](double z) { return ExplicitPoint{4 * std::sin(z), 4 * std::cos(z)}; }, {}};
  std::mt19937 random(13);
  std::uniform_real_distribution<double> z(-18, 18);
  std::uniform_real_distribution<double> x(-6, 6);
  for (int i = 0; i < 500; ++i) {
    const Point point{z(random), x(random)};
    const Foot foot = closest(wave, point);
    EXPECT_NEAR(std::fabs(foot.distance), dense_distance(wave, point), 1e-5) << point.z << ' ' << point.x;
    EXPECT_EQ(foot.distance > 0, point.x > 4 * std::sin(point.z));
  }
}

TEST(Closest, BearsAVerticalTangentAtTheEnd) {
  const ExplicitCurve half = curve_of({ConicKind::ellipse, 10, 10, {0, 0}}, {-10, 10});
  EXPECT_NEAR(closest(half, {12, 0}).distance, 2.0, 1e-9);
  EXPECT_NEAR(std::fabs(closest(half, {10, 0}).distance), 0.0, 1e-12);
  EXPECT_NEAR(closest(half, {0, 12}).distance, 2.0, 1e-9);
  EXPECT_NEAR(closest(half, {8, 8}).distance, std::sqrt(128.0) - 10, 1e-9);
  EXPECT_NEAR(closest(half, {0.001, 0}).distance, 0.001 - 10, 1e-9);
}

TEST(ParametricClosest, AgreesWithTheExplicitForm) {
  const double a = 100, b = 202.4;
  const ExplicitCurve curve = curve_of({ConicKind::hyperbola, a, b, {0, 0}}, {-98, 98});
  const double end = std::atan(98 / b);
  const ParametricCurve same{{-end, end}, [=](double t) {
                               const double c = std::cos(t), s = std::sin(t);
                               return ParametricPoint{{b * s / c, a / c},
                                                      {b / (c * c), a * s / (c * c)},
                                                      {2 * b * s / (c * c * c), a * (1 + s * s) / (c * c * c)}};
                             }};
  std::mt19937 random(17);
  std::uniform_real_distribution<double> z(-97, 97);
  std::uniform_real_distribution<double> away(-3, 3);
  for (int i = 0; i < 200; ++i) {
    const double at = z(random);
    const Point point{at, curve.at(at).x + away(random)};
    const Foot expected = closest(curve, point);
    const ParametricFoot found = closest(same, point);
    if (expected.beyond != Beyond::none) continue;
    EXPECT_NEAR(found.distance, expected.distance, 1e-9);
    EXPECT_NEAR(found.point.z, expected.z, 1e-5);
    EXPECT_NEAR(curvature(same.at(found.t)), Conic({ConicKind::hyperbola, a, b, {0, 0}}).curvature(found.point.z),
                1e-9);
  }
}

TEST(Profile, JoinsPiecesAndEndsAtTheOuterEndsOnly) {
  const auto level = [](double x) { return [x](double) { return ExplicitPoint{x, 0}; }; };
  const Profile steps{{{{{0, 10}, level(5), {}}, 0.1}, {{{10, 20}, level(8), {}}, 0.2}}};
  EXPECT_DOUBLE_EQ(closest(steps, {4, 5.5}).foot.distance, 0.5);
  const ProfileFoot corner = closest(steps, {9.5, 8.0});  // next to the step's edge, above the lower piece
  EXPECT_DOUBLE_EQ(corner.foot.distance, 0.5);
  EXPECT_EQ(corner.foot.beyond, Beyond::none);
  EXPECT_EQ(corner.piece, 1U);
  EXPECT_LT(closest(steps, {15, 7.0}).foot.distance, 0.0);
  EXPECT_EQ(closest(steps, {22, 8.0}).foot.beyond, Beyond::high);
  EXPECT_DOUBLE_EQ(closest(steps, {22, 8.0}).foot.overhang, 2.0);
  EXPECT_EQ(piece_at(steps, 10.0)->tolerance, 0.2);
  EXPECT_EQ(piece_at(steps, 20.1), nullptr);
}

}  // namespace
}  // namespace dripfeed::curves
