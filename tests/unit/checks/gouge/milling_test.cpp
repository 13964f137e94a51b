// Sweeps against brute force, a block of stock, and moves that do or just do not touch.
#include "checks/gouge/milling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/checks/motions.h"

namespace dripfeed::gouge {
namespace {

using checks::cut;
using checks::move;
using checks::rapid;
using checks::takes_tool;
using text::DiagnosticId;

// The same minimum by trying many places of the axis.
double brute(const Cutter& cutter, const Point3& a, const Point3& b, double x, double y) {
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 20000; ++i) {
    const double t = i / 20000.0;
    const double distance = std::hypot(a.x + t * (b.x - a.x) - x, a.y + t * (b.y - a.y) - y);
    if (distance <= cutter.radius) lowest = std::min(lowest, a.z + t * (b.z - a.z) + cutter.rise(distance));
  }
  return lowest;
}

TEST(Sweep, IsTheLowestOfAllPlacesOfTheCutter) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> any(-10, 10);
  for (const Cutter cutter : {Cutter{4, 0}, Cutter{4, 4}, Cutter{4, 1}}) {
    for (int i = 0; i < 60; ++i) {
      const Point3 a{any(random), any(random), any(random)};
      Point3 b{any(random), any(random), any(random)};
      if (i % 5 == 0) b.z = a.z;
      if (i % 7 == 0) b = {a.x, a.y, b.z};
      const Sweep sweep(cutter, a, b);
      for (int k = 0; k < 20; ++k) {
        const double x = any(random), y = any(random);
        const double wanted = brute(cutter, a, b, x, y);
        const double found = sweep.lowest(x, y);
        if (std::isinf(wanted)) continue;  // at the very rim trying misses by a hair
        EXPECT_LE(found, wanted + 1e-9);
        // The steep rim of a rounding is where trying finds the minimum late.
        EXPECT_GE(found, wanted - 0.02) << cutter.corner << " " << x << " " << y;
        const auto row = sweep.row(y);
        ASSERT_TRUE(row);
        EXPECT_LE(row->low, x + 1e-9);
        EXPECT_GE(row->high, x - 1e-9);
      }
    }
  }
}

TEST(Sweep, RowsEndAtTheRim) {
  const Sweep sweep({4, 0}, {0, 0, 0}, {10, 10, 0});
  for (double y = -3.9; y < 14; y += 0.37) {
    const auto row = sweep.row(y);
    ASSERT_TRUE(row);
    EXPECT_TRUE(std::isfinite(sweep.lowest(row->low + 1e-6, y)));
    EXPECT_TRUE(std::isfinite(sweep.lowest(row->high - 1e-6, y)));
    EXPECT_TRUE(std::isinf(sweep.lowest(row->low - 1e-6, y)));
    EXPECT_TRUE(std::isinf(sweep.lowest(row->high + 1e-6, y)));
  }
  EXPECT_FALSE(sweep.row(-4.1));
  EXPECT_FALSE(sweep.row(14.1));
}

curves::HeightField field(double low, double high, double z) {
  return {
      {low, high}, [low, high](double) { return curves::Range{low, high}; }, [z](double, double) { return z; }, 0.05};
}

// A block of 100 by 100 by 30, its top at 0, to become a step of 5 in the middle 40 by 40.
MillingSettings block() {
  MillingSettings settings;
  settings.stock = Blank{{-50, 50}, {-50, 50}, {-30, 0}};
  settings.nominal = {field(-50, 50, 0), field(-20, 20, -5)};
  settings.tools = {{.number = 1, .diameter_mm = 10}, {.number = 2, .diameter_mm = 10, .corner_radius_mm = 5}};
  return settings;
}

Report run(const MillingSettings& settings, std::vector<ir::Motion> motions, std::int32_t tool = 1) {
  motions.insert(motions.begin(), takes_tool(tool));
  Milling check(settings);
  check.consume(motions);
  return check.finish();
}

TEST(Milling, ARapidIntoTheBlockIsSeenWithItsDepth) {
  MillingSettings settings = block();
  settings.nominal.clear();
  const Report report = run(settings, {rapid({-80, 0, 10}, {-80, 0, -2}), rapid({-80, 0, -2}, {80, 0, -2})});
  ASSERT_EQ(report.findings.count(DiagnosticId::rapid_into_stock), 1U);
  EXPECT_NEAR(report.deepest_rapid_mm, 2.0, 1e-9);
  EXPECT_TRUE(run(settings, {rapid({-80, 0, 10}, {80, 0, 0})}).findings.empty());     // lands on its top
  EXPECT_TRUE(run(settings, {rapid({-80, 56, -5}, {80, 56, -5})}).findings.empty());  // passes next to it
  EXPECT_EQ(run(settings, {rapid({0, 0, 10}, {0, 0, -0.01})}).findings.count(DiagnosticId::rapid_into_stock), 1U);
}

TEST(Milling, CutsClearThePathForRapids) {
  MillingSettings settings = block();
  settings.nominal.clear();
  const ir::Motion plunge = cut({0, 0, 10}, {0, 0, -4});
  const ir::Motion slot = cut({0, 0, -4}, {20, 0, -4});
  EXPECT_TRUE(
      run(settings, {plunge, slot, rapid({20, 0, -4}, {0, 0, -4}), rapid({0, 0, -4}, {0, 0, 10})}).findings.empty());
  EXPECT_EQ(
      run(settings, {plunge, slot, rapid({20, 0, -4}, {21, 0, -4})}).findings.count(DiagnosticId::rapid_into_stock),
      1U);
  EXPECT_EQ(
      run(settings, {plunge, slot, rapid({20, 0, -4}, {20, 0.6, -4})}).findings.count(DiagnosticId::rapid_into_stock),
      1U);
}

TEST(Milling, RapidsIntoThePartAreWorse) {
  EXPECT_EQ(run(block(), {rapid({0, 0, 10}, {0, 0, -3})}).findings.count(DiagnosticId::rapid_into_stock), 1U);
  EXPECT_EQ(run(block(), {rapid({0, 0, 10}, {0, 0, -6})}).findings.count(DiagnosticId::rapid_into_nominal), 1U);
  MillingSettings bare = block();
  bare.stock.reset();
  EXPECT_TRUE(run(bare, {rapid({0, 0, 10}, {0, 0, -3})}).findings.empty());
  EXPECT_EQ(run(bare, {rapid({0, 0, 10}, {0, 0, -6})}).findings.count(DiagnosticId::rapid_into_nominal), 1U);
}

TEST(Milling, CutsBelowTheNominalAreSeenBeyondItsTolerance) {
  const auto pocket = [](double z, double x) {
    return std::vector<ir::Motion>{cut({-x, -x, 10}, {-x, -x, z}), cut({-x, -x, z}, {x, -x, z}),
                                   cut({x, -x, z}, {x, x, z})};
  };
  EXPECT_TRUE(run(block(), pocket(-5, 15)).findings.empty());
  EXPECT_TRUE(run(block(), pocket(-5.04, 15)).findings.empty());
  EXPECT_EQ(run(block(), pocket(-5.06, 15)).findings.count(DiagnosticId::cut_below_nominal), 3U);
  EXPECT_NEAR(run(block(), pocket(-6, 15)).deepest_cut_mm, 1.0, 1e-9);
  // Sideways into the wall: farther than the tolerance and the step of the map.
  EXPECT_EQ(run(block(), pocket(-5, 15.5)).findings.count(DiagnosticId::cut_below_nominal), 3U);
  EXPECT_TRUE(run(block(), pocket(-5, 15.02)).findings.empty());
}

TEST(Milling, ABallLeavesItsRounding) {
  MillingSettings settings = block();
  settings.nominal.clear();
  settings.step_mm = 0.5;
  Milling check(settings);
  check.consume({{takes_tool(2), cut({-30, 0, 10}, {-30, 0, -2}), cut({-30, 0, -2}, {30, 0, -2})}});
  EXPECT_TRUE(check.finish().findings.empty());
  const plot::Plot picture = check.picture();
  ASSERT_TRUE(picture.map);
  const auto [low, high] = std::ranges::minmax(picture.map->values);
  EXPECT_NEAR(low, -2, 0.02);
  EXPECT_EQ(high, 0);
  // A flat mill would have to stand at the rounding's height: the ball passes to the side at depth 2 within 4 mm.
  EXPECT_TRUE(run(settings,
                  {cut({-30, 0, 10}, {-30, 0, -2}), cut({-30, 0, -2}, {30, 0, -2}), rapid({30, 0, -2}, {30, 0, 5})}, 2)
                  .findings.empty());
}

TEST(Milling, ArcsAndHelicesAreFollowed) {
  MillingSettings settings = block();
  settings.nominal.clear();
  ir::Motion circle = move(ir::MotionKind::arc_ccw, {15, 0, -3}, {15, 0, -3});
  circle.center = {-15, 0, 0};
  const ir::Motion back = rapid({15, 0, -3}, {15, 0, 10});
  const ir::Motion across = rapid({-15, 0, 10}, {-15, 0, -3});
  EXPECT_TRUE(run(settings, {cut({15, 0, 10}, {15, 0, -3}), circle, back, across}).findings.empty());
  EXPECT_EQ(run(settings, {cut({15, 0, 10}, {15, 0, -3}), back, across}).findings.count(DiagnosticId::rapid_into_stock),
            1U);
  ir::Motion helix = circle;
  helix.end[2] = -6;
  EXPECT_EQ(run(settings, {cut({15, 0, 10}, {15, 0, -3}), helix, rapid({15, 0, -6}, {15, 0, 10}),
                           rapid({-15, 0, 10}, {-15, 0, -5})})
                .findings.count(DiagnosticId::rapid_into_stock),
            1U);
  ir::Motion stands = circle;  // an arc without a radius is a place
  stands.center = {0, 0, 0};
  EXPECT_TRUE(run(settings, {cut({15, 0, 10}, {15, 0, -3}), stands}).findings.empty());
}

TEST(Milling, AxesThatRunAtTheirOwnSpeedAreAWarning) {
  MillingSettings settings = block();
  settings.nominal.clear();
  settings.rapid_mm_min = {30000, 30000, 10000};
  // Straight it climbs over the edge; z alone is slower and stays below.
  const ir::Motion climb = rapid({-60, 0, -3}, {-40, 0, 40});
  const Report report = run(settings, {climb});
  EXPECT_EQ(report.findings.count(DiagnosticId::rapid_may_enter_stock), 1U);
  EXPECT_FALSE(report.findings.has(text::Severity::error));
  EXPECT_TRUE(run(settings, {rapid({-60, 0, -3}, {-60, 0, 40}), rapid({-60, 0, 40}, {-40, 0, 40})}).findings.empty());
}

TEST(Milling, WhatIsNotKnownIsReported) {
  const auto reports = [](const Report& report, std::string_view part) {
    return std::ranges::any_of(report.not_checked.list(),
                               [&](const checks::NotChecked& one) { return one.text.find(part) != std::string::npos; });
  };
  EXPECT_TRUE(reports(run(block(), {rapid({0, 0, 10}, {0, 0, -6})}, 7), "diameter of tool 7"));
  ir::Motion compensated = cut({0, 0, -5}, {1, 0, -5});
  compensated.comp = ir::CompSide::left;
  compensated.plane = ir::Plane::zx;
  EXPECT_TRUE(reports(run(block(), {compensated}), "compensation in another plane"));
  compensated.plane = ir::Plane::xy;
  MillingSettings by_number = block();
  by_number.comp_radius = CompRadius::of_number;
  EXPECT_TRUE(reports(run(by_number, {compensated}), "D0"));
  compensated.tool_offset = 77;
  EXPECT_TRUE(reports(run(by_number, {compensated}), "D77 is the offset of no tool"));
  EXPECT_TRUE(run(block(), {compensated}).not_checked.list().size() == run(block(), {}).not_checked.list().size());
  ir::Motion turned = cut({0, 0, -5}, {1, 0, -5});
  turned.end[3] = 10;
  EXPECT_TRUE(reports(run(block(), {turned}), "rotary"));
  ir::Motion swivelled = cut({0, 0, -5}, {1, 0, -5});
  swivelled.gaps = ir::kFrameLost;
  ir::Motion through = rapid({0, 0, 10}, {0, 0, -6});
  through.gaps = ir::kFrameLost;
  const Report elsewhere = run(block(), {swivelled, through});
  EXPECT_TRUE(reports(elsewhere, "a move in a swivelled plane"));
  EXPECT_TRUE(elsewhere.findings.empty());
  EXPECT_TRUE(elsewhere.has_unjudged_cuts);
  ir::Motion unknown = rapid({0, 0, 0}, {0, 0, -6});
  unknown.axes_unknown = 7;
  const Report report = run(block(), {unknown});
  EXPECT_TRUE(reports(report, "not known: its end alone"));
  EXPECT_EQ(report.findings.count(DiagnosticId::rapid_into_nominal), 1U);
  EXPECT_TRUE(reports(run({}, {}), "no stock"));
}

TEST(Milling, AbsurdStockIsBounded) {
  MillingSettings settings = block();
  settings.stock = Blank{{-1e7, 1e7}, {-1e-3, 1e-3}, {-1, 0}};
  EXPECT_EQ(run(settings, {rapid({0, 0, 10}, {0, 0, -0.5})}).findings.count(DiagnosticId::rapid_into_stock), 0U);
  settings.stock = Blank{{0, 0}, {0, 0}, {0, 0}};
  EXPECT_FALSE(run(settings, {}).not_checked.empty());
  settings.stock = Blank{{-1e5, 1e5}, {-1e5, 1e5}, {-1, 0}};
  EXPECT_EQ(run(settings, {rapid({-1e5, -1e5, -0.5}, {1e5, 1e5, -0.5})}).rapids, 1U);
}

}  // namespace
}  // namespace dripfeed::gouge
