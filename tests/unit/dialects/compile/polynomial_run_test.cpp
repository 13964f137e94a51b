// POLY as programs. Oracle: the polynomials themselves, worked out by hand for each program or written once more with
// the coefficient a1 that the manual's definition gives: a1 = (end - a0 - a2 PL^2 - … a5 PL^5) / PL.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/interpreter/motion/curve_chords.h"
#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

const std::string kHead = "G17 G90 G94 G1 X0 Y0 Z0 F500\n";

std::vector<ir::Motion> splines(const Result& ran) {
  std::vector<ir::Motion> out;
  for (const ir::Motion& m : ran.motions)
    if (m.kind == ir::MotionKind::spline) out.push_back(m);
  return out;
}

// Chords that hang together, between points that fulfil f(x, y) = 0; they are as near to the curve as is promised.
using Residual = std::function<double(double, double)>;
void expect_on(const std::vector<ir::Motion>& moves, const Residual& residual, double most_between) {
  ASSERT_GE(moves.size(), 4U);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    EXPECT_NEAR(residual(moves[i].end[0], moves[i].end[1]), 0.0, 1e-9) << i;
    const double x = (moves[i].start[0] + moves[i].end[0]) / 2.0;
    const double y = (moves[i].start[1] + moves[i].end[1]) / 2.0;
    EXPECT_LT(std::abs(residual(x, y)), most_between) << i;
    if (i == 0) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(moves[i].start[axis], moves[i - 1].end[axis]);
  }
}
bool goes_through(const std::vector<ir::Motion>& moves, double x, double y, double z = 0.0) {
  return std::ranges::any_of(
      moves, [&](const ir::Motion& m) { return std::hypot(m.end[0] - x, m.end[1] - y, m.end[2] - z) < 1e-9; });
}

// x = 2p and y = a1 p - 4 p^2 with y(5) = 0: a1 = 20, so y = 4 p (5 - p) = x (10 - x), its top 25 at x = 5.
TEST(PolynomialRun, AParabola) {
  for (const std::string block : {"POLY PO[X]=(10) PO[Y]=(0,-4) PL=5", "POLY X=PO(10) Y=PO(0,-4) PL=5",
                                  "POLY X10 po[y]=(0,-4) PL=5", "POLY X10 PO[Y]=(0,-2*2,0,0,0) PL=2.5*2"}) {
    const Result ran = run(kHead + block + "\nG1 X20\nM30\n");
    const auto moves = splines(ran);
    expect_on(moves, [](double x, double y) { return y - x * (10.0 - x); }, 0.06);
    EXPECT_TRUE(goes_through(moves, 5.0, 25.0)) << ran.trace;
    EXPECT_EQ(moves.front().start[0], 0.0);
    EXPECT_EQ(moves.back().end[0], 10.0);
    EXPECT_EQ(moves.back().end[1], 0.0);
    EXPECT_EQ(moves.back().axes_unknown & 7U, 0U);
    for (const ir::Motion& m : moves) EXPECT_EQ(m.feed, 500.0);
    EXPECT_TRUE(ran.result.not_interpreted.empty());
    EXPECT_TRUE(ran.trace.ends_with("3 linear X20.0000 Y0.0000 Z0.0000 F500.0000/min\n4 end\n")) << ran.trace;
  }
}

// No chord is farther from the curve than is promised: looked at in many places of each.
TEST(PolynomialRun, ChordsAreAsNearAsPromised) {
  const auto moves = splines(run(kHead + "POLY PO[X]=(10) PO[Y]=(0,-4) PL=5\nM30\n"));
  for (const ir::Motion& m : moves)
    for (int tenth = 1; tenth < 10; ++tenth) {
      const double share = tenth / 10.0;
      const double x = m.start[0] + share * (m.end[0] - m.start[0]);
      const interpreter::AxisValues at = {x, x * (10.0 - x), 0.0};
      EXPECT_LT(interpreter::aside_of_chord(m.start, m.end, at), 1.1 * interpreter::kCurveChord_mm);
    }
}

// PL is 1 where it is not said: y = 40 t (1 - t) with x = 10 t.
TEST(PolynomialRun, TheParameterGoesToOne) {
  const auto moves = splines(run(kHead + "POLY PO[X]=(10) PO[Y]=(0,-40)\nM30\n"));
  expect_on(moves, [](double x, double y) { return y - 0.4 * x * (10.0 - x); }, 0.06);
  EXPECT_TRUE(goes_through(moves, 5.0, 10.0));
}

// Out to 40 / 4 = 10 and back on a line.
TEST(PolynomialRun, ThereAndBack) {
  const auto moves = splines(run(kHead + "POLY PO[X]=(0,-40)\nM30\n"));
  EXPECT_TRUE(goes_through(moves, 10.0, 0.0));
  EXPECT_EQ(moves.back().end[0], 0.0);
}

// All powers, of three axes, a different number of each. The ends of chords are looked for by X, which is p * 6.
TEST(PolynomialRun, ToTheFifthPower) {
  const auto moves = splines(run(kHead + "POLY PO[X]=(12) PO[Y]=(7,1.5,-2,0.5,-0.25) PO[Z]=(-3,0.75,1) PL=2\nM30\n"));
  ASSERT_GT(moves.size(), 4U);
  const double y1 = (7 - 1.5 * 4 + 2 * 8 - 0.5 * 16 + 0.25 * 32) / 2;
  const double z1 = (-3 - 0.75 * 4 - 1 * 8) / 2;
  for (const ir::Motion& m : moves) {
    const double p = m.end[0] / 6.0;
    EXPECT_NEAR(m.end[1], p * (y1 + p * (1.5 + p * (-2 + p * (0.5 - p * 0.25)))), 1e-9);
    EXPECT_NEAR(m.end[2], p * (z1 + p * (0.75 + p)), 1e-9);
  }
  EXPECT_EQ(moves.back().end[1], 7.0);
  EXPECT_EQ(moves.back().end[2], -3.0);
}

// Modal until another code of its group; axes by their name alone go straight in the parameter, a block of such is G1.
TEST(PolynomialRun, BlockAfterBlock) {
  const Result ran = run(kHead +
                         "POLY PO[X]=(10) PO[Y]=(0,-4) PL=5\n"  // 2
                         "PO[X]=(20) PO[Y]=(0,4) PL=5\n"        // 3: the same below
                         "M8\n"
                         "X30 PO[Y]=(5,-20)\n"  // 5: y = 25 t - 20 t^2 with x = 20 + 10 t
                         "X40 Y9 F300\n"        // 6
                         "PO[X]=(50) PO[Y]=(1)\n"
                         "Z4\n"
                         "G0 X60\n"
                         "M30\n");
  const auto of = [&](std::uint32_t line) {
    std::vector<ir::Motion> out = splines(ran);
    std::erase_if(out, [&](const ir::Motion& m) { return m.place.line != line; });
    return out;
  };
  expect_on(of(2), [](double x, double y) { return y - x * (10.0 - x); }, 0.06);
  expect_on(of(3), [](double x, double y) { return y + (x - 10.0) * (20.0 - x); }, 0.06);
  EXPECT_TRUE(goes_through(of(3), 15.0, -25.0));
  expect_on(of(5), [](double x, double y) { return y - (x - 20.0) * (2.5 - 0.2 * (x - 20.0)); }, 0.06);
  EXPECT_TRUE(goes_through(of(5), 25.0, 7.5));
  EXPECT_TRUE(
      ran.trace.ends_with("6 linear X40.0000 Y9.0000 Z0.0000 F300.0000/min\n"
                          "7 linear X50.0000 Y1.0000 Z0.0000 F300.0000/min\n"
                          "8 linear X50.0000 Y1.0000 Z4.0000 F300.0000/min\n"
                          "9 rapid X60.0000 Y1.0000 Z4.0000\n10 end\n"))
      << ran.trace;
  EXPECT_TRUE(ran.result.not_interpreted.empty());
}

// The end is a position as any other.
TEST(PolynomialRun, EndsByIncrements) {
  const std::string head = "G17 G90 G94 G1 X100 Y50 Z0 F500\n";
  const auto residual = [](double x, double y) { return (y - 50.0) - (x - 100.0) * (110.0 - x); };
  for (const std::string block :
       {"G91 POLY PO[X]=(10) PO[Y]=(0,-4) PL=5", "POLY PO[X]=(110) PO[Y]=(IC(0),-4) PL=5",
        "G91 POLY X=AC(110) Y=PO(AC(50),-4) PL=5", "POLY PO[X]=(IC(10),0) PO[Y]=(50,-4) PL=5"}) {
    const auto moves = splines(run(head + block + "\nM30\n"));
    expect_on(moves, residual, 0.06);
    EXPECT_TRUE(goes_through(moves, 105.0, 75.0)) << block;
  }
}

// In inches: y = 1 t (1 - t), so 0.25 inch high and 1 inch long.
TEST(PolynomialRun, Inches) {
  for (const std::string unit : {"G70", "G700"}) {
    const auto moves = splines(run(unit + " G17 G90 G94 G1 X0 Y0 Z0 F20\nPOLY PO[X]=(1) PO[Y]=(0,-1)\nM30\n"));
    EXPECT_TRUE(goes_through(moves, 12.7, 6.35)) << unit;
    EXPECT_NEAR(moves.back().end[0], 25.4, 1e-9);
  }
}

// Frames turn, mirror and stretch what the coefficients say, and do not shift it.
TEST(PolynomialRun, Frames) {
  const auto curve = [](const std::string& frame) {
    return splines(run(kHead + frame + "\nX0 Y0 Z0\nPOLY PO[X]=(10) PO[Y]=(0,-4) PL=5\nM30\n"));
  };
  EXPECT_TRUE(goes_through(curve("TRANS X100 Y1"), 105.0, 26.0));
  EXPECT_TRUE(goes_through(curve("ROT RPL=90"), -25.0, 5.0));
  EXPECT_TRUE(goes_through(curve("MIRROR Y0"), 5.0, -25.0));
  EXPECT_TRUE(goes_through(curve("SCALE X2 Y3"), 10.0, 75.0));
  const auto tilted = curve("TRANS Z1\nAROT X30");
  EXPECT_TRUE(goes_through(tilted, 5.0, 25.0 * std::sqrt(0.75), 1.0 + 12.5));
}

// G18, X 20 to 40 and back outwards in radius: r = 10 + 10 t + b (t^2 - t) with b = -8 is 2 more in the middle.
TEST(PolynomialRun, ALathesRadiusAndDiameter) {
  const auto lathe = [](const std::string& text) { return run(text, {}, ir::MachineKind::lathe); };
  const auto moves =
      splines(lathe("G18 G90 DIAMOF G95 G1 X10 Z0 F0.2\nPOLY PO[X]=(20,-8) PO[Z]=(-10)\nG1 Z-20\nM30\n"));
  const bool found = std::ranges::any_of(
      moves, [](const ir::Motion& m) { return std::hypot(m.end[0] - 2 * 17.0, m.end[2] + 5.0) < 1e-9; });
  EXPECT_TRUE(found);
  EXPECT_EQ(moves.back().end[0], 40.0);
  // A diameter's coefficients may be either.
  for (const std::string mode : {"DIAMON", "DIAM90"}) {
    const Result ran = lathe("G18 G90 " + mode + " G95 G1 X20 Z0 F0.2\nPOLY PO[X]=(40,-8) PO[Z]=(-10)\nM30\n");
    EXPECT_TRUE(ran.names("POLY: what the coefficients of a diameter count"));
    EXPECT_EQ(splines(ran).size(), 1U);
    EXPECT_EQ(splines(ran).back().end[0], 40.0);
  }
  // Straight in X there is nothing to be one: z = -10 t + 8 (t^2 - t), in the middle -7.
  const Result straight = lathe("G18 G90 DIAMON G95 G1 X20 Z0 F0.2\nPOLY X40 PO[Z]=(-10,8)\nM30\n");
  EXPECT_TRUE(straight.result.not_interpreted.empty());
  const auto bent = splines(straight);
  EXPECT_TRUE(std::ranges::any_of(
      bent, [](const ir::Motion& m) { return std::hypot(m.end[0] - 30.0, m.end[2] + 7.0) < 1e-9; }));
}

// Of a block at F 1/min its chords share the time.
TEST(PolynomialRun, InverseTime) {
  const auto moves = splines(run(kHead + "G93 POLY PO[X]=(10) PO[Y]=(0,-4) PL=5 F2\nM30\n"));
  ASSERT_GT(moves.size(), 4U);
  double minutes = 0.0;
  for (const ir::Motion& m : moves) minutes += 1.0 / m.feed;
  EXPECT_NEAR(minutes, 0.5, 1e-12);
}

// At its end, x = 10, the slope of x (10 - x) is -10: an arc by CT leaves along (1, -10).
TEST(PolynomialRun, ATangentialArcAfterIt) {
  const Result ran = run(kHead + "POLY PO[X]=(10) PO[Y]=(0,-4) PL=5\nCT X20 Y0\nM30\n");
  const auto arc = std::ranges::find_if(ran.motions, [](const ir::Motion& m) {
    return m.kind == ir::MotionKind::arc_cw || m.kind == ir::MotionKind::arc_ccw;
  });
  ASSERT_NE(arc, ran.motions.end()) << ran.trace;
  EXPECT_NEAR(arc->center[0] * 1.0 + arc->center[1] * -10.0, 0.0, 1e-9);
  EXPECT_EQ(arc->kind, ir::MotionKind::arc_ccw);
}

// The coordinates of TRANSMIT: in them it is the same curve.
TEST(PolynomialRun, OnAFace) {
  const Result ran = run(
      "G18 G90 DIAMOF G94 G0 X20 Z0 C0\nTRANSMIT\nG17 G1 X20 Y0 F500\nPOLY PO[X]=(10) PO[Y]=(0,-40)\nTRAFOOF\nM30\n",
      {}, ir::MachineKind::lathe);
  std::size_t pieces = 0;
  for (const ir::Motion& m : ran.motions) {
    if (m.place.line != 4 || !ir::is_move(m.kind)) continue;
    ++pieces;
    const double radius = m.end[0] / 2.0;
    const double angle = m.end[5] * std::acos(-1.0) / 180.0;
    const double t = (20.0 - radius * std::cos(angle)) / 10.0;
    EXPECT_NEAR(radius * std::sin(angle), 40.0 * t * (1.0 - t), 3e-3) << ran.trace;
  }
  EXPECT_GT(pieces, 10U) << ran.trace;
}

// From a place that no one knows there is no curve; and a value that no one knows makes none.
TEST(PolynomialRun, UnknownPlacesAreReported) {
  for (const std::string text : {"G17 G90 G1 F500\nPOLY PO[X]=(10) PO[Y]=(0,-4) PL=5\nM30\n",
                                 "G17 G90 G1 X0 Y0 F500\nPOLY PO[X]=(10) PO[Y]=(0,-4) Z5\nM30\n",
                                 "G17 G90 G1 X0 Y0 F500\nPOLY PO[X]=(10) PO[Y]=(0,-4) SUPA\nM30\n"}) {
    const Result ran = run(text);
    EXPECT_TRUE(ran.names("the curve of a polynomial (POLY)")) << text;
    EXPECT_EQ(splines(ran).size(), 1U) << text;
  }
  EXPECT_TRUE(run("G17 G90 G1 X0 Y0 F500\nPOLY PO[X]=(10) PO[Y]=(0,-4) Z5\nX20 PO[Y]=(0,-4)\nM30\n")
                  .trace.contains("spline X20.0000 Y0.0000"));
}

TEST(PolynomialRun, WithoutPolyTheyAreReported) {
  for (const std::string block : {"PO[X]=(10) PO[Y]=(0,-4) PL=5", "PO[X]=(10)", "X=PO(10)", "G0 PO[X]=(10,1)"}) {
    const Result ran = run(kHead + block + "\nG1 Y1\nM30\n");
    EXPECT_TRUE(ran.names("PO: coefficients where POLY is not in effect")) << block;
    EXPECT_FALSE(ran.trace.contains("\n2 ")) << ran.trace;
    EXPECT_NE(ran.motions.back().axes_unknown & 1U, 0U) << block;
  }
}

// Denominators, axes that have no polynomials here, more than five values, none: reported by name, and all may have
// moved.
TEST(PolynomialRun, WhatIsNotReadIsReported) {
  for (const std::string block : {"POLY PO[X]=(0,-10) PO[Y]=(10) PO[]=(2,1)", "POLY PO[C]=(90,2)", "POLY C=PO(90,2)",
                                  "POLY PO[X]=(1,2,3,4,5,6)", "POLY PO[X]=()", "POLY X=PO()", "POLY PO[X]=(1,,2)",
                                  "POLY PO[AX1]=(1,2)", "POLY PO[X]=(,2)", "POLY PO[X]=(CAC(1),2)"}) {
    const Result ran = run(kHead + block + "\nG1 Y1\nM30\n");
    EXPECT_TRUE(ran.names("PO")) << block;
    EXPECT_NE(ran.motions.back().axes_unknown & 1U, 0U) << block;
    EXPECT_TRUE(splines(ran).empty()) << block;
  }
  EXPECT_TRUE(run(kHead + "POLYPATH(\"AXES\")\nM30\n").names("POLYPATH"));
}

TEST(PolynomialRun, CornersAreNotMade) {
  EXPECT_TRUE(run(kHead + "POLY PO[X]=(10) PO[Y]=(0,-4) RND=2\nX20\nM30\n")
                  .names("a chamfer or rounding that does not fit its corner"));
  EXPECT_TRUE(run(kHead + "X5 RND=2\nPOLY PO[X]=(10) PO[Y]=(0,-4)\nM30\n")
                  .names("a chamfer or rounding that does not fit its corner"));
  // Of straight moves they are.
  EXPECT_TRUE(run(kHead + "POLY X5 RND=2\nY10\nM30\n").trace.contains("arc-ccw X5.0000 Y2.0000"));
}

TEST(PolynomialRun, APathOfTheParameterThatThereIsNot) {
  const auto with_length = [](const std::string& length) {
    return run(kHead + "POLY PO[X]=(10) PO[Y]=(0,-4) PL=" + length + "\nM30\n");
  };
  for (const std::string length : {"0", "-1", "0.00001", "100000"}) {
    const Result ran = with_length(length);
    ASSERT_FALSE(ran.result.diagnostics.empty()) << length;
    EXPECT_EQ(ran.result.diagnostics.back().diagnostic.id, text::DiagnosticId::curve_invalid);
    EXPECT_EQ(ran.result.diagnostics.back().line, 2U);
  }
  EXPECT_TRUE(with_length("0.0001").result.diagnostics.empty());
}

// In plain blocks of another control a polynomial is its chords; word by word it is refused where it stands.
TEST(PolynomialRun, OtherControlsGetTheChords) {
  const std::string text =
      "G17 G71 G90 G94 G40\nG1 X0 Y0 Z0 F500\nPOLY PO[X]=(10) PO[Y]=(0,-4) PL=5\nX20 PO[Y]=(5,3)\nX25\nG1 X40\nM30\n";
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    ConvertRequest request;
    request.source = text::Source("program", text);
    request.from = control("sinumerik-840d", ir::MachineKind::mill);
    request.to = control(to, ir::MachineKind::mill);
    request.mode = ConvertMode::explicit_blocks;
    const ConvertResult made = convert(request);
    EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, request.source);
    const auto there = moves_of(run_text(made.text, request.to).motions);
    const auto here = moves_of(run(text).motions);
    ASSERT_EQ(there.size(), here.size()) << made.text;
    for (std::size_t i = 0; i < here.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(there[i].end[axis], here[i].end[axis], 6e-4);
    request.mode = ConvertMode::macro;
    const ConvertResult refused = convert(request);
    for (const std::string line : {"3", "4"}) {
      const bool placed = std::ranges::any_of(refused.diagnostics, [&](const text::Diagnostic& d) {
        return d.severity == text::Severity::error &&
               std::to_string(request.source.position(d.span.begin).line) == line;
      });
      EXPECT_TRUE(placed) << to << " " << line << messages_of(refused.diagnostics, request.source);
    }
    // A curve that is not computed is no chord.
    request.source = text::Source("program", "G17 G71 G90 G94 G40\nG1 X0 F500\nPOLY PO[X]=(10) PO[Y]=(0,-4)\nM30\n");
    request.mode = ConvertMode::explicit_blocks;
    EXPECT_TRUE(text::has_error(convert(request).diagnostics)) << to;
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
