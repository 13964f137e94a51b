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
  expect_at(m[1], rapid, 64, 2);  // lift beside the first way, over the highest level
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
    // Never beyond the bore: at way z the contour's diameter is 60 + z.
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

TEST(Contour, WhatIsNotInterpretedIsToldAndNothingIsCut) {
  const Texts relief = {{"NECK", "PROC NECK\nG1 X20 Z0\nX40 Z-10\nX30 Z-15\nX60 Z-40\nM17\n"}};
  const Result neck = cycle("\"NECK\",5,0,0,0,0.3,0.2,0.15,9", relief);
  EXPECT_TRUE(neck.names("CYCLE95 with relief cuts: the contour falls back in line 4"));
  EXPECT_EQ(moves_only(neck).size(), 1U) << neck.trace;
  EXPECT_TRUE(cycle("\"CONE\",5,0,0,0.3,0.3,0.2,0.15,9").names("CYCLE95 with an allowance along the contour (FAL)"));
  EXPECT_TRUE(cycle("\"CONE\",5,0,0,0,0.3,0.2,0.15,4").names("CYCLE95 that faces from inside (VARI 4, 8, 12)"));
  for (const std::string name : {"CYCLE93", "POCKET3", "POCKET4"}) {
    const Result other = run(kHead + name + "(1,2,3)\nM30\n", {}, ir::MachineKind::lathe);
    EXPECT_TRUE(other.names(name));
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
