// Small profiles whose errors are known by hand. The rolls of the papers are in tests/numeric.
#include "checks/accuracy/accuracy.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "checks/accuracy/chord.h"
#include "dialects/curves/conic.h"
#include "tests/unit/checks/motions.h"

namespace dripfeed::accuracy {
namespace {

using checks::takes_tool;
using text::DiagnosticId;

curves::Profile straight(double x, double slope, curves::Range z, double tolerance = 0.01) {
  return {{{{z, [=](double at) { return curves::ExplicitPoint{x + slope * at, slope}; },
             [](double, double) { return curves::Range{}; }},
            tolerance}}};
}

ir::Motion cut(double from_z, double from_x, double z, double x, std::uint32_t line = 5) {
  ir::Motion motion;
  motion.kind = ir::MotionKind::linear;
  motion.plane = ir::Plane::zx;
  motion.place = {0, line, line};
  motion.start[0] = from_x;
  motion.start[2] = from_z;
  motion.end[0] = x;
  motion.end[2] = z;
  return motion;
}

Report run(Settings settings, const std::vector<ir::Motion>& motions) {
  Accuracy check(std::move(settings));
  check.consume(motions);
  return check.finish();
}

TEST(Accuracy, MeasuresInRadiusGeometryAlongTheNormal) {
  // A cone of slope 3/4 (radius), cut 0.1 mm too large in diameter: 0.05 in radius, 0.04 along the normal.
  const Report report = run({.nominal = straight(50, 0.75, {0, 40})}, {cut(40, 160.1, 0, 100.1)});
  EXPECT_NEAR(report.path.max_mm, 0.04, 1e-9);
  EXPECT_NEAR(report.path.max_signed_mm, 0.04, 1e-9);
  EXPECT_NEAR(report.path.mean_mm, 0.04, 1e-9);
  EXPECT_NEAR(report.path.rmse_mm, 0.04, 1e-9);
  EXPECT_EQ(report.path.max_line, 5U);
  EXPECT_EQ(report.blocks, 1U);
  EXPECT_FALSE(report.surface);
  ASSERT_TRUE(report.chord_bound_mm);
  EXPECT_NEAR(*report.chord_bound_mm, 0.04, 1e-9);
  EXPECT_EQ(report.findings.count(DiagnosticId::deviation_beyond_tolerance), 1U);
  const Report radius =
      run({.nominal = straight(50, 0.75, {0, 40}, 0.05), .x_is_diameter = false}, {cut(40, 80.05, 0, 50.05)});
  EXPECT_NEAR(radius.path.max_mm, 0.04, 1e-9);
  EXPECT_TRUE(radius.covered);
  EXPECT_TRUE(radius.findings.empty());
}

TEST(Accuracy, FindsGapsAndOverruns) {
  const Settings settings{.nominal = straight(50, 0, {0, 40})};
  const Report report = run(settings, {cut(45, 100, 30, 100), cut(20, 100, 10, 100), cut(12, 100, 5, 100)});
  EXPECT_FALSE(report.covered);
  ASSERT_EQ(report.gaps.size(), 2U);
  EXPECT_NEAR(report.gaps[0].low_mm, 0, 1e-9);
  EXPECT_NEAR(report.gaps[0].high_mm, 5, 1e-9);
  EXPECT_NEAR(report.gaps[1].low_mm, 20, 1e-9);
  EXPECT_NEAR(report.gaps[1].high_mm, 30, 1e-9);
  EXPECT_NEAR(report.overrun_mm, 5, 1e-9);
  EXPECT_NEAR(report.path.max_mm, 0, 1e-8);
  EXPECT_EQ(report.findings.count(DiagnosticId::nominal_not_covered), 2U);
  EXPECT_TRUE(run(settings, {cut(45, 100, 20, 100), cut(20, 100, -3, 100)}).covered);
  EXPECT_FALSE(run(settings, {}).covered);
}

TEST(Accuracy, MeasuresMarkedLinesOnly) {
  const Settings settings{.nominal = straight(50, 0, {0, 40}), .lines = {{10, 12}, {20, 20}}};
  const Report report = run(
      settings, {cut(40, 120, 0, 120, 9), cut(40, 100, 20, 100, 10), cut(20, 100, 0, 100, 20), cut(40, 90, 0, 90, 21)});
  EXPECT_EQ(report.blocks, 2U);
  EXPECT_NEAR(report.path.max_mm, 0, 1e-12);
  EXPECT_TRUE(report.covered);
}

TEST(Accuracy, ANoseWithoutCompensationMissesACone) {
  Settings settings{.nominal = straight(50, 1, {0, 40}), .tools = {{.number = 6, .nose_radius_mm = 0.8, .tip = 3}}};
  std::vector<ir::Motion> motions = {takes_tool(6), cut(40, 180, 0, 100)};
  const Report bare = run(settings, motions);
  ASSERT_TRUE(bare.surface);
  EXPECT_NEAR(bare.path.max_mm, 0, 1e-12);
  EXPECT_NEAR(bare.surface->max_signed_mm, -0.8, 1e-9);  // towards the chuck on a slope that falls: r(cos - sin - 1)
  EXPECT_NEAR(bare.figures().mean_mm, 0.8, 1e-9);
  motions[1].comp = ir::CompSide::right;
  const Report compensated = run(settings, motions);
  EXPECT_NEAR(compensated.figures().max_mm, 0, 1e-12);
  settings.nominal = straight(50, -1, {0, 40});
  const Report rising = run(settings, {takes_tool(6), cut(40, 20, 0, 100)});
  EXPECT_NEAR(rising.surface->max_signed_mm, 0.8 * (std::sqrt(2.0) - 1), 1e-9);
}

TEST(Accuracy, MeasuresNoCutWhoseCoordinatesLieElsewhere) {
  const Settings settings{.nominal = straight(50, 1, {0, 40}),
                          .tools = {{.number = 6, .nose_radius_mm = 0.8, .tip = 3}}};
  ir::Motion move = cut(40, 180, 0, 100);
  EXPECT_GT(run(settings, {takes_tool(6), move}).blocks, 0U);
  move.gaps = ir::kFrameLost;
  const Report report = run(settings, {takes_tool(6), move});
  EXPECT_EQ(report.blocks, 0U);
  EXPECT_FALSE(report.not_checked.empty());
}

TEST(Accuracy, SaysThatAToolIsNotKnown) {
  const Settings settings{.nominal = straight(50, 1, {0, 40}),
                          .tools = {{.number = 6, .nose_radius_mm = 0.8, .tip = 3}}};
  const Report report = run(settings, {takes_tool(7), cut(40, 180, 0, 100)});
  EXPECT_FALSE(report.surface);
  EXPECT_FALSE(report.not_checked.empty());
  EXPECT_NEAR(report.figures().max_mm, 0, 1e-12);
}

TEST(Accuracy, ANoseRoundsTheCornerThatItIsLedAround) {
  // The tip is led along a level line and then up 45 degrees towards the chuck; the nominal is what a point would cut.
  const curves::Profile hollow{{{{{-20, 0}, [](double z) { return curves::ExplicitPoint{50 - z, -1}; }, {}}, 0.01},
                                {{{0, 20}, [](double) { return curves::ExplicitPoint{50, 0}; }, {}}, 0.01}}};
  const Settings settings{
      .nominal = hollow, .x_is_diameter = false, .tools = {{.number = 1, .nose_radius_mm = 1, .tip = 3}}};
  const Report report = run(settings, {takes_tool(1), cut(19, 50, 0, 50), cut(0, 50, -19, 69)});
  ASSERT_TRUE(report.surface);
  EXPECT_NEAR(report.path.max_mm, 0, 1e-9);
  // Along the level nothing is off; on the slope the nose stays r(√2 - 1) away; its circle in the corner leaves no
  // more.
  EXPECT_NEAR(report.surface->lowest_mm, 0, 1e-9);
  EXPECT_NEAR(report.surface->highest_mm, std::sqrt(2.0) - 1, 1e-9);
}

TEST(Accuracy, ANoseCutsNoDeeperThanItsNeighboursAtARidge) {
  // Up and down again: both pieces are trimmed at the ridge, so what is cut there lies above no piece's own line.
  const curves::Profile ridge{
      {{{{-20, 0}, [](double z) { return curves::ExplicitPoint{50 + 0.1 * z, 0.1}; }, {}}, 0.01},
       {{{0, 20}, [](double z) { return curves::ExplicitPoint{50 - 0.1 * z, -0.1}; }, {}}, 0.01}}};
  const Settings settings{
      .nominal = ridge, .x_is_diameter = false, .tools = {{.number = 1, .nose_radius_mm = 1, .tip = 9}}};
  // The centre is led one radius above both flanks, around the ridge over the offsets' crossing.
  const double up = std::sqrt(1 + 0.01);
  const Report report = run(settings, {takes_tool(1), cut(19, 48.1 + up, 0, 50 + up), cut(0, 50 + up, -19, 48.1 + up)});
  ASSERT_TRUE(report.surface);
  EXPECT_NEAR(report.surface->max_mm, 0, 1e-9);
}

std::optional<double> chord_bound(const curves::Profile& profile, const curves::PathPiece& piece) {
  ChordBound bound(profile);
  bound.add(piece, curves::measure(profile, piece));
  return bound.value();
}

TEST(ChordBound, HoldsForArcsAndFindsAnArcOnItself) {
  const curves::Conic circle{curves::ConicKind::ellipse, 30, 30, {0, 20}};
  const curves::Profile profile{{{curves::curve_of(circle, {-20, 20}), 0.01}}};
  const curves::PathPiece same =
      curves::arc_between({15, circle.at(15).x}, {-15, circle.at(-15).x}, {0, 20}, curves::Turn::counterclockwise);
  EXPECT_NEAR(chord_bound(profile, same).value(), 0.0, 2e-6);
  const curves::PathPiece chord = curves::Segment{{5, circle.at(5).x}, {-5, circle.at(-5).x}};
  const double sagitta = 30 - std::sqrt(900 - 25.0);
  EXPECT_GE(*chord_bound(profile, chord), sagitta);
  EXPECT_LE(*chord_bound(profile, chord), 1.05 * sagitta);
  EXPECT_GE(*chord_bound(profile, curves::Segment{{5, 50}, {5, 60}}), 10.0);  // away from it
  EXPECT_EQ(chord_bound(profile, curves::Segment{{60, 50}, {70, 50}}), 0.0);  // next to it
  curves::Profile unbounded = profile;
  unbounded.pieces[0].curve.second_derivatives = nullptr;
  EXPECT_FALSE(chord_bound(unbounded, chord));
}

TEST(ChordBound, HoldsAcrossAJointOfTheProfile) {
  // Two lines that meet in a ridge: the chord over it passes below by as much as the ridge is high.
  const auto line = [](double slope) {
    return [slope](double z) { return curves::ExplicitPoint{50 + slope * z, slope}; };
  };
  const auto straight = [](double, double) { return curves::Range{}; };
  const curves::Profile roof{{{{{-10, 0}, line(0.1), straight}, 0.01}, {{{0, 10}, line(-0.1), straight}, 0.01}}};
  const double bound = *chord_bound(roof, curves::Segment{{4, 49.6}, {-4, 49.6}});
  EXPECT_GE(bound, 0.4 / std::sqrt(1.01) - 1e-9);
  EXPECT_LE(bound, 0.4 + 1e-9);
}

// A cam, an off-center cut and a tilted tool are no turning: nothing is claimed of them, and no gap of the nominal
// either.
TEST(Accuracy, JudgesNothingThatIsNoTurning) {
  const Settings settings{.nominal = straight(50, 0, {0, 40})};
  const auto with = [](ir::Axis axis, double start, double end) {
    ir::Motion motion = cut(40, 100, 0, 100);
    motion.start[static_cast<std::size_t>(axis)] = start;
    motion.end[static_cast<std::size_t>(axis)] = end;
    return motion;
  };
  for (const ir::Motion& motion : {with(ir::Axis::c, 0, 90), with(ir::Axis::y, 3, 3), with(ir::Axis::b, 0, 10)}) {
    const Report report = run(settings, {motion});
    EXPECT_EQ(report.blocks, 0U);
    EXPECT_FALSE(report.covered);
    EXPECT_TRUE(report.findings.empty());
    EXPECT_EQ(report.not_checked.list().size(), 2U);
  }
  EXPECT_EQ(run(settings, {with(ir::Axis::c, 90, 90)}).blocks, 1U) << "C that stands is where the part was clamped";
}

}  // namespace
}  // namespace dripfeed::accuracy
