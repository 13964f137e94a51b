// A bar, a nominal, and moves that do or just do not touch.
#include "checks/gouge/gouge.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/checks/motions.h"

namespace dripfeed::gouge {
namespace {

using checks::takes_tool;
using text::DiagnosticId;

ir::Motion move(ir::MotionKind kind, double from_x, double from_z, double x, double z, std::uint32_t line = 3) {
  ir::Motion motion;
  motion.kind = kind;
  motion.plane = ir::Plane::zx;
  motion.place = {0, line, line};
  motion.start[0] = from_x;
  motion.start[2] = from_z;
  motion.end[0] = x;
  motion.end[2] = z;
  return motion;
}
ir::Motion rapid(double from_x, double from_z, double x, double z) {
  return move(ir::MotionKind::rapid, from_x, from_z, x, z);
}
ir::Motion cut(double from_x, double from_z, double x, double z) {
  return move(ir::MotionKind::linear, from_x, from_z, x, z);
}

// A bar of diameter 100 from z -50 to 0, to become diameter 80 from z -30 to 0.
Settings bar() {
  Settings settings;
  settings.stock = Cylinder{100, -50, 0};
  settings.nominal = {
      {{{{-30, 0}, [](double) { return curves::ExplicitPoint{40, 0}; }, [](double, double) { return curves::Range{}; }},
        0.02}}};
  settings.tools = {{.number = 1, .nose_radius_mm = 0.8, .tip = 3}, {.number = 2, .nose_radius_mm = 0.4, .tip = 2}};
  return settings;
}

Report run(const Settings& settings, const std::vector<ir::Motion>& motions) {
  Gouge check(settings);
  check.consume(motions);
  return check.finish();
}

TEST(Gouge, ARapidIntoTheBarIsSeenWithItsDepth) {
  const Report report = run(bar(), {rapid(120, 10, 90, -40)});
  ASSERT_EQ(report.findings.count(DiagnosticId::rapid_into_stock), 1U);
  EXPECT_NEAR(report.deepest_rapid_mm, 5.0, 0.02);
  EXPECT_EQ(report.findings.kept()[0].place.line, 3U);
  EXPECT_TRUE(run(bar(), {rapid(120, 10, 100, 0.5), rapid(100, 0.5, 100, -40)}).findings.empty());
  EXPECT_TRUE(run(bar(), {rapid(90, 10, 90, 0)}).findings.empty());  // just to the face
  EXPECT_EQ(run(bar(), {rapid(90, 10, 90, -0.01)}).findings.count(DiagnosticId::rapid_into_stock), 1U);
}

TEST(Gouge, APlungeBetweenTwoPlacesIsSeen) {
  EXPECT_EQ(run(bar(), {rapid(120, -40.0071, 98, -40.0071)}).findings.count(DiagnosticId::rapid_into_stock), 1U);
  EXPECT_TRUE(run(bar(), {rapid(120, -40.0071, 100, -40.0071)}).findings.empty());
}

TEST(Gouge, CutsClearThePathForRapids) {
  const ir::Motion back = rapid(84, -20, 84, 5);
  EXPECT_EQ(run(bar(), {back}).findings.count(DiagnosticId::rapid_into_stock), 1U);
  EXPECT_TRUE(run(bar(), {cut(84, 5, 84, -20), back}).findings.empty());
  EXPECT_EQ(run(bar(), {cut(84, 5, 84, -20), rapid(84, -20, 84, -21)}).findings.count(DiagnosticId::rapid_into_stock),
            1U);
}

TEST(Gouge, RapidsIntoThePartAreWorse) {
  const Report report = run(bar(), {rapid(120, -10, 70, -10)});
  EXPECT_EQ(report.findings.count(DiagnosticId::rapid_into_nominal), 1U);
  EXPECT_EQ(report.findings.count(DiagnosticId::rapid_into_stock), 0U);
  EXPECT_NEAR(report.deepest_rapid_mm, 5.0, 1e-6);
}

TEST(Gouge, ACutBelowTheNominalIsMeasuredAgainstItsTolerance) {
  EXPECT_TRUE(run(bar(), {cut(80 - 0.039, 5, 80 - 0.039, -20)}).findings.empty());
  const Report report = run(bar(), {cut(80 - 0.041, 5, 80 - 0.041, -20)});
  ASSERT_EQ(report.findings.count(DiagnosticId::cut_below_nominal), 1U);
  EXPECT_NEAR(report.deepest_cut_mm, 0.0205, 1e-9);
  EXPECT_TRUE(run(bar(), {cut(70, -31, 70, -45)}).findings.empty());  // next to the nominal
}

TEST(Gouge, TheNoseReachesAsFarAsItsCircle) {
  // Tip 3 at z -29.5: the nose's centre at -28.7, its lowest point there, its left side at -29.5.
  const std::vector<ir::Motion> motions = {takes_tool(1), cut(80.1, 5, 80.1, -29.5), rapid(80.1, -29.5, 200, -29.5)};
  EXPECT_TRUE(run(bar(), motions).findings.empty());
  EXPECT_NEAR(run(bar(), {takes_tool(1), cut(78, 5, 78, -20)}).deepest_cut_mm, 1.0, 1e-9);
  // A rapid that passes next to the bar's end by less than the nose.
  EXPECT_TRUE(run(bar(), {takes_tool(1), rapid(200, 0.01, 0, 0.01)}).findings.empty());
  EXPECT_FALSE(run(bar(), {takes_tool(1), rapid(200, -0.1, 0, -0.1)}).findings.empty());
}

TEST(Gouge, ARapidThatBendsIsAWarning) {
  // From radius 80 over the bar to radius 20 before its face: the line is at 56 over the face's edge. With both axes at
  // one speed it goes down at 45 degrees and meets the bar.
  const ir::Motion path = rapid(160, -30, 40, 45);
  Settings settings = bar();
  EXPECT_TRUE(run(settings, {path}).findings.empty());
  settings.rapid_x_mm_min = settings.rapid_z_mm_min = 10000;
  EXPECT_TRUE(run(settings, {rapid(160, -30, 100, 0)}).findings.empty());  // 45 degrees is a line
  const Report report = run(settings, {rapid(160, -30, 60, 45)});
  EXPECT_EQ(report.findings.count(DiagnosticId::rapid_into_stock), 0U);
  EXPECT_TRUE(report.findings.empty());  // 50 down, 45 along: at z 0 still at radius 50
  settings.rapid_x_mm_min = 20000;
  EXPECT_EQ(run(settings, {path}).findings.count(DiagnosticId::rapid_may_enter_stock), 1U);
  EXPECT_EQ(run(settings, {path}).findings.count(DiagnosticId::rapid_into_stock), 0U);
}

TEST(Gouge, SaysWhatItLeavesOut) {
  ir::Motion home = rapid(0, 0, 0, 0);
  home.machine_coordinates = true;
  const Report report = run(bar(), {takes_tool(9), home, takes_tool(2), cut(20, 5, 20, -20)});
  EXPECT_TRUE(report.findings.empty());
  EXPECT_GE(report.not_checked.list().size(), 4U);  // rapid speeds, tool 9, machine coordinates, bore
}

TEST(RemainingStock, AgreesWithDiscsSetDownDensely) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> z(-52, 2);
  std::uniform_real_distribution<double> x(30, 55);
  std::uniform_real_distribution<double> sweep(-6, 6);
  RemainingStock stock(50, {-50, 0}, 0.5);
  std::vector<double> dense(101, 50.0);
  for (int i = 0; i < 60; ++i) {
    const curves::Nose nose{i % 3 * 0.6, {-1, -1}};
    const curves::PathPiece path =
        i % 2 == 0 ? curves::PathPiece{curves::Segment{{z(random), x(random)}, {z(random), x(random)}}}
                   : curves::PathPiece{curves::Arc{{z(random), 45}, 3, sweep(random), sweep(random)}};
    double touched = 0;
    for (std::size_t place = 0; place < dense.size(); ++place) {
      const double at = -50 + 0.5 * static_cast<double>(place);
      double low = 1e300;
      for (int k = 0; k <= 4000; ++k) {
        const curves::Point center = nose.center(curves::point_at(path, k / 4000.0));
        const double reach = nose.radius > 0 ? nose.radius : 0.01;
        if (std::fabs(center.z - at) > reach) continue;
        low = std::min(
            low, center.x - std::sqrt(std::max(0.0, nose.radius * nose.radius - (at - center.z) * (at - center.z))));
      }
      touched = std::max(touched, dense[place] - low);
      dense[place] = std::min(dense[place], low);
    }
    if (touched > 0.2) {
      EXPECT_GT(stock.touch(nose, path, 0.001).depth_mm, 0.0);
    }
    stock.cut(nose, path);
  }
  for (std::size_t place = 1; place + 1 < dense.size(); ++place) {
    EXPECT_NEAR(stock.height(-50 + 0.5 * static_cast<double>(place)), dense[place], 0.06);
  }
}

TEST(RemainingStock, KeepsABoundedNumberOfPlaces) {
  RemainingStock stock(10, {0, 1e6}, 0.001);
  EXPECT_EQ(stock.height(5e5), 10.0);
  EXPECT_EQ(stock.height(-1), 0.0);
  stock.cut({1, {0, 0}}, curves::Segment{{0, 5}, {1e6, 5}});
  EXPECT_EQ(stock.height(5e5), 4.0);
}

// What a cut with C leaves of the bar is not known: later rapids are checked against the nominal alone.
TEST(Gouge, ACutThatTurnsCIsNotCheckedAndLeavesAnUnknownBar) {
  ir::Motion cam = cut(120, 0, 60, 0);
  cam.end[static_cast<std::size_t>(ir::Axis::c)] = 90;
  const Report report = run(bar(), {cam, rapid(120, -40, 90, -40), rapid(120, -10, 70, -10)});
  EXPECT_EQ(report.cuts, 0U);
  EXPECT_EQ(report.findings.count(DiagnosticId::cut_below_nominal), 0U);
  EXPECT_EQ(report.findings.count(DiagnosticId::rapid_into_stock), 0U);
  EXPECT_EQ(report.findings.count(DiagnosticId::rapid_into_nominal), 1U);
  EXPECT_FALSE(report.not_checked.empty());
}

TEST(Gouge, AMoveWhoseCoordinatesLieElsewhereIsNotJudged) {
  ir::Motion deep = cut(120, -20, 0, -20);
  ir::Motion fast = rapid(120, -10, 0, -10);
  EXPECT_FALSE(run(bar(), {deep, fast}).findings.empty());
  deep.gaps = fast.gaps = ir::kFrameLost;
  for (const ir::Motion& move : {deep, fast}) {
    const Report report = run(bar(), {move});
    EXPECT_TRUE(report.findings.empty());
    EXPECT_FALSE(report.not_checked.empty());
  }
  EXPECT_TRUE(run(bar(), {deep}).has_unjudged_cuts);
}

}  // namespace
}  // namespace dripfeed::gouge
