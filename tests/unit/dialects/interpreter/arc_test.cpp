// Arcs in every form against closed forms: centres, radii, angles, planes, helices and what must be refused.
#include "dialects/interpreter/motion/arc.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using interpreter::Turn;
using ir::Address;
using ir::Function;
using Builder = ProgramBuilder;
using Word = Builder::WordText;

constexpr double kTolerance = 1e-9;

// Runs a rapid to `start`, then one block, and gives its motions.
Ran run_from(std::vector<Word> start, std::vector<Builder::CodeText> codes, std::vector<Word> words,
             const ir::Control& control = mill_control()) {
  Builder b;
  b.block({{Function::rapid}}, start);
  b.block({}, {{Address::f, 100.0}});
  b.block(codes, words);
  b.end();
  return run_program(b.build(), control);
}
ir::Motion only_arc(const Ran& ran) {
  EXPECT_EQ(ran.motions.size(), 3U) << ran.trace;
  return ran.motions.size() < 2 ? ir::Motion{} : ran.motions[1];
}

TEST(Arc, CenterByIncrements) {
  const ir::Motion m = only_arc(run_from({{Address::x, 10.0}, {Address::y, 0.0}}, {{Function::arc_ccw}},
                                         {{Address::x, 0.0}, {Address::y, 10.0}, {Address::i, -10.0}}));
  EXPECT_EQ(m.kind, ir::MotionKind::arc_ccw);
  EXPECT_EQ(m.center, (std::array<double, 3>{-10.0, 0.0, 0.0}));
  EXPECT_EQ(m.end[0], 0.0);
  EXPECT_EQ(m.end[1], 10.0);
}

TEST(Arc, CenterByIncrementsWhateverTheDistanceMode) {
  const ir::Motion m =
      only_arc(run_from({{Address::x, 10.0}, {Address::y, 0.0}}, {{Function::incremental}, {Function::arc_ccw}},
                        {{Address::x, -10.0}, {Address::y, 10.0}, {Address::i, -10.0}}));
  EXPECT_EQ(m.center, (std::array<double, 3>{-10.0, 0.0, 0.0}));
  EXPECT_EQ(m.end[0], 0.0);
  EXPECT_EQ(m.end[1], 10.0);
}

TEST(Arc, CenterAbsoluteByWord) {
  const ir::Motion m = only_arc(run_from({{Address::x, 10.0}, {Address::y, 3.0}}, {{Function::arc_cw}},
                                         {{Address::x, 20.0},
                                          {Address::y, 13.0},
                                          Word(Address::i, 20.0, ir::WordMode::absolute),
                                          Word(Address::j, 3.0, ir::WordMode::absolute)},
                                         sinumerik_control()));
  EXPECT_EQ(m.center, (std::array<double, 3>{10.0, 0.0, 0.0}));
}

// The centre lies at the same distance from both ends, on the side that the turn and the sign of the radius say.
TEST(Arc, RadiusGivesTheRightOneOfFourArcs) {
  struct Row {
    Function code;
    double radius;
    double opening_deg;
  };
  const double half_chord = 5.0 * std::numbers::sqrt2;
  const double small = 2.0 * std::asin(half_chord / 10.0) * 180.0 / std::numbers::pi;
  const Row rows[] = {{Function::arc_cw, 10.0, small},
                      {Function::arc_ccw, 10.0, small},
                      {Function::arc_cw, -10.0, 360.0 - small},
                      {Function::arc_ccw, -10.0, 360.0 - small}};
  for (const Row& row : rows) {
    const ir::Motion m = only_arc(run_from({{Address::x, 0.0}, {Address::y, 0.0}}, {{row.code}},
                                           {{Address::x, 10.0}, {Address::y, 10.0}, {Address::r, row.radius}}));
    EXPECT_NEAR(std::hypot(m.center[0], m.center[1]), 10.0, kTolerance);
    EXPECT_NEAR(std::hypot(m.center[0] - 10.0, m.center[1] - 10.0), 10.0, kTolerance);
    const Turn turn = row.code == Function::arc_cw ? Turn::clockwise : Turn::counterclockwise;
    EXPECT_NEAR(interpreter::opening_of({m.center[0], m.center[1]}, {10.0, 10.0}, turn), row.opening_deg, kTolerance);
  }
}

TEST(Arc, RadiusWinsOverCenter) {
  const ir::Motion m =
      only_arc(run_from({{Address::x, 0.0}, {Address::y, 0.0}}, {{Function::arc_cw}},
                        {{Address::x, 20.0}, {Address::y, 0.0}, {Address::r, 10.0}, {Address::i, 99.0}}));
  EXPECT_NEAR(m.center[0], 10.0, kTolerance);
  EXPECT_NEAR(m.center[1], 0.0, kTolerance);
}

TEST(Arc, OwnAddressOfTheRadius) {
  const ir::Motion m =
      only_arc(run_from({{Address::x, 0.0}, {Address::y, 0.0}}, {{Function::arc_cw}},
                        {{Address::x, 20.0}, {Address::y, 0.0}, {Address::arc_radius, 10.0}}, sinumerik_control()));
  EXPECT_NEAR(m.center[0], 10.0, kTolerance);
}

TEST(Arc, FullCircleNeedsACenter) {
  const Ran circle = run_from({{Address::x, 10.0}, {Address::y, 0.0}}, {{Function::arc_cw}}, {{Address::i, -10.0}});
  const ir::Motion m = only_arc(circle);
  EXPECT_EQ(m.start, m.end);
  EXPECT_EQ(m.center[0], -10.0);
  const Ran by_radius = run_from({{Address::x, 10.0}, {Address::y, 0.0}}, {{Function::arc_cw}},
                                 {{Address::x, 10.0}, {Address::y, 0.0}, {Address::r, 10.0}});
  EXPECT_EQ(by_radius.result.ended, interpreter::Ended::alarm);
}

TEST(Arc, Helix) {
  const ir::Motion m = only_arc(
      run_from({{Address::x, 10.0}, {Address::y, 0.0}, {Address::z, 0.0}}, {{Function::arc_ccw}},
               {{Address::x, -10.0}, {Address::y, 0.0}, {Address::z, -2.0}, {Address::i, -10.0}, {Address::j, 0.0}}));
  EXPECT_EQ(m.end[2], -2.0);
  EXPECT_EQ(m.center, (std::array<double, 3>{-10.0, 0.0, 0.0}));
}

TEST(Arc, TurnsBecomeCirclesThatShareTheDepth) {
  const Ran ran = run_from({{Address::x, 10.0}, {Address::y, 0.0}, {Address::z, 0.0}}, {{Function::arc_ccw}},
                           {{Address::x, -10.0},
                            {Address::y, 0.0},
                            {Address::z, -5.0},
                            {Address::i, -10.0},
                            {Address::j, 0.0},
                            {Address::turns, 2.0}},
                           sinumerik_control());
  ASSERT_EQ(ran.motions.size(), 5U) << ran.trace;
  // 360 + 360 + 180 degrees over 5 mm.
  EXPECT_NEAR(ran.motions[1].end[2], -2.0, kTolerance);
  EXPECT_NEAR(ran.motions[2].end[2], -4.0, kTolerance);
  EXPECT_EQ(ran.motions[2].end[0], 10.0);
  EXPECT_EQ(ran.motions[3].end[2], -5.0);
  EXPECT_EQ(ran.motions[3].end[0], -10.0);
}

TEST(Arc, OpeningAngleWithEndOrCenter) {
  const ir::Motion by_end =
      only_arc(run_from({{Address::x, 0.0}, {Address::y, 0.0}}, {{Function::arc_ccw}},
                        {{Address::x, 10.0}, {Address::y, 10.0}, {Address::opening_angle, 90.0}}, sinumerik_control()));
  EXPECT_NEAR(by_end.center[0], 0.0, kTolerance);
  EXPECT_NEAR(by_end.center[1], 10.0, kTolerance);
  const ir::Motion by_center = only_arc(
      run_from({{Address::x, 10.0}, {Address::y, 0.0}}, {{Function::arc_cw}},
               {{Address::i, -10.0}, {Address::j, 0.0}, {Address::opening_angle, 270.0}}, sinumerik_control()));
  EXPECT_NEAR(by_center.end[0], 0.0, kTolerance);
  EXPECT_NEAR(by_center.end[1], 10.0, kTolerance);
}

// G18 has Z as its first axis: seen from +Y, a counterclockwise arc turns from Z to X.
TEST(Arc, PlanesHaveTheirOwnAxes) {
  const ir::Motion zx =
      only_arc(run_from({{Address::x, 0.0}, {Address::z, 10.0}}, {{Function::plane_zx}, {Function::arc_ccw}},
                        {{Address::x, 10.0}, {Address::z, 0.0}, {Address::r, 10.0}}));
  EXPECT_NEAR(zx.center[0], 0.0, kTolerance);
  EXPECT_NEAR(zx.center[2], -10.0, kTolerance);
  EXPECT_EQ(zx.plane, ir::Plane::zx);
  const ir::Motion yz =
      only_arc(run_from({{Address::y, 10.0}, {Address::z, 0.0}}, {{Function::plane_yz}, {Function::arc_ccw}},
                        {{Address::y, 0.0}, {Address::z, 10.0}, {Address::j, -10.0}}));
  EXPECT_EQ(yz.center, (std::array<double, 3>{0.0, -10.0, 0.0}));
}

// On a lathe X is a diameter in the end point and a radius in the centre.
TEST(Arc, DiameterAxis) {
  const ir::Motion m =
      only_arc(run_from({{Address::x, 40.0}, {Address::z, 0.0}}, {{Function::arc_cw}},
                        {{Address::x, 60.0}, {Address::z, -10.0}, {Address::r, 10.0}}, lathe_control()));
  EXPECT_EQ(m.end[0], 60.0);
  // From radius 20 to radius 30 over 10 mm of Z: a quarter. Clockwise in ZX, so the centre lies at the end's X.
  EXPECT_NEAR(m.center[0], 10.0, kTolerance);
  EXPECT_NEAR(m.center[2], 0.0, kTolerance);
}

TEST(Arc, RadiiMustAgreeWithinTheTolerance) {
  const auto arc_to = [](double x) {
    return run_from({{Address::x, 10.0}, {Address::y, 0.0}}, {{Function::arc_ccw}},
                    {{Address::x, x}, {Address::y, 10.0}, {Address::i, -10.0}});
  };
  EXPECT_EQ(arc_to(0.1).result.ended, interpreter::Ended::end);  // radius 10.0005
  const Ran wrong = arc_to(1.0);
  EXPECT_EQ(wrong.result.ended, interpreter::Ended::alarm);
  ASSERT_NE(wrong.last_diagnostic(), nullptr);
  EXPECT_EQ(wrong.last_diagnostic()->diagnostic.id, text::DiagnosticId::arc_radius_mismatch);
  EXPECT_EQ(wrong.last_diagnostic()->diagnostic.arguments, (std::vector<std::string>{"10.0000", "10.0499"}));
  EXPECT_EQ(wrong.last_diagnostic()->line, 3U);
  // A radius shorter than half the chord: within the tolerance it is a half circle.
  const auto radius = [](double r) {
    return run_from({{Address::x, 0.0}, {Address::y, 0.0}}, {{Function::arc_ccw}},
                    {{Address::x, 20.0}, {Address::y, 0.0}, {Address::r, r}});
  };
  EXPECT_NEAR(only_arc(radius(9.99)).center[0], 10.0, kTolerance);
  EXPECT_EQ(radius(9.9).result.ended, interpreter::Ended::alarm);
}

TEST(Arc, NeedsCenterOrRadius) {
  const Ran ran = run_from({{Address::x, 10.0}, {Address::y, 0.0}}, {{Function::arc_cw}}, {{Address::x, 20.0}});
  EXPECT_EQ(ran.result.ended, interpreter::Ended::alarm);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, text::DiagnosticId::arc_without_center);
}

TEST(Arc, OpeningIsSymmetric) {
  for (double angle = 1.0; angle < 360.0; angle += 7.0) {
    for (const Turn turn : {Turn::clockwise, Turn::counterclockwise}) {
      const interpreter::PlanePoint center{3.0, -4.0};
      const interpreter::PlanePoint end = interpreter::end_by_opening(center, angle, turn);
      EXPECT_NEAR(interpreter::opening_of(center, end, turn), angle, 1e-9);
      const auto radius = interpreter::radius_by_opening(interpreter::length_of(end), angle);
      ASSERT_TRUE(radius.has_value());
      EXPECT_NEAR(std::abs(*radius), 5.0, 1e-9);
      const auto again = interpreter::center_by_radius(end, *radius, turn, 1e-6);
      ASSERT_TRUE(again.has_value());
      EXPECT_NEAR(again->p, center.p, 1e-6) << angle;
      EXPECT_NEAR(again->q, center.q, 1e-6) << angle;
    }
  }
}

}  // namespace
}  // namespace dripfeed::test
