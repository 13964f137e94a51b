// What is logged of cuts, put together again, is the stock that they leave; and a long log is thinned out, not cut off.
#include "checks/gouge/removal.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "checks/gouge/gouge.h"
#include "checks/gouge/milling.h"
#include "tests/unit/checks/motions.h"

namespace dripfeed::gouge {
namespace {

using checks::takes_tool;

constexpr double kGone = -HUGE_VAL;

ir::Motion line_cut(double x, double y, double z, double to_x, double to_y, double to_z, std::uint64_t ordinal) {
  ir::Motion motion;
  motion.kind = ir::MotionKind::linear;
  motion.place = {0, static_cast<std::uint32_t>(ordinal + 1), ordinal};
  motion.start = {x, y, z};
  motion.end = {to_x, to_y, to_z};
  motion.spindle = ir::SpindleState::clockwise;
  return motion;
}

// Block k lasts from moment k to k + 1.
RemovalLog::Moments by_block(const ir::Motion& motion) {
  const auto first = static_cast<double>(motion.place.ordinal);
  return {first, first + 1.0};
}

TEST(Removal, OfAMapIsWhatTheCutsLeave) {
  RemovalLog log(by_block);
  MillingSettings settings;
  settings.stock = Blank{{0, 40}, {0, 20}, {-10, 0}};
  settings.tools = {{.number = 1, .diameter_mm = 8}};
  settings.step_mm = 0.5;
  settings.log = &log;
  Milling check(settings);
  std::vector<double> heights = check.map()->grid().heights;
  check.consume({{takes_tool(1), line_cut(0, 10, -2, 40, 10, -2, 0), line_cut(40, 10, -5, 0, 10, -5, 1),
                  line_cut(20, 10, -5, 20, 10, -11, 2)}});
  double before = 0.0;
  for (const Removal& one : log.finish()) {
    EXPECT_GE(one.moment, before);
    before = one.moment;
    EXPECT_LE(one.moment, 3.0);
    heights[one.place] = static_cast<double>(one.height_mm);
  }
  const HeightMap::Grid left = check.map()->grid();
  EXPECT_EQ(heights, left.heights);
  EXPECT_EQ(left.columns, 80U);
  EXPECT_EQ(left.heights[20 * 80 + 40], kGone) << "drilled through";
  EXPECT_EQ(left.heights[20 * 80 + 2], -5.0);
  EXPECT_EQ(left.heights[2], 0.0);
  EXPECT_TRUE(left.nominal.empty());
}

TEST(Removal, ALongCutTakesAwayAsItPasses) {
  RemovalLog log(by_block);
  MillingSettings settings;
  settings.stock = Blank{{0, 100}, {0, 10}, {-10, 0}};
  settings.tools = {{.number = 1, .diameter_mm = 4}};
  settings.step_mm = 1.0;
  settings.log = &log;
  Milling check(settings);
  check.consume({{takes_tool(1), line_cut(0, 5, -1, 100, 5, -1, 7)}});
  for (const Removal& one : log.finish()) {
    const double x = static_cast<double>(one.place % 100) + 0.5;
    EXPECT_NEAR(one.moment, 7.0 + x / 100.0, 0.03) << x;
  }
}

TEST(Removal, OfABarIsWhatTheCutsLeave) {
  RemovalLog log(by_block);
  Settings settings;
  settings.stock = Cylinder{.diameter_mm = 60, .z_low_mm = -50, .z_high_mm = 0};
  settings.tools = {{.number = 1, .nose_radius_mm = 0.8, .tip = 3}};
  settings.step_mm = 0.1;
  settings.log = &log;
  Gouge check(settings);
  std::vector<double> radii = check.stock()->radii();
  check.consume({{takes_tool(1), line_cut(50, 0, 5, 50, 0, -30, 0), line_cut(44, 0, -30, 50, 0, -40, 1)}});
  for (const Removal& one : log.finish()) radii[one.place] = static_cast<double>(one.height_mm);
  ASSERT_NE(check.stock(), nullptr);
  for (std::size_t i = 0; i < radii.size(); ++i) EXPECT_NEAR(radii[i], check.stock()->radii()[i], 1e-5);
  EXPECT_NEAR(check.stock()->radii()[400], 25.0, 1e-9);
}

TEST(Removal, IsThinnedOutAndKeepsWhatIsLeft) {
  constexpr std::size_t kPlaces = 50;
  constexpr int kPasses = 400;
  RemovalLog log(by_block, 2000);
  ir::Motion motion;
  for (int pass = 0; pass < kPasses; ++pass) {
    motion.place.ordinal = static_cast<std::uint64_t>(pass);
    log.begin(motion, 0.0, 1.0);
    for (std::size_t place = 0; place < kPlaces; ++place)
      log.take(place, -0.01 * (pass + 1), 0.02 * static_cast<double>(place));
  }
  std::vector<float> heights(kPlaces, 0.0F);
  const std::vector<Removal> all = log.finish();
  EXPECT_LE(all.size(), 2000U);
  EXPECT_GT(all.size(), 500U);
  EXPECT_GT(log.span(), 0.0);
  for (const Removal& one : all) {
    EXPECT_LE(one.height_mm, heights[one.place]) << "it never grows";
    heights[one.place] = one.height_mm;
  }
  for (const float height : heights) EXPECT_FLOAT_EQ(height, -4.0F);
}

}  // namespace
}  // namespace dripfeed::gouge
