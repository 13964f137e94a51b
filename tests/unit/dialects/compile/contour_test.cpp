// CYCLE95: passes, residual steps, finishing. Oracle: the passes by the cycle's rule, computed here; the contour's own
// points.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

// A cone from X20 Z0 to X60 Z-40, called by name. Places in diameter.
const Texts kCone = {{"CONE", "PROC CONE\nG1 X20 Z0\nX60 Z-40\nM17\n"}};
const std::string kHead = "G18 G710 G90 G95 DIAMON\nS500 M3\nG0 X80 Z10\n";

Result cycle(const std::string& arguments, const Texts& called = kCone, const std::string& rest = "") {
  return run(kHead + "CYCLE95(" + arguments + ")\nM30\n" + rest, called, ir::MachineKind::lathe);
}

std::vector<ir::Motion> moves_only(const Result& ran) {
  std::vector<ir::Motion> out;
  for (const ir::Motion& m : ran.motions)
    if (ir::is_move(m.kind)) out.push_back(m);
  return out;
}

void expect_at(const ir::Motion& m, ir::MotionKind kind, double x, double z) {
  EXPECT_EQ(static_cast<int>(m.kind), static_cast<int>(kind));
  EXPECT_NEAR(m.end[0], x, 1e-9);
  EXPECT_NEAR(m.end[2], z, 1e-9);
}

// 20 mm in radius by at most 6: four passes of 5.
TEST(Contour, RoughsInEqualPassesAndCutsTheStepsOff) {
  const Result ran = cycle("\"CONE\",6,0,0,0,0.3,0.2,0.15,1,0,0,2");
  const auto m = moves_only(ran);
  ASSERT_GE(m.size(), 8U) << ran.trace;
  using enum ir::MotionKind;
  expect_at(m[1], rapid, 64, 2);  // lift next to the first travel, over the highest level
  for (std::size_t n = 1; n <= 4; ++n) {
    const double radius = 30.0 - 5.0 * static_cast<double>(n);
    const double z = -2.0 * (radius - 10.0);
    std::size_t at = 2;
    while (at < m.size() &&
           !(m[at].kind == linear && std::abs(m[at].end[0] - 2.0 * radius) < 1e-9 && std::abs(m[at].end[2] - z) < 1e-9))
      ++at;
    ASSERT_LT(at + 2, m.size()) << "pass " << n << "\n" << ran.trace;
    EXPECT_NEAR(m[at].start[2], 2.0, 1e-9);
    EXPECT_NEAR(m[at].feed, 0.3, 1e-12);
    expect_at(m[at + 1], linear, 2.0 * (radius + 5.0), z - 10.0);
    expect_at(m[at + 2], rapid, 2.0 * (radius + 7.0), z - 8.0);
  }
  EXPECT_EQ(ran.result.not_interpreted.size(), 0U) << ran.trace;
}

TEST(Contour, AllowancesLieOutsideAndTheFinishTakesThem) {
  const Result ran = cycle("\"CONE\",25,0.1,0.2,0,0.3,0.2,0.15,9,0,0,1");
  const auto m = moves_only(ran);
  // One pass at the deepest level with its allowances: radius 10.2, and the contour 0.1 nearer.
  const auto along = std::ranges::find_if(m, [](const ir::Motion& x) { return x.kind == ir::MotionKind::linear; });
  ASSERT_NE(along, m.end());
  expect_at(*along, ir::MotionKind::linear, 20.4, 0.1);
  expect_at(*(along + 1), ir::MotionKind::linear, 60.4, -39.9);
  // The finish is the contour itself, with its own feed.
  const auto last =
      std::ranges::find_if(m.rbegin(), m.rend(), [](const ir::Motion& x) { return x.kind == ir::MotionKind::linear; });
  expect_at(*last, ir::MotionKind::linear, 60, -40);
  EXPECT_NEAR(last->start[0], 20, 1e-9);
  EXPECT_NEAR(last->feed, 0.15, 1e-12);
}

TEST(Contour, ByLabelsAndDrawnFromItsOtherEnd) {
  const Result by_name = cycle("\"CONE\",6,0,0,0,0.3,0.2,0.15,9,0,0,2");
  const Result by_labels =
      cycle("\"FIRST:LAST\",6,0,0,0,0.3,0.2,0.15,9,0,0,2", {}, "FIRST:\nG1 X20 Z0\nLAST: X60 Z-40\n");
  const Result backwards =
      cycle("\"BACK\",6,0,0,0,0.3,0.2,0.15,9,0,0,2", {{"BACK", "PROC BACK\nG1 X60 Z-40\nX20 Z0\nM17\n"}});
  const auto wanted = moves_only(by_name);
  ASSERT_GE(wanted.size(), 10U);
  expect_same(wanted, moves_only(by_labels), 1e-9, by_labels.trace);
  expect_same(wanted, moves_only(backwards), 1e-9, backwards.trace);
}

TEST(Contour, InsideCutsOutward) {
  const Result ran =
      cycle("\"BORE\",5,0,0,0,0.3,0.2,0.15,11,0,0,1", {{"BORE", "PROC BORE\nG1 X60 Z0\nX30 Z-30\nM17\n"}});
  for (const ir::Motion& m : moves_only(ran)) {
    if (m.kind != ir::MotionKind::linear) continue;
    // Never beyond the bore: at travel z the contour's diameter is 60 + z.
    EXPECT_LE(m.end[0], 60.0 + m.end[2] + 1e-9) << ran.trace;
  }
  EXPECT_EQ(ran.result.not_interpreted.size(), 0U);
}

TEST(Contour, FacesFromOutsideAndFollowsArcs) {
  const Result face =
      cycle("\"FACE\",4,0,0,0,0.3,0.2,0.15,10,0,0,1", {{"FACE", "PROC FACE\nG1 X60 Z-20\nX20 Z0\nM17\n"}});
  EXPECT_EQ(face.result.not_interpreted.size(), 0U) << face.trace;
  EXPECT_TRUE(face.trace.contains("linear X20.0000 Z0.0000")) << face.trace;
  const Result arc = cycle("\"ARC\",4,0,0,0,0.3,0.2,0.15,9,0,0,1",
                           {{"ARC", "PROC ARC\nG1 X20 Z0\nZ-10\nG2 X40 Z-20 CR=10\nG1 X60\nM17\n"}});
  std::size_t arcs = 0;
  for (const ir::Motion& m : moves_only(arc)) {
    if (m.kind != ir::MotionKind::arc_cw) continue;
    ++arcs;
    // About the centre X40 Z-10 with the radius 10.
    EXPECT_NEAR(m.start[0] / 2.0 + m.center[0], 20.0, 1e-9);
    EXPECT_NEAR(m.start[2] + m.center[2], -10.0, 1e-9);
    EXPECT_NEAR(std::hypot(m.end[0] / 2.0 - 20.0, m.end[2] + 10.0), 10.0, 1e-9);
  }
  EXPECT_GE(arcs, 3U) << arc.trace;
}

TEST(Contour, AlarmsAreNamed) {
  EXPECT_EQ(alarm_of(cycle("\"CONE\",5,0,0,0,0.3,0.2,0.15,13")), "61002");
  EXPECT_EQ(alarm_of(cycle("\"CONE\",5,0,0,0,0,0.2,0.15,1")), "61003");
  EXPECT_EQ(alarm_of(cycle("\"EMPTY\",5,0,0,0,0.3,0.2,0.15,1", {{"EMPTY", "PROC EMPTY\nG1 X20 Z0\nM17\n"}})), "61701");
  EXPECT_EQ(alarm_of(cycle("\"NOWHERE\",5,0,0,0,0.3,0.2,0.15,1")), "14011");
  EXPECT_EQ(alarm_of(cycle("\"A:B\",5,0,0,0,0.3,0.2,0.15,1")), "14080");
}

// From X40 Z-10 down to X30 at Z-15, 5 long at the bottom, and up again: a relief cut of 5 in radius. Outside of it the
// contour is a cone, in front of which nothing may be cut deeper than it is.
const Texts kNeck = {{"NECK", "PROC NECK\nG1 X20 Z0\nX40 Z-10\nX30 Z-15\nZ-20\nX60 Z-50\nM17\n"}};

double neck_diameter(double z) {
  if (z >= 0.0) return 20.0;
  if (z >= -10.0) return 20.0 - 2.0 * z;
  if (z >= -15.0) return 40.0 + 2.0 * (z + 10.0);
  return z >= -20.0 ? 30.0 : 30.0 - (z + 20.0);
}

TEST(Contour, ReliefCutsComeAfterWhatIsReachedFromInFront) {
  const Result ran = cycle("\"NECK\",4,0,0,0,0.3,0.2,0.15,1,0,0,1", kNeck);
  const auto m = moves_only(ran);
  EXPECT_EQ(ran.result.not_interpreted.size(), 0U) << ran.trace;
  // Nowhere below the contour, at the ends and in the middle of each move.
  for (const ir::Motion& move : m) {
    if (&move == m.data()) continue;
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      const double z = move.start[2] + share * (move.end[2] - move.start[2]);
      const double x = move.start[0] + share * (move.end[0] - move.start[0]);
      EXPECT_GE(x, neck_diameter(z) - 1e-6) << "line of " << ran.trace << " at Z" << z;
    }
  }
  // In front: down to radius 10 and no deeper than 40 in diameter after the height. 5 in radius by at most 4: two
  // passes of the relief, by 0.2 down the flank, by 0.3 along to the other one and up.
  std::vector<ir::Motion> down;
  for (const ir::Motion& move : m)
    if (move.feed == 0.2) down.push_back(move);
  ASSERT_EQ(down.size(), 4U) << ran.trace;  // each: onto the contour, and down
  expect_at(down[0], ir::MotionKind::linear, 40, -10);
  expect_at(down[1], ir::MotionKind::linear, 35, -12.5);
  expect_at(down[2], ir::MotionKind::linear, 35, -12.5);
  expect_at(down[3], ir::MotionKind::linear, 30, -15);
  const auto after = [&](const ir::Motion& move) {
    return *std::next(std::ranges::find_if(m, [&](const ir::Motion& one) {
      return one.feed == move.feed && one.end == move.end && one.start == move.start;
    }));
  };
  expect_at(after(down[1]), ir::MotionKind::linear, 35, -25);
  expect_at(after(down[3]), ir::MotionKind::linear, 30, -20);
  const auto relief = std::ranges::find_if(m, [](const ir::Motion& move) { return move.feed == 0.2; });
  for (auto at = m.begin() + 1; at != relief; ++at) {
    if (at->end[2] < -10.0 - 1e-9) {
      EXPECT_GE(at->end[0], 40.0 - 1e-6) << ran.trace;
    }
  }
  // The finish goes along all of it.
  const Result whole = cycle("\"NECK\",4,0,0,0,0.3,0.2,0.15,5,0,0,1", kNeck);
  EXPECT_TRUE(whole.trace.contains("linear X30.0000 Z-15.0000")) << whole.trace;
  EXPECT_TRUE(whole.trace.contains("linear X60.0000 Z-50.0000"));
  // Without a feed for it the cycle stops.
  EXPECT_EQ(alarm_of(cycle("\"NECK\",4,0,0,0,0.3,0,0.15,1", kNeck)), "61003");
}

// A groove with round flanks: an arc that turns back in its level is two flanks.
TEST(Contour, AnArcMayBeARelief) {
  const Texts groove = {{"GROOVE", "PROC GROOVE\nG1 X40 Z0\nZ-10\nG2 X40 Z-30 CR=20\nG1 Z-40\nX60\nM17\n"}};
  const Result ran = cycle("\"GROOVE\",1,0,0,0,0.3,0.2,0.15,9,0,0,1", groove);
  EXPECT_EQ(ran.result.not_interpreted.size(), 0U) << ran.trace;
  // The circle's centre stands over the middle of the groove: 17.32 over the height.
  const double center = 20.0 + std::sqrt(20.0 * 20.0 - 10.0 * 10.0);
  double deepest = 100.0;
  for (const ir::Motion& m : moves_only(ran)) {
    if (m.end[2] < -30.0 || m.end[2] > -10.0) continue;
    deepest = std::min(deepest, m.end[0] / 2.0);
    EXPECT_LE(std::hypot(m.end[0] / 2.0 - center, m.end[2] + 20.0), 20.0 + 1e-6) << ran.trace;
  }
  EXPECT_NEAR(deepest, center - 20.0, 1e-6);
}

// Outside levels go deeper against their axis, inside along it: facing from inside is facing from outside in a mirror.
TEST(Contour, FacesFromInside) {
  const Texts back = {{"BACK", "PROC BACK\nG1 X20 Z20\nX60 Z0\nM17\n"}};
  const Texts face = {{"BACK", "PROC BACK\nG1 X20 Z-20\nX60 Z0\nM17\n"}};
  const std::string arguments = "(\"BACK\",6,0,0,0,0.3,0.2,0.15,";
  const std::string head = "G18 G710 G90 G95 DIAMON\nS500 M3\n";
  const Result inside =
      run(head + "G0 X10 Z-10\nCYCLE95" + arguments + "12,0,0,2)\nM30\n", back, ir::MachineKind::lathe);
  const Result outside =
      run(head + "G0 X10 Z10\nCYCLE95" + arguments + "10,0,0,2)\nM30\n", face, ir::MachineKind::lathe);
  const auto a = moves_only(inside);
  const auto b = moves_only(outside);
  EXPECT_EQ(inside.result.not_interpreted.size(), 0U) << inside.trace;
  ASSERT_EQ(a.size(), b.size()) << inside.trace << outside.trace;
  ASSERT_GT(a.size(), 12U);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i].end[0], b[i].end[0], 1e-9);
    EXPECT_NEAR(a[i].end[2], -b[i].end[2], 1e-9);
    EXPECT_EQ(a[i].feed, b[i].feed);
  }
}

// FAL: next to a cone of 45 degrees, a cylinder and a shoulder; every point of the last pass lies at that distance.
TEST(Contour, AnAllowanceAlongTheContour) {
  const Texts step = {{"STEP", "PROC STEP\nG1 X20 Z0\nX30 Z-5\nZ-20\nG2 X40 Z-25 CR=5\nG1 X60\nM17\n"}};
  const Result ran = cycle("\"STEP\",50,0,0,0.5,0.3,0.2,0.15,9,0,0,1", step);
  EXPECT_EQ(ran.result.not_interpreted.size(), 0U) << ran.trace;
  const auto m = moves_only(ran);
  std::vector<ir::Motion> rough;
  for (const ir::Motion& move : m)
    if (move.feed == 0.3) rough.push_back(move);
  const double part = 0.5 * std::sqrt(0.5);
  ASSERT_EQ(rough.size(), 6U) << ran.trace;
  expect_at(rough[0], ir::MotionKind::linear, 2.0 * (10.0 + part), part);         // along the level to the cone
  expect_at(rough[1], ir::MotionKind::linear, 2.0 * (15.0 + part), -5.0 + part);  // next to the cone
  // About the outer corner, then next to the cylinder.
  EXPECT_NEAR(rough[2].end[0], 31.0, 1e-9);
  EXPECT_NEAR(rough[2].end[2], -5.0, 1e-9);
  EXPECT_NEAR(
      std::hypot(rough[2].start[0] / 2.0 + rough[2].center[0] - 15.0, rough[2].start[2] + rough[2].center[2] + 5.0),
      0.0, 1e-9);
  expect_at(rough[3], ir::MotionKind::linear, 31, -20);
  // Inside of the arc: radius 4.5 about X40 Z-20.
  expect_at(rough[4], ir::MotionKind::arc_cw, 40, -24.5);
  EXPECT_NEAR(std::hypot(rough[4].center[0], rough[4].center[2]), 4.5, 1e-9);
  expect_at(rough[5], ir::MotionKind::linear, 60, -24.5);
  // The finish takes it.
  EXPECT_TRUE(ran.trace.contains("linear X30.0000 Z-20.0000")) << ran.trace;
}

// The corners are the contour's: a chamfer from (18, -20) to (20, -21), a quarter circle to (28, -40).
TEST(Contour, CornersOfTheContourAreCut) {
  const Texts called = {{"PART", "G1 X20 Z0\nZ-20\nX40 CHR=1\nZ-40\nX60 RND=2\nZ-50\nX70\nM17\n"}};
  const Result ran = cycle("\"PART\",5,0,0,0,0.3,0.2,0.15,5", called);
  EXPECT_FALSE(ran.names("a chamfer or rounding that does not fit its corner")) << ran.trace;
  EXPECT_TRUE(ran.trace.contains("linear X38.0000 Z-20.0000")) << ran.trace;
  EXPECT_TRUE(ran.trace.contains("linear X40.0000 Z-21.0000")) << ran.trace;
  EXPECT_TRUE(ran.trace.contains("linear X56.0000 Z-40.0000")) << ran.trace;
  EXPECT_TRUE(ran.trace.contains("arc-ccw X60.0000 Z-42.0000 G18 I0.0000 J0.0000 K-2.0000")) << ran.trace;
}

// Its feeds are the cycle's.
TEST(Contour, NeedsNoFeedOfItsOwn) {
  const Texts called = {{"PART", "G1 X20 Z0\nZ-20\nX70\nM17\n"}};
  const Result ran = run("G18 G90 G95 DIAMON\nG0 X82 Z5\nCYCLE95(\"PART\",5,0,0,0,0.3,0.2,0.15,9)\nM30\n", called,
                         ir::MachineKind::lathe);
  EXPECT_TRUE(ran.result.diagnostics.empty()) << text::message_of(ran.result.diagnostics.front().diagnostic);
}

TEST(Contour, WhatIsNotInterpretedIsReportedAndNothingIsCut) {
  const Texts stairs = {{"NECK", "PROC NECK\nG1 X20 Z0\nX40 Z-10\nX30 Z-15\nX35 Z-20\nX25 Z-25\nX60 Z-40\nM17\n"}};
  const Result neck = cycle("\"NECK\",5,0,0,0,0.3,0.2,0.15,9", stairs);
  EXPECT_TRUE(neck.names("CYCLE95 with a relief cut that is not a plain one, in line 4")) << neck.trace;
  EXPECT_EQ(moves_only(neck).size(), 1U) << neck.trace;
  const Texts ends = {{"NECK", "PROC NECK\nG1 X20 Z0\nX40 Z-10\nX30 Z-15\nM17\n"}};
  EXPECT_TRUE(cycle("\"NECK\",5,0,0,0,0.3,0.2,0.15,9", ends)
                  .names("CYCLE95 with a relief cut that is not a plain one, in line 4"));
  const Texts back = {{"NECK", "PROC NECK\nG1 X20 Z0\nX40 Z-10\nX50 Z-5\nX60 Z-40\nM17\n"}};
  EXPECT_TRUE(cycle("\"NECK\",5,0,0,0,0.3,0.2,0.15,9", back).names("CYCLE95 along a contour that reverses in line 4"));
  const Texts small = {{"NECK", "PROC NECK\nG1 X20 Z0\nZ-10\nX21 Z-10.5\nX60\nM17\n"}};
  EXPECT_TRUE(cycle("\"NECK\",5,0,0,2,0.3,0.2,0.15,9", small)
                  .names("CYCLE95 with an allowance along the contour (FAL) that a piece of it is too short for"));
  for (const std::string name : {"CYCLE93", "CYCLE94", "CYCLE79"}) {
    const Result other = run(kHead + name + "(1,2,3)\nM30\n", {}, ir::MachineKind::lathe);
    EXPECT_TRUE(other.names(name));
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
