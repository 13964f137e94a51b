// What a map leaves out of a cut that goes on from the one before must not show, and a column of surfaces is the
// surfaces.
#include "checks/gouge/height_map.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/curves/surface_column.h"

namespace dripfeed::gouge {
namespace {

const std::vector<curves::HeightField> kNominal = {
    {{-20, 20}, [](double) { return curves::Range{-20, 20}; }, [](double, double) { return 0.0; }, 0.05},
    {{-15, 15},
     [](double x) { return x > 10 ? curves::Range{1, -1} : curves::Range{-15, x}; },
     [](double x, double y) { return -4.0 - 0.1 * x + 0.05 * y; },
     0.02}};

// The same cuts, once as they come and once with a cut next to the map between them, which breaks every chain.
TEST(HeightMap, ACutThatGoesOnLeavesNothing) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-22, 22);
  std::uniform_real_distribution<double> down(-7, 1);
  for (const Cutter cutter : {Cutter{5, 0}, Cutter{0.3, 0}, Cutter{5, 5}, Cutter{5, 1}}) {
    HeightMap chained({{-20, 20}, {-20, 20}, {-10, 0}}, 0.25);
    HeightMap broken = chained;
    chained.set_nominal(kNominal);
    broken.set_nominal(kNominal);
    Point3 at{any(random), any(random), down(random)};
    for (int i = 0; i < 400; ++i) {
      Point3 to{at.x + any(random) / 10, at.y + any(random) / 10, i % 9 == 0 ? down(random) : at.z};
      if (i % 40 == 0) to = {any(random), any(random), at.z};
      if (i % 7 == 0) to = {at.x, at.y, down(random)};  // upright
      if (i % 23 == 0) at = {any(random), any(random), at.z};
      (void)broken.cut(cutter, {100, 100, -1}, {101, 100, -1});
      const Depth one = chained.cut(cutter, at, to);
      const Depth other = broken.cut(cutter, at, to);
      EXPECT_EQ(one.mm, other.mm);
      EXPECT_EQ(one.x, other.x);
      EXPECT_EQ(one.y, other.y);
      at = to;
    }
    for (double x = -19.9; x < 20; x += 0.25)
      for (double y = -19.9; y < 20; y += 0.25) EXPECT_EQ(chained.height(x, y), broken.height(x, y)) << x << " " << y;
  }
}

TEST(HeightMap, AColumnOfSurfacesIsTheSurfaces) {
  for (double x = -21; x < 21; x += 0.7) {
    const curves::SurfaceColumn column(kNominal, x);
    for (double y = -21; y < 21; y += 0.7) {
      const auto wanted = curves::surface_at(kNominal, x, y);
      const auto found = column.at(y);
      ASSERT_EQ(found.has_value(), wanted.has_value()) << x << " " << y;
      if (!wanted) continue;
      EXPECT_EQ(found->z, wanted->z);
      EXPECT_EQ(found->tolerance, wanted->tolerance);
    }
  }
}

// A circle at once against many chords, of a cutter that is larger, and smaller, by more than they lie apart.
TEST(HeightMap, ACircleIsItsChords) {
  constexpr double kApart_mm = 1e-4;
  constexpr int kChords = 4000;  // of a circle of 20 mm: 6e-6 mm
  std::mt19937 random(5);        // NOLINT(cert-msc32-c,cert-msc51-cpp): the same circles in every run
  std::uniform_real_distribution<double> any(-15, 15);
  std::uniform_real_distribution<double> size(0.1, 20);
  for (int i = 0; i < 60; ++i) {
    const HeightMap blank({{-20, 20}, {-20, 20}, {-10, 0}}, 0.25);
    const double center_x = any(random);
    const double center_y = any(random);
    const double radius = size(random);
    const double cutter = size(random) / 2;
    const double z = any(random) - 2.0;  // above the blank, in it and below it
    HeightMap chords = blank;
    const auto at = [&](int n) {
      const double angle = 2.0 * std::numbers::pi * n / kChords;
      return Point3{center_x + radius * std::cos(angle), center_y + radius * std::sin(angle), z};
    };
    for (int n = 0; n < kChords; ++n) (void)chords.cut({cutter, 0}, at(n), at(n + 1));
    HeightMap larger = blank;
    (void)larger.cut_circle({cutter + kApart_mm, 0}, at(0), center_x, center_y);
    HeightMap smaller = blank;
    (void)smaller.cut_circle({cutter - kApart_mm, 0}, at(0), center_x, center_y);
    for (double x = -19.9; x < 20; x += 0.25)
      for (double y = -19.9; y < 20; y += 0.25) {
        ASSERT_LE(larger.height(x, y), chords.height(x, y)) << i << " at " << x << " " << y;
        ASSERT_GE(smaller.height(x, y), chords.height(x, y)) << i << " at " << x << " " << y;
      }
  }
}

// The deepest place below the nominal; and the straight cut that goes on from the circle.
TEST(HeightMap, ACircleIsJudged) {
  HeightMap map({{-20, 20}, {-20, 20}, {-10, 0}}, 0.25);
  map.set_nominal(kNominal);
  const Depth none = map.cut_circle({2, 0}, {18, 0, 0}, 0, 0);
  EXPECT_EQ(none.mm, 0.0);
  const Depth depth = map.cut_circle({2, 0}, {18, 0, -1}, 0, 0);
  EXPECT_DOUBLE_EQ(depth.mm, 1.0);
  EXPECT_NEAR(std::hypot(depth.x, depth.y), 18.0, 2.0);
  EXPECT_EQ(map.cut_circle({2, 0}, {18, 0, -1}, 0, 0).mm, 0.0) << "the ring has it";
  (void)map.cut({2, 0}, {18, 0, -1}, {12, 0, -1});
  EXPECT_EQ(map.height(13, 0.1), -1.0);
  EXPECT_EQ(map.height(9.9, 0.1), 0.0);
  EXPECT_DOUBLE_EQ(map.cut({2, 0}, {18, 0, -3}, {18, 3, -3}).mm, 3.0);
}

}  // namespace
}  // namespace dripfeed::gouge
