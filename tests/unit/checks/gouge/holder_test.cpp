// Shank and holder against a simulation in small steps, and in the milling check: what is found, and what is not there.
#include "checks/gouge/holder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "checks/gouge/milling.h"
#include "tests/unit/checks/motions.h"

namespace dripfeed::gouge {
namespace {

using checks::cut;
using checks::rapid;
using text::DiagnosticId;

const Blank kBlock{{-20, 20}, {-20, 20}, {-30, 0}};
constexpr double kSlack_mm = 0.001;
constexpr double kRounding_mm = 1e-9;

// Moves the tool in small steps over the places of a map: the cutter takes its material away, then the disk above it
// meets what is left. Radii are given larger or smaller by `rim`, so that places at the very rim decide nothing.
struct Simulation {
  HeightMap::Grid grid;
  double step_mm;

  double deepest(const Cutter& cutter, const checks::HolderStep& step, const Point3& from, const Point3& to, double rim,
                 bool cuts) {
    std::vector<double> left = grid.heights;
    double deepest = 0.0;
    constexpr int kSteps = 400;
    for (int i = 0; i <= kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps;
      const Point3 tip{std::lerp(from.x, to.x, t), std::lerp(from.y, to.y, t), std::lerp(from.z, to.z, t)};
      for (std::size_t place = 0; place < left.size(); ++place) {
        const double x = grid.x_low + (static_cast<double>(place % grid.columns) + 0.5) * step_mm;
        const double y = grid.y_low + (static_cast<double>(place / grid.columns) + 0.5) * step_mm;
        const double away = std::hypot(x - tip.x, y - tip.y);
        if (cuts && away <= cutter.radius - rim) left[place] = std::min(left[place], tip.z);
        if (away <= 0.5 * step.diameter_mm + rim) deepest = std::max(deepest, left[place] - tip.z - step.from_mm);
      }
    }
    return deepest;
  }
};

TEST(Holder, TouchesWhatASimulationInSmallStepsTouches) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> side(-18, 18), depth(-14, 2), radius(1, 4), more(0.5, 5), above(1, 8);
  int touches = 0;
  for (int i = 0; i < 120; ++i) {
    HeightMap map(kBlock, 0.8);
    const Cutter cutter{radius(random), 0.0};
    const checks::HolderStep step{above(random), 2.0 * (cutter.radius + more(random))};
    for (int k = 0; k < 4; ++k) {  // what earlier cuts left
      const double z = depth(random);
      map.cut({4, 0}, {side(random), side(random), z}, {side(random), side(random), z});
    }
    const Point3 from{side(random), side(random), depth(random)};
    Point3 to{side(random), side(random), depth(random)};
    if (i % 4 == 0) to.z = from.z;
    if (i % 4 == 1) to = {from.x, from.y, to.z};
    const bool cuts = i % 3 != 0;
    Simulation simulation{map.grid(), map.step_mm()};
    constexpr double kRim_mm = 0.06;
    const double least = simulation.deepest(cutter, step, from, to, -kRim_mm, cuts);
    const double most = simulation.deepest(cutter, step, from, to, kRim_mm, cuts);
    const Holder holder(std::span(&step, 1));
    double found = 0.0;
    const double level = from.z == to.z ? holder.touch_level(map, cutter, from, to, kSlack_mm).depth.mm : 0.0;
    if (cuts) {
      found = holder.touch_ahead(map, cutter, from, to, kSlack_mm).depth.mm;
      map.cut(cutter, from, to);
    }
    found = std::max(found, holder.touch(map, from, to, kSlack_mm).depth.mm);
    if (cuts && from.z == to.z) {
      EXPECT_NEAR(level, found, kRounding_mm) << i;
    }
    constexpr double kStep_mm = 0.05;  // a step of the simulation goes that deep
    EXPECT_GE(found, least - kStep_mm) << i;
    EXPECT_LE(found, most + kStep_mm) << i;
    touches += found > 0.0 ? 1 : 0;
  }
  EXPECT_GT(touches, 30);
  EXPECT_LT(touches, 105);
}

// By the two questions of a straight cut, chord by chord.
double deepest_by_chords(HeightMap map, const Cutter& cutter, const checks::HolderStep& step, const Point3& start) {
  constexpr int kChords = 360;
  const Holder holder(std::span(&step, 1));
  const double radius = std::hypot(start.x, start.y);
  const double begin = std::atan2(start.y, start.x);
  double found = 0.0;
  Point3 from = start;
  for (int i = 1; i <= kChords; ++i) {
    const double angle = begin + 2.0 * std::numbers::pi * i / kChords;
    const Point3 to{radius * std::cos(angle), radius * std::sin(angle), start.z};
    found = std::max(found, holder.touch_ahead(map, cutter, from, to, kSlack_mm).depth.mm);
    map.cut(cutter, from, to);
    found = std::max(found, holder.touch(map, from, to, kSlack_mm).depth.mm);
    from = to;
  }
  return found;
}

TEST(Holder, AFullCircleTouchesWhatItsChordsTouch) {
  std::mt19937 random(18);
  std::uniform_real_distribution<double> side(-18, 18), depth(-14, 2), radius(1, 4), more(-0.5, 5), above(1, 8);
  int touches = 0;
  for (int i = 0; i < 60; ++i) {
    HeightMap map(kBlock, 0.8);
    const Cutter cutter{radius(random), 0.0};
    const checks::HolderStep step{above(random), 2.0 * (cutter.radius + more(random))};
    for (int k = 0; k < 6; ++k) {  // what earlier cuts left
      const double z = depth(random);
      map.cut({4, 0}, {side(random), side(random), z}, {side(random), side(random), z});
    }
    const Point3 start{side(random), side(random), depth(random)};
    const Holder holder(std::span(&step, 1));
    const double found = holder.touch_around(map, cutter, start, 0, 0, kSlack_mm).depth.mm;
    constexpr double kRim_mm = 0.02;  // chords lie that far inside
    const double wide = step.diameter_mm + 2 * kRim_mm;
    const double narrow = step.diameter_mm - 2 * kRim_mm;
    const double least = deepest_by_chords(map, {cutter.radius + kRim_mm, 0}, {step.from_mm, narrow}, start);
    const double most = deepest_by_chords(map, {cutter.radius - kRim_mm, 0}, {step.from_mm, wide}, start);
    EXPECT_GE(found, least - kRounding_mm) << i;
    EXPECT_LE(found, most + kRounding_mm) << i;
    touches += found > 0.0 ? 1 : 0;
  }
  EXPECT_GT(touches, 15);
  EXPECT_LT(touches, 55);
}

// ⌀ 10, a holder of ⌀ 40 from 12 mm above its tip on.
Report run(std::vector<ir::Motion> motions, std::vector<checks::HolderStep> holder = {{12, 40}},
           std::optional<Blank> stock = kBlock, std::vector<curves::HeightField> nominal = {}) {
  MillingSettings settings;
  settings.stock = stock;
  settings.nominal = std::move(nominal);
  settings.tools = {{.number = 1, .diameter_mm = 10, .holder = std::move(holder)}};
  motions.insert(motions.begin(), checks::takes_tool(1));
  Milling check(settings);
  check.consume(motions);
  return check.finish();
}

std::size_t found(const Report& report) { return report.findings.count(DiagnosticId::holder_in_workpiece); }

TEST(Holder, ADeepPlungeIsFoundWithItsDepthAndStep) {
  const Report report = run({cut({0, 0, 5}, {0, 0, -15})});
  ASSERT_EQ(found(report), 1U);
  const std::string& text = report.findings.kept().front().text;
  EXPECT_TRUE(text.starts_with("the shank or holder of tool 1 enters the workpiece by 3.000 mm at x ")) << text;
  EXPECT_TRUE(text.ends_with("; it is 40 mm wide from 12 mm above the tip on")) << text;
  EXPECT_EQ(found(run({cut({0, 0, 5}, {0, 0, -11.9})})), 0U);
  EXPECT_EQ(found(run({cut({0, 0, 5}, {0, 0, -15})}, {{15.01, 40}})), 0U);
  EXPECT_EQ(found(run({cut({0, 0, 5}, {0, 0, -15})}, {})), 0U) << "what is not known is not found";
}

// The shank is as wide as the cutter: where the cutter was, there is room for it.
TEST(Holder, AShankFollowsItsCutter) {
  EXPECT_EQ(found(run({cut({0, 0, 5}, {0, 0, -29})}, {{3, 10}})), 0U);
  EXPECT_EQ(found(run({cut({0, 0, 5}, {0, 0, -29}), cut({0, 0, -29}, {12, 5, -29}), rapid({12, 5, -29}, {0, 0, 5})},
                      {{3, 10}})),
            0U);
  EXPECT_EQ(found(run({cut({0, 0, 5}, {0, 0, -29})}, {{3, 10.2}})), 1U);
}

TEST(Holder, AWallIsMetInCutsRapidsAndArcs) {
  const ir::Motion along_side = cut({-40, -26, -15}, {40, -26, -15});  // 6 mm off the block, the holder reaches 20 mm
  EXPECT_EQ(found(run({along_side})), 1U);
  EXPECT_EQ(found(run({rapid({-40, -26, -15}, {40, -26, -15})})), 1U);
  EXPECT_EQ(found(run({rapid({-40, -41, -15}, {40, -41, -15})})), 0U);
  ir::Motion circle = cut({30, 0, -15}, {30, 0, -15});
  circle.kind = ir::MotionKind::arc_ccw;
  circle.center = {-30, 0};
  EXPECT_EQ(found(run({circle})), 1U) << "once, and not a chord";
}

TEST(Holder, WithoutStockTheFinishedPartCounts) {
  const curves::HeightField island{
      {-5, 5}, [](double) { return curves::Range{-5, 5}; }, [](double, double) { return 0.0; }, 0.05};
  EXPECT_EQ(found(run({rapid({12, 0, 5}, {12, 0, -14})}, {{12, 40}}, {}, {island})), 1U);
  EXPECT_EQ(found(run({rapid({26, 0, 5}, {26, 0, -14})}, {{12, 40}}, {}, {island})), 0U);
}

}  // namespace
}  // namespace dripfeed::gouge
