// What a map leaves out of a cut that goes on from the one before must not show, and a column of surfaces is the
// surfaces.
#include "checks/gouge/height_map.h"

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

}  // namespace
}  // namespace dripfeed::gouge
