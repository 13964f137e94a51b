// CIP in space and arcs in planes that a frame tilts, as programs. Oracle: the circle's own equations; for tilted
// planes the same program without the frame, turned by hand.
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/interpreter/motion/curve_chords.h"
#include "dialects/text/number.h"
#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

using Point = std::array<double, 3>;

std::vector<ir::Motion> chords(const Result& ran) {
  std::vector<ir::Motion> out;
  for (const ir::Motion& m : ran.motions)
    if (m.kind == ir::MotionKind::spline) out.push_back(m);
  return out;
}
Point end_of(const ir::Motion& m) { return {m.end[0], m.end[1], m.end[2]}; }
Point start_of(const ir::Motion& m) { return {m.start[0], m.start[1], m.start[2]}; }
double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

// Chords that hang together, end on the sphere about the centre and leave it no farther than is promised.
void expect_round(const std::vector<ir::Motion>& moves, const Point& center, double radius) {
  ASSERT_GE(moves.size(), 8U);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Point a = start_of(moves[i]);
    const Point b = end_of(moves[i]);
    EXPECT_NEAR(distance(b, center), radius, 1e-9) << i;
    const Point middle = {(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0, (a[2] + b[2]) / 2.0};
    EXPECT_NEAR(distance(middle, center), radius, 1.01 * interpreter::kCurveChord_mm) << i;
    if (i > 0) {
      EXPECT_EQ(moves[i].start, moves[i - 1].end) << i;
    }
  }
}
double length_of(const std::vector<ir::Motion>& moves) {
  double sum = 0.0;
  for (const ir::Motion& m : moves) sum += distance(start_of(m), end_of(m));
  return sum;
}

const std::string kHead = "G17 G90 G94 G1 X0 Y0 Z0 F500\n";

TEST(ArcInSpace, ThroughAPoint) {
  for (const std::string block :
       {"CIP X10 Y0 Z0 I1=5 J1=0 K1=5", "CIP X10 I1=5 K1=5", "G91 CIP X10 I1=5 K1=5", "CIP X=IC(10) I1=IC(5) K1=IC(5)",
        "G91 CIP X10 I1=AC(5) K1=AC(5)", "TRANS X0\nCIP X10 I1=5 K1=5"}) {
    const Result ran = run(kHead + block + "\nG90 G1 X20 Y0 Z0\nM30\n");
    const auto moves = chords(ran);
    expect_round(moves, {5.0, 0.0, 0.0}, 5.0);
    EXPECT_NEAR(length_of(moves), 5.0 * std::numbers::pi, 0.01);
    for (const ir::Motion& m : moves) {
      EXPECT_EQ(m.end[1], 0.0);
      EXPECT_GE(m.end[2], 0.0);  // on the side of the point
      EXPECT_EQ(m.feed, 500.0);
      EXPECT_EQ(m.axes_commanded & 5U, 5U);
    }
    EXPECT_EQ(end_of(moves.back()), (Point{10.0, 0.0, 0.0}));
    EXPECT_TRUE(ran.result.not_interpreted.empty());
    EXPECT_TRUE(ran.trace.ends_with(" linear X20.0000 Y0.0000 Z0.0000 F500.0000/min\n" +
                                    std::to_string(ran.motions.back().place.line) + " end\n"))
        << ran.trace;
  }
}

// Three quarters of a circle, its plane leaned at 45 degrees, over (0 -1 -1) from its centre.
TEST(ArcInSpace, TheSlowPath) {
  const Result ran = run("G17 G90 G94 G1 X10 Y0 Z0 F500\nR1=10*SQRT(0.5)\nCIP X0 Y=-R1 Z=-R1 I1=0 J1=R1 K1=R1\nM30\n");
  const auto moves = chords(ran);
  expect_round(moves, {0.0, 0.0, 0.0}, 10.0);
  EXPECT_NEAR(length_of(moves), 15.0 * std::numbers::pi, 0.02);
  for (const ir::Motion& m : moves) EXPECT_NEAR(m.end[1], m.end[2], 1e-9);
}

// X counts a diameter, in between as at the end: a half circle of radius 5.
TEST(ArcInSpace, OtherAxesGoAlongEvenly) {
  const Result ran =
      run("G17 G90 G94 DIAMON G1 X0 Y0 Z0 C0 F500\nCIP X20 C90 I1=10 K1=5\nM30\n", {}, ir::MachineKind::mill_turn);
  const auto moves = chords(ran);
  ASSERT_FALSE(moves.empty());
  for (const ir::Motion& m : moves) {
    EXPECT_NEAR(std::hypot(m.end[0] / 2.0 - 5.0, m.end[2]), 5.0, 1e-9);
    const double angle = std::atan2(m.end[2], 5.0 - m.end[0] / 2.0);
    EXPECT_NEAR(m.end[5], 90.0 * angle / std::numbers::pi, 1e-9);
  }
  EXPECT_EQ(moves.back().end[5], 90.0);
}

// G93: the chords together take the time of the block.
TEST(ArcInSpace, SharesItsTime) {
  const Result ran = run(kHead + "G93 CIP X10 I1=5 K1=5 F4\nM30\n");
  double minutes = 0.0;
  for (const ir::Motion& m : chords(ran)) minutes += 1.0 / m.feed;
  EXPECT_NEAR(minutes, 0.25, 1e-12);
}

TEST(ArcInSpace, ATangentGoesOnFromIt) {
  // It comes down along -Z; CT needs the plane's part of the direction, which is none there, and goes straight.
  const Result down = run(kHead + "CIP X10 I1=5 K1=5\nCT X20 Y5\nM30\n");
  EXPECT_TRUE(down.trace.contains("3 linear X20.0000 Y5.0000")) << down.trace;
  // A quarter up to (5 0 5), where it goes along X.
  const Result flat = run(kHead + "CIP X5 Z5 I1=5-5*COS(45) K1=5*SIN(45)\nCT X10 Y5\nM30\n");
  EXPECT_TRUE(flat.trace.contains("3 arc-ccw X10.0000 Y5.0000 Z5.0000 G17 I0.0000 J5.0000")) << flat.trace;
}

TEST(ArcInSpace, WhatIsNoArc) {
  // In between on the same line: straight. Next to it, or back to the start: no circle.
  EXPECT_TRUE(run(kHead + "CIP X10 Z10 I1=5 K1=5\nM30\n").trace.contains("2 linear X10.0000 Y0.0000 Z10.0000"));
  for (const std::string block : {"CIP X10 Z10 I1=20 K1=20", "CIP X0 Y0 I1=5 K1=5", "CIP X10 I1=12", "CIP X10 I1=-1",
                                  "CIP X10 Y10", "CIP X10 I1=5 J1=5 TURN=1"}) {
    const Result ran = run(kHead + block + "\nM30\n");
    EXPECT_TRUE(ran.names("CIP through points that make no circle")) << block << ran.trace;
    EXPECT_TRUE(chords(ran).empty());
  }
  const Result lost = run("G17 G90 G94 G1 X0 Y0 F500\nCIP X10 Z0 I1=5 K1=5\nM30\n");
  EXPECT_TRUE(lost.names("arcs from or to a position that is not known")) << lost.trace;
}

// --- planes that a frame tilts

// Turned about X by 30 degrees: (x y z) -> (x, y cos - z sin, y sin + z cos).
Point turned(const Point& p) {
  const double c = std::sqrt(0.75);
  return {p[0], c * p[1] - 0.5 * p[2], 0.5 * p[1] + c * p[2]};
}
Point turned_back(const Point& p) {
  const double c = std::sqrt(0.75);
  return {p[0], c * p[1] + 0.5 * p[2], -0.5 * p[1] + c * p[2]};
}

// Each form of arc: the ends of the plain run are met, and every chord's end lies on the plain run's arc.
TEST(TiltedPlane, EveryFormOfArc) {
  for (const std::string block :
       {"G2 X20 Y10 I5 J0", "G3 X20 Y10 CR=7", "G3 X20 Y10 CR=-7", "G2 X20 Y10 AR=120", "G2 I5 J0 AR=200",
        "G2 X20 Y10 I=AC(15) J=AC(10)", "G91 G3 X10 Y0 I5", "G2 X20 Y10 Z9 I5 J0", "G2 I5 J0 X20 Y10 Z14 TURN=2",
        "G1 X12 Y11\nCT X20 Y10", "CIP X20 Y10 I1=15 J1=15", "G111 X15 Y10\nG2 RP=5 AP=0"}) {
    const std::string head = "G17 G90 G94 G0 X0 Y0 Z0\n";
    const std::string tail = "G1 X10 Y10 Z4 F500\n" + block + "\nG90 G1 X0 Y0\nM30\n";
    const Result plain = run(head + "TRANS Z1\n" + tail);
    const Result tilted = run(head + "TRANS Z1\nAROT X30\n" + tail);
    EXPECT_TRUE(tilted.result.not_interpreted.empty()) << block;
    std::size_t at = 0;
    const auto moves = moves_of(tilted.motions);
    for (const ir::Motion& m : moves_of(plain.motions)) {
      const bool arc = m.kind == ir::MotionKind::arc_cw || m.kind == ir::MotionKind::arc_ccw;
      const auto untilted = [&](const ir::Motion& n) {
        Point p = end_of(n);
        p[2] -= n.kind == ir::MotionKind::rapid ? 0.0 : 1.0;
        return turned_back(p);
      };
      Point want = end_of(m);
      if (m.kind != ir::MotionKind::rapid) want[2] -= 1.0;
      if (!arc) {
        ASSERT_LT(at, moves.size()) << block;
        const Point got = m.kind == ir::MotionKind::rapid ? end_of(moves[at]) : untilted(moves[at]);
        EXPECT_LT(distance(got, want), 1e-9) << block << " " << tilted.trace;
        ++at;
        continue;
      }
      const Point center = {m.start[0] + m.center[0], m.start[1] + m.center[1], 0.0};
      const double radius = std::hypot(m.center[0], m.center[1]);
      const double rise = m.end[2] - m.start[2];
      const double start = std::atan2(-m.center[1], -m.center[0]);
      const double sign = m.kind == ir::MotionKind::arc_ccw ? 1.0 : -1.0;
      const double full = 2.0 * std::numbers::pi;
      const auto turned_by = [&](const Point& p) {
        const double angle = sign * (std::atan2(p[1] - center[1], p[0] - center[0]) - start);
        const double wrapped = std::fmod(angle + 2.0 * full, full);
        return wrapped < 1e-9 ? full : wrapped;
      };
      const double sweep = turned_by({m.end[0], m.end[1], 0.0});
      double before = 0.0;
      for (bool there = false; !there && at < moves.size(); ++at) {
        ASSERT_EQ(static_cast<int>(moves[at].kind), static_cast<int>(ir::MotionKind::spline)) << block;
        const Point p = untilted(moves[at]);
        EXPECT_NEAR(std::hypot(p[0] - center[0], p[1] - center[1]), radius, 1e-9) << block;
        const double by = turned_by(p);
        EXPECT_GT(by, before) << block;
        EXPECT_NEAR(p[2] + 1.0, m.start[2] + rise * by / sweep, 1e-9) << block;
        before = by;
        there = distance(p, want) < 1e-9;
      }
      EXPECT_NEAR(before, sweep, 1e-9) << block;
    }
    EXPECT_EQ(at, moves.size()) << block;
  }
}

// Turned back and forth the start is rounded; a full circle stays one.
TEST(TiltedPlane, FullCircles) {
  for (int n = 0; n < 60; ++n) {
    const std::string place =
        "X" + text::format_fixed(11.419 + 3.7 * n, 3) + " Y" + text::format_fixed(18.361 - 1.3 * n, 3);
    for (const auto& [block, turns] : {std::pair{" I5 J0", 1.0}, std::pair{" I3 J4 TURN=1", 2.0}}) {
      const Result ran = run("G17 G90 G94 G64 F100 G0 X0 Y0 Z0\nROT X21\nAROT Y62\nG1 X15.3 Y4.7 Z-4.1\nG1 " + place +
                             "\nG3 " + place + block + "\nM30\n");
      EXPECT_NEAR(length_of(chords(ran)), turns * 10.0 * std::numbers::pi, 0.02) << place << block;
    }
  }
}

TEST(TiltedPlane, ThroughAPointInSpace) {
  const Result ran = run("G17 G90 G94 G0 X0 Y0 Z0\nROT X30\nG1 F500\nCIP X10 I1=5 K1=5\nM30\n");
  const auto moves = chords(ran);
  expect_round(moves, {5.0, 0.0, 0.0}, 5.0);
  for (const ir::Motion& m : moves) EXPECT_NEAR(turned_back(end_of(m))[1], 0.0, 1e-9);
  const Point top = turned({5.0, 0.0, 5.0});
  EXPECT_TRUE(std::ranges::any_of(moves, [&](const ir::Motion& m) { return distance(end_of(m), top) < 1e-9; }));
}

// In its plane the frame turns an arc and no more: one motion, as it was.
TEST(TiltedPlane, ATurnInThePlaneIsNone) {
  const Result ran = run("G17 G90 G94 G0 X0 Y0 Z0\nROT Z90\nG1 X10 F500\nCIP X30 I1=20 J1=10\nM30\n");
  EXPECT_TRUE(ran.trace.contains("4 arc-cw X0.0000 Y30.0000 Z0.0000 G17 I0.0000 J10.0000")) << ran.trace;
}

TEST(TiltedPlane, WhatIsReportedInstead) {
  const std::string head = "G17 G90 G94 G0 X0 Y0 Z0\n";
  for (const std::string text : {"SCALE X2\nCIP X10 I1=5 J1=5 F500\n", "SCALE X2\nAROT X30\nG2 X10 I5 F500\n",
                                 "SCALE Z2\nCIP X10 I1=5 K1=5 F500\n"})
    EXPECT_TRUE(run(head + text + "M30\n").names("arcs that a frame stretches")) << text;
  EXPECT_TRUE(run("G17 G90 G94 G0 X0 Y0\nROT X30\nG2 X10 I5 F500\nM30\n")
                  .names("arcs from or to a position that is not known"));
  const std::string comp = "compensation of the radius in a plane that a frame tilts";
  EXPECT_TRUE(run(head + "T1 D1\nROT X30\nG41 G1 X10 F500\nG40 G1 X20\nM30\n").names(comp));
  EXPECT_FALSE(run(head + "T1 D1\nROT Z30\nG41 G1 X10 F500\nG40 G1 X20\nM30\n").names(comp));
  EXPECT_FALSE(run(head + "T1 D1\nROT X30\nG1 X10 F500\nM30\n").names(comp));
  const Result corner = run(head + "ROT X30\nG1 X10 RND=1 F500\nG2 X20 I5 RND=1\nG1 Y10\nM30\n");
  EXPECT_TRUE(corner.names("a chamfer or rounding that does not fit its corner"));
}

TEST(TiltedPlane, AFaultStaysOne) {
  const Result ran = run("G17 G90 G94 G0 X0 Y0 Z0\nROT X30\nG2 X10 Y10 I3 F500\nM30\n");
  EXPECT_EQ(ran.result.ended, interpreter::Ended::alarm);
  EXPECT_EQ(ran.result.diagnostics.back().diagnostic.id, text::DiagnosticId::arc_radius_mismatch);
}

}  // namespace
}  // namespace dripfeed::compile::test
