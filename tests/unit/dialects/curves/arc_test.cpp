// Lines and arcs against their definitions.
#include "dialects/curves/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "dialects/curves/line.h"

namespace dripfeed::curves {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Segment, FindsItsNearestPoint) {
  const Segment segment{{0, 0}, {10, 0}};
  EXPECT_DOUBLE_EQ(closest_parameter(segment, {3, 5}), 0.3);
  EXPECT_DOUBLE_EQ(distance(segment, {3, -5}), 5.0);
  EXPECT_DOUBLE_EQ(distance(segment, {13, 4}), 5.0);
  EXPECT_DOUBLE_EQ(distance(segment, {-3, 4}), 5.0);
  EXPECT_DOUBLE_EQ(distance(Segment{{1, 1}, {1, 1}}, {4, 5}), 5.0);
}

TEST(ArcBetween, TurnsInBothDirections) {
  const Arc left = arc_between({10, 0}, {0, 10}, {0, 0}, Turn::counterclockwise);
  EXPECT_NEAR(left.sweep, kPi / 2, 1e-15);
  EXPECT_NEAR(left.length(), 5 * kPi, 1e-12);
  const Arc right = arc_between({10, 0}, {0, 10}, {0, 0}, Turn::clockwise);
  EXPECT_NEAR(right.sweep, -1.5 * kPi, 1e-15);
  EXPECT_NEAR(right.at(1.0).x, 10.0, 1e-12);
  EXPECT_NEAR(left.direction(0.0).x, 1.0, 1e-15);
  EXPECT_NEAR(right.direction(0.0).x, -1.0, 1e-15);
}

TEST(ArcBetween, MakesAFullCircleOfEqualEnds) {
  const Arc circle = arc_between({10, 5}, {10, 5}, {5, 5}, Turn::clockwise);
  EXPECT_DOUBLE_EQ(circle.sweep, -2 * kPi);
  EXPECT_DOUBLE_EQ(circle.radius, 5.0);
  const Box box = box_of(circle);
  EXPECT_DOUBLE_EQ(box.z.low, 0.0);
  EXPECT_DOUBLE_EQ(box.x.high, 10.0);
}

TEST(Arc, AgreesWithADenseSampling) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-20.0, 20.0);
  std::uniform_real_distribution<double> angle(-2 * kPi, 2 * kPi);
  for (int i = 0; i < 200; ++i) {
    const Arc arc{{any(random), any(random)}, 1.0 + std::fabs(any(random)), angle(random), angle(random)};
    const Point point{any(random), any(random)};
    double nearest = 1e300;
    Box box{{1e300, -1e300}, {1e300, -1e300}};
    constexpr int kDense = 20000;
    for (int k = 0; k <= kDense; ++k) {
      const Point at = arc.at(static_cast<double>(k) / kDense);
      nearest = std::min(nearest, distance(at, point));
      box.z = {std::min(box.z.low, at.z), std::max(box.z.high, at.z)};
      box.x = {std::min(box.x.low, at.x), std::max(box.x.high, at.x)};
    }
    const double found = distance(arc, point);
    EXPECT_LE(found, nearest + 1e-12);
    EXPECT_NEAR(found, nearest, 0.01);
    const Box exact = box_of(arc);
    EXPECT_NEAR(exact.z.low, box.z.low, 1e-5);
    EXPECT_NEAR(exact.z.high, box.z.high, 1e-5);
    EXPECT_NEAR(exact.x.low, box.x.low, 1e-5);
    EXPECT_NEAR(exact.x.high, box.x.high, 1e-5);
  }
}

}  // namespace
}  // namespace dripfeed::curves
