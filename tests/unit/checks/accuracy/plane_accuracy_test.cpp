// Plane paths next to curves of which the deviation is known.
#include "checks/accuracy/plane_accuracy.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/curves/nurbs.h"
#include "tests/unit/checks/motions.h"

namespace dripfeed::accuracy {
namespace {

using checks::takes_tool;
using curves::Point;
using text::DiagnosticId;

const std::vector<Point> kPoints = {{25, 50},      {42.7, 24.4},  {70.7, 72.2}, {86.5, 165.4},
                                    {112.5, 38.3}, {132.4, 35.2}, {175, 150}};

ir::Motion line(Point from, Point to, ir::CompSide comp = ir::CompSide::off, std::uint32_t number = 5) {
  ir::Motion motion;
  motion.kind = ir::MotionKind::linear;
  motion.place = {0, number, number};
  motion.start = {from.z, from.x, -1};
  motion.end = {to.z, to.x, -1};
  motion.comp = comp;
  return motion;
}

// A circle of radius 30 around 0 by its angle, counterclockwise.
curves::ParametricCurve circle() {
  return {{0, 2 * std::numbers::pi},
          [](double t) {
            return curves::ParametricPoint{{30 * std::cos(t), 30 * std::sin(t)},
                                           {-30 * std::sin(t), 30 * std::cos(t)},
                                           {-30 * std::cos(t), -30 * std::sin(t)}};
          },
          [](double, double) { return curves::Box{{-30, 30}, {-30, 30}}; },
          {}};
}

PlaneSettings settings_for(const curves::ParametricCurve& curve) {
  PlaneSettings settings;
  settings.nominal = {{curve, 0.02, false}};
  settings.tools = {{.number = 1, .diameter_mm = 10}};
  return settings;
}

Report run(const PlaneSettings& settings, std::vector<ir::Motion> motions, std::int32_t tool = 1) {
  motions.insert(motions.begin(), takes_tool(tool));
  PlaneAccuracy check(settings);
  check.consume(motions);
  return check.finish();
}

// Chords between places of the curve, moved by `offset` to the left.
std::vector<ir::Motion> chords(const curves::ParametricCurve& curve, int count, double offset,
                               ir::CompSide comp = ir::CompSide::off, bool backwards = false) {
  std::vector<ir::Motion> all;
  const auto place = [&](int i) {
    const curves::ParametricPoint on = curve.at(curve.t.low + curve.t.width() * (backwards ? count - i : i) / count);
    return on.point + offset * curves::unit({-on.derivative.x, on.derivative.z});
  };
  for (int i = 1; i <= count; ++i) all.push_back(line(place(i - 1), place(i), comp, static_cast<std::uint32_t>(i)));
  return all;
}

TEST(PlaneAccuracy, ChordsOfACircleMissByTheirSagitta) {
  const double sagitta = 30 * (1 - std::cos(std::numbers::pi / 60));
  // Compensated to the right on a counterclockwise circle: the tool is outside, the material inside.
  const Report outside = run(settings_for(circle()), chords(circle(), 60, 0, ir::CompSide::right));
  ASSERT_TRUE(outside.surface);
  EXPECT_EQ(outside.blocks, 60U);
  EXPECT_NEAR(outside.surface->max_mm, sagitta, 1e-6);
  EXPECT_NEAR(outside.surface->max_signed_mm, -sagitta, 1e-6);  // chords cut into a disk
  EXPECT_NEAR(outside.surface->mean_mm, sagitta * 2 / 3, 1e-4);
  EXPECT_TRUE(outside.covered);
  ASSERT_TRUE(outside.chord_bound_mm);
  EXPECT_GE(*outside.chord_bound_mm, sagitta - 1e-12);
  EXPECT_LE(*outside.chord_bound_mm, 1.05 * sagitta);
  EXPECT_EQ(outside.findings.count(DiagnosticId::deviation_beyond_tolerance), 60U);
  // To the left: a pocket, in which chords leave material, and the cutter's radius a little more in the corners.
  const Report inside = run(settings_for(circle()), chords(circle(), 60, 0, ir::CompSide::left));
  const double corner = 5 / std::cos(std::numbers::pi / 60) - 5;
  EXPECT_NEAR(inside.surface->highest_mm, std::max(sagitta, corner), 1e-6);
  EXPECT_GT(inside.surface->lowest_mm, -1e-9);
}

TEST(PlaneAccuracy, WithoutCompensationTheEdgeCounts) {
  const Report report = run(settings_for(circle()), chords(circle(), 3600, 5));
  ASSERT_TRUE(report.surface);
  EXPECT_LT(report.surface->max_mm, 2e-5);
  EXPECT_LT(*report.chord_bound_mm, 3e-5);
  EXPECT_GE(*report.chord_bound_mm, report.surface->max_mm - 1e-12);
  EXPECT_TRUE(report.covered);
  const Report off = run(settings_for(circle()), chords(circle(), 3600, 4.9));
  EXPECT_NEAR(off.surface->lowest_mm, -0.1, 1e-4);
  PlaneSettings of_center = settings_for(circle());
  of_center.nominal[0].of_center = true;
  EXPECT_LT(run(of_center, chords(circle(), 3600, 0)).figures().max_mm, 2e-5);
  EXPECT_NEAR(run(of_center, chords(circle(), 3600, 5)).figures().max_mm, 5, 1e-4);
}

TEST(PlaneAccuracy, AnArcOnItsCircleIsExact) {
  ir::Motion arc = line({30, 0}, {30, 0}, ir::CompSide::right);
  arc.kind = ir::MotionKind::arc_ccw;
  arc.center = {-30, 0, 0};
  const Report report = run(settings_for(circle()), {arc});
  EXPECT_LT(report.surface->max_mm, 1e-9);
  EXPECT_TRUE(report.covered);
  ir::Motion half = arc;
  half.end = {-30, 0, -1};
  const Report part = run(settings_for(circle()), {half});
  EXPECT_FALSE(part.covered);
  EXPECT_NEAR(part.gaps.at(0).high_mm, 84.85, 0.01);  // by chords of the missing half
}

// The foot turns as far as the cutter's center does, on a circle many times as large.
TEST(PlaneAccuracy, ACutterThatFillsItsPocketIsExact) {
  PlaneSettings settings = settings_for(circle());
  for (const double path : {0.3, 0.01, 0.001}) {
    settings.tools[0].diameter_mm = 2 * (30 - path);
    ir::Motion arc = line({path, 0}, {path, 0});
    arc.kind = ir::MotionKind::arc_ccw;
    arc.center = {-path, 0, 0};
    const Report report = run(settings, {arc});
    EXPECT_LT(report.surface->max_mm, 1e-9) << path;
    EXPECT_TRUE(report.covered) << path;
  }
}

// Two branches that meet in a point and leave each other slowly: the path goes on along the other one.
TEST(PlaneAccuracy, ACuspIsFollowed) {
  const curves::ParametricCurve cusp{{-1, 1},
                                     [](double t) {
                                       return curves::ParametricPoint{
                                           {10 * t * t, 10 * t * t * t}, {20 * t, 30 * t * t}, {20, 60 * t}};
                                     },
                                     [](double, double) { return curves::Box{{20, 20}, {-60, 60}}; },
                                     {}};
  PlaneSettings settings = settings_for(cusp);
  settings.nominal[0].of_center = true;
  for (const bool backwards : {false, true}) {
    const Report report = run(settings, chords(cusp, 400, 0, ir::CompSide::off, backwards));
    EXPECT_LE(report.figures().max_mm, 0.02);
    EXPECT_TRUE(report.covered);
    EXPECT_TRUE(report.findings.empty());
  }
  // What turns back before the point leaves it out, and is off the other branch.
  std::vector<ir::Motion> all = chords(cusp, 400, 0);
  all.erase(all.begin() + 150, all.begin() + 250);
  all.insert(all.begin() + 150, line(cusp.at(-0.25).point, cusp.at(0.25).point));
  const Report cut_short = run(settings, all);
  EXPECT_FALSE(cut_short.covered);
}

TEST(PlaneAccuracy, ANurbsCurveInEitherDirection) {
  const curves::ParametricCurve curve = curves::curve_of({4, kPoints, {1, 3, 1, 1, 1, 3, 1}, {}});
  for (const bool backwards : {false, true}) {
    const Report report = run(settings_for(curve), chords(curve, 50, 0, ir::CompSide::left, backwards));
    EXPECT_TRUE(report.covered);
    ASSERT_TRUE(report.chord_bound_mm);
    EXPECT_GE(*report.chord_bound_mm, report.path.max_mm - 1e-12);
    EXPECT_LE(*report.chord_bound_mm, 1.05 * report.path.max_mm);
    EXPECT_GT(report.path.max_mm, 0.05);
  }
  const Report half = run(settings_for(curve), [&] {
    auto all = chords(curve, 50, 0);
    all.resize(25);
    return all;
  }());
  EXPECT_FALSE(half.covered);
}

TEST(PlaneAccuracy, RunOutBeyondTheCurveIsReportedApart) {
  const curves::ParametricCurve curve = curves::curve_of({2, {{0, 0}, {100, 0}}, {}, {}});
  const Report report = run(settings_for(curve), {line({-10, 0.01}, {110, 0.01}, ir::CompSide::left)});
  EXPECT_NEAR(report.overrun_mm, 10, 1e-6);
  EXPECT_NEAR(report.surface->max_mm, 0.01, 1e-9);
  EXPECT_TRUE(report.covered);
  EXPECT_TRUE(report.findings.empty());
}

// A part of the circle as a curve of its own.
curves::ParametricCurve part_of_circle(double from, double to) {
  curves::ParametricCurve curve = circle();
  curve.t = {from, to};
  return curve;
}
curves::ParametricCurve straight(Point from, Point to) { return curves::curve_of({2, {from, to}, {}, {}}); }

PlaneSettings settings_for(const std::vector<curves::ParametricCurve>& curves) {
  PlaneSettings settings = settings_for(curves.front());
  settings.nominal.clear();
  for (const curves::ParametricCurve& one : curves) settings.nominal.push_back({one, 0.02, false});
  return settings;
}

TEST(PlaneAccuracy, WhatIsJoinedIsCoveredAsOnePieceIs) {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (const std::vector<double>& cuts : {std::vector<double>{0, 0.5}, {0.1, 0.35, 0.8}, {0, 0.25, 0.5, 0.75}}) {
    std::vector<curves::ParametricCurve> parts;
    parts.reserve(cuts.size());
    for (std::size_t i = 0; i < cuts.size(); ++i)
      parts.push_back(part_of_circle(kTurn * cuts[i], kTurn * (i + 1 < cuts.size() ? cuts[i + 1] : cuts[0] + 1)));
    for (const bool backwards : {false, true}) {
      const Report chorded = run(settings_for(parts), chords(circle(), 300, 0, ir::CompSide::right, backwards));
      EXPECT_TRUE(chorded.covered) << cuts.size() << ": " << (chorded.gaps.empty() ? 0 : chorded.gaps[0].high_mm);
      EXPECT_EQ(chorded.overrun_mm, 0.0);
      EXPECT_TRUE(chorded.chord_bound_mm) << cuts.size();
      EXPECT_EQ(chorded.findings.count(DiagnosticId::nominal_not_covered), 0U);
    }
    ir::Motion arc = line({30, 0}, {30, 0}, ir::CompSide::right);
    arc.kind = ir::MotionKind::arc_ccw;
    arc.center = {-30, 0, 0};
    EXPECT_TRUE(run(settings_for(parts), {arc}).covered) << cuts.size();
  }
}

TEST(PlaneAccuracy, ACornerBetweenTwoCurvesIsNoEndToRunOut) {
  const std::vector<Point> corners = {{0, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 0}};
  std::vector<curves::ParametricCurve> sides;
  std::vector<ir::Motion> on_it;
  std::vector<ir::Motion> next_to_it;  // the centre of a cutter of radius 5, outside
  const auto next_to = [](Point corner) {
    return Point{corner.z + (corner.z > 20 ? 5 : -5), corner.x + (corner.x > 20 ? 5 : -5)};
  };
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    sides.push_back(straight(corners[i], corners[i + 1]));
    on_it.push_back(line(corners[i], corners[i + 1], ir::CompSide::right));
    next_to_it.push_back(line(next_to(corners[i]), next_to(corners[i + 1])));
  }
  const Report compensated = run(settings_for(sides), on_it);
  EXPECT_TRUE(compensated.covered);
  EXPECT_EQ(compensated.overrun_mm, 0.0);
  const Report outside = run(settings_for(sides), next_to_it);
  EXPECT_TRUE(outside.covered);
  EXPECT_EQ(outside.overrun_mm, 0.0);
  EXPECT_LT(outside.path.max_mm, 1e-9);
  // One side is left out: that is still found, and only that.
  on_it.pop_back();
  const Report open = run(settings_for(sides), on_it);
  ASSERT_EQ(open.gaps.size(), 1U);
  EXPECT_NEAR(open.gaps[0].high_mm, 40.0, 1e-3);
  // The end of a contour that is open is one.
  sides.pop_back();
  on_it.push_back(line({0, 40}, {-8, 40}, ir::CompSide::right));
  EXPECT_NEAR(run(settings_for(sides), on_it).overrun_mm, 8.0, 1e-6);
}

TEST(PlaneAccuracy, WhatIsNotKnownIsReportedAndNothingHangs) {
  const Report unknown = run(settings_for(circle()), chords(circle(), 60, 0), 9);
  EXPECT_FALSE(unknown.surface);
  EXPECT_FALSE(unknown.not_checked.empty());
  EXPECT_FALSE(run({}, chords(circle(), 60, 0)).not_checked.empty());
  const Report stands = run(settings_for(circle()), {line({30, 0}, {30, 0})});  // a plunge
  EXPECT_EQ(stands.blocks, 0U);
  const double nan = std::nan("");
  EXPECT_EQ(run(settings_for(circle()), {line({nan, 0}, {30, 0})}).blocks, 0U);
  ir::Motion swivelled = line({0, 0}, {1, 1});
  swivelled.gaps = ir::kFrameLost;
  EXPECT_FALSE(run(settings_for(circle()), {swivelled}).not_checked.empty());
  EXPECT_EQ(run(settings_for(circle()), {swivelled}).blocks, 0U);
  ir::Motion upright = line({0, 0}, {1, 1});
  upright.kind = ir::MotionKind::arc_cw;
  upright.plane = ir::Plane::zx;
  EXPECT_FALSE(run(settings_for(circle()), {upright}).not_checked.empty());
  const curves::ParametricCurve point{{0, 1}, [](double) { return curves::ParametricPoint{}; }};
  EXPECT_EQ(run(settings_for(point), {line({-1, 0}, {1, 0})}).blocks, 1U);
}

}  // namespace
}  // namespace dripfeed::accuracy
