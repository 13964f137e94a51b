// Derivatives by differences, and chord bounds that hold and are not far from what is reached.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "dialects/curves/chord_bound.h"
#include "dialects/curves/conic.h"
#include "dialects/curves/deviation.h"
#include "dialects/curves/nose.h"

namespace dripfeed::curves {
namespace {

const Conic kRoll{ConicKind::hyperbola, 100, 202.4, {0, 0}};

TEST(Conic, DerivativesAgreeWithDifferences) {
  for (const ConicKind kind : {ConicKind::hyperbola, ConicKind::ellipse}) {
    const Conic conic{kind, 30, 40, {5, 7}};
    for (double z = -30; z <= 40; z += 7) {
      const double h = 1e-4;
      const double before = conic.at(z - h).x, here = conic.at(z).x, after = conic.at(z + h).x;
      EXPECT_NEAR(conic.at(z).slope, (after - before) / (2 * h), 1e-6);
      EXPECT_NEAR(conic.second_derivative(z), (after - 2 * here + before) / (h * h), 1e-4);
    }
  }
}

TEST(Conic, RangesOfTheSecondDerivativeHoldAndAreReached) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-39, 39);
  for (const ConicKind kind : {ConicKind::hyperbola, ConicKind::ellipse}) {
    const Conic conic{kind, -30, 40, {0, 0}};
    for (int i = 0; i < 100; ++i) {
      double low = any(random), high = any(random);
      if (low > high) std::swap(low, high);
      const Range range = conic.second_derivatives(low, high);
      Range seen{1e300, -1e300};
      for (int k = 0; k <= 1000; ++k) {
        const double second = conic.second_derivative(low + (high - low) * k / 1000);
        seen = {std::min(seen.low, second), std::max(seen.high, second)};
      }
      EXPECT_LE(range.low, seen.low + 1e-12 * std::fabs(seen.low));
      EXPECT_GE(range.high, seen.high - 1e-12 * std::fabs(seen.high));
      EXPECT_NEAR(range.low, seen.low, 1e-3 * std::fabs(seen.low));
      EXPECT_NEAR(range.high, seen.high, 1e-3 * std::fabs(seen.high));
    }
  }
}

TEST(Conic, CurvatureOfACircleIsItsRadius) {
  const Conic circle{ConicKind::ellipse, 10, 10, {0, 0}};
  for (const double z : {-10.0, -5.0, 0.0, 9.0}) EXPECT_NEAR(circle.curvature(z), -0.1, 1e-12);
}

TEST(SagittaBound, IsThatOfTheCircleAndNeverMoreThanItsRadius) {
  EXPECT_NEAR(sagitta_bound(0.1, 12.0), 2.0, 1e-12);  // 6-8-10
  EXPECT_DOUBLE_EQ(sagitta_bound(0.1, 100.0), 10.0);
  EXPECT_NEAR(sagitta_bound(1e-9, 1.0), 1.25e-10, 1e-20);
}

TEST(GapBound, HoldsForChordsOfTheHyperbola) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-98, 98);
  const Profile profile{{{curve_of(kRoll, {-98, 98}), 0.01}}};
  for (int i = 0; i < 200; ++i) {
    const double low = any(random);
    const double high = std::min(98.0, low + 0.1 + 20 * std::fabs(any(random)) / 98);
    if (high <= low) continue;
    const Segment chord{{high, kRoll.at(high).x}, {low, kRoll.at(low).x}};
    const double bound = gap_bound(0, 0, kRoll.second_derivatives(low, high), high - low);
    const Deviation found = measure(profile, chord);
    double dense = 0;
    for (int k = 0; k <= 1000; ++k) {
      dense = std::max(dense, closest(profile, chord.at(k / 1000.0)).foot.distance);
    }
    EXPECT_LE(dense, bound);
    EXPECT_GT(dense, 0.7 * bound);
    EXPECT_NEAR(found.largest(), dense, 1e-3 * dense);
    EXPECT_LE(longest_step(kRoll.second_derivative(0), bound), high - low + 1e-9);
  }
}

TEST(Measure, IntegratesMeanAndSquare) {
  // 0.1 mm above a level line for 10 mm, and a wedge from 0 to 0.3 mm.
  const Profile level{{{{{0, 20}, [](double) { return ExplicitPoint{5, 0}; }, {}}, 0.01}}};
  const Deviation flat = measure(level, Segment{{2, 5.1}, {12, 5.1}});
  EXPECT_NEAR(flat.length, 10.0, 1e-12);
  EXPECT_NEAR(flat.integral, 1.0, 1e-12);
  EXPECT_NEAR(flat.integral_square, 0.1, 1e-12);
  EXPECT_NEAR(flat.highest.value, 0.1, 1e-12);
  const Deviation wedge = measure(level, Segment{{0, 5}, {3, 4.7}});
  EXPECT_NEAR(wedge.lowest.value, -0.3, 1e-12);
  EXPECT_NEAR(wedge.integral / wedge.length, 0.15, 1e-12);
  EXPECT_NEAR(wedge.integral_square / wedge.length, 0.03, 1e-12);
  EXPECT_NEAR(wedge.z.low, 0.0, 1e-12);
  EXPECT_NEAR(wedge.z.high, 3.0, 1e-12);
}

TEST(Measure, LeavesOutWhatRunsBeyondTheEnds) {
  const Profile level{{{{{0, 20}, [](double) { return ExplicitPoint{5, 0}; }, {}}, 0.01}}};
  const Deviation out = measure(level, Segment{{15.3, 5}, {24, 9}});
  EXPECT_NEAR(out.overhang, 4.0, 1e-12);
  EXPECT_NEAR(out.highest.value, 4.7 * 4 / 8.7, 1e-7);  // at the end of the profile, not at that of the path
  EXPECT_NEAR(out.z.high, 20.0, 1e-7);
  EXPECT_EQ(measure(level, Segment{{30, 5}, {40, 5}}).points, 0U);
}

TEST(Nose, CutsStraightPathsWhereItsCircleTouches) {
  const Nose nose{0.8, *tip_of(3)};
  // Along z the tip itself is the lowest point.
  const auto turning = std::get<Segment>(*cut_surface(nose, Segment{{0, 50}, {-10, 50}}));
  EXPECT_NEAR(turning.a.x, 50.0, 1e-12);
  EXPECT_NEAR(turning.a.z, 0.8, 1e-12);
  // Facing: along x the tip is the leftmost point.
  const auto facing = std::get<Segment>(*cut_surface(nose, Segment{{0, 50}, {0, 0}}));
  EXPECT_NEAR(facing.a.z, 0.0, 1e-12);
  // On a cone of 45 degrees it misses by r(√2 - 1) upwards, or cuts too deep by r on the other slope.
  const auto rising = std::get<Segment>(*cut_surface(nose, Segment{{0, 50}, {-10, 60}}));
  EXPECT_NEAR(distance(rising, {-5, 55}), 0.8 * (std::sqrt(2.0) - 1), 1e-9);
  const auto falling = std::get<Segment>(*cut_surface(nose, Segment{{0, 50}, {-10, 40}}));
  EXPECT_NEAR(distance(falling, {-5, 45}), 0.8, 1e-9);
  EXPECT_LT(cross(falling.direction(), Point{-5, 45} - falling.a), 0.0);  // the path lies above what is cut
}

TEST(Nose, OffsetsArcsAndRefusesThoseTooTight) {
  const Nose nose{2.0, *tip_of(9)};
  const PathPiece hill = Arc{{0, 0}, 10, 0.5, 1.0};
  EXPECT_NEAR(std::get<Arc>(*cut_surface(nose, hill)).radius, 8.0, 1e-12);
  const PathPiece valley = Arc{{0, 0}, 10, -2.0, 1.0};
  EXPECT_NEAR(std::get<Arc>(*cut_surface(nose, valley)).radius, 12.0, 1e-12);
  EXPECT_FALSE(cut_surface(nose, Arc{{0, 0}, 1.5, 0.5, 1.0}));
  EXPECT_FALSE(tip_of(10));
  EXPECT_FALSE(tip_of(-1));
}

TEST(Nose, CornersAreGapsOrOverlaps) {
  const Nose nose{1.0, {0, 0}};
  const Point left{-1, 0};
  const Point up{-std::sqrt(0.5), std::sqrt(0.5)};
  const Corner valley = corner_of(nose, {0, 50}, left, up);  // from level up a slope: hollow, the nose rounds it
  EXPECT_TRUE(valley.is_gap);
  const Corner hill = corner_of(nose, {0, 50}, up, left);
  EXPECT_FALSE(hill.is_gap);
  EXPECT_NEAR(hill.trimmed, std::tan(std::numbers::pi / 8), 1e-12);
}

}  // namespace
}  // namespace dripfeed::curves
