// ASPLINE, CSPLINE, BSPLINE as programs. Oracles: what defines the curves (pieces of third degree, through the points,
// no jump of slope or curvature, the ends as they are asked for), Akima's formula written once more for one axis, and a
// circle, which a rational curve of second degree is exactly.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/interpreter/motion/spline_curve.h"
#include "dialects/ir/spline_use.h"
#include "dialects/text/number.h"
#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

using interpreter::AxisValues;
using interpreter::SplineCurve;
using interpreter::SplineEnd;
using interpreter::SplinePoint;
using interpreter::Vector;

struct Place {
  double x, y, z = 0.0;
};
const std::vector<Place> kPlaces = {{0, 0}, {10, 20}, {22, 25, 3}, {30, 18, 5}, {45, 20, 1}, {50, 0, -2}, {70, -5}};

std::vector<SplinePoint> points_of(const std::vector<Place>& places) {
  std::vector<SplinePoint> out;
  for (const Place& p : places) out.push_back({.at = {p.x, p.y, p.z}});
  return out;
}
std::vector<double> chords_of(const std::vector<Place>& places) {
  std::vector<double> out;
  for (std::size_t i = 1; i < places.size(); ++i)
    out.push_back(
        std::hypot(places[i].x - places[i - 1].x, places[i].y - places[i - 1].y, places[i].z - places[i - 1].z));
  return out;
}

// First to third derivative by the length, of a polynomial of third degree: exact from five values.
std::array<double, 4> derivatives(const SplineCurve& curve, std::size_t piece, double share, double length,
                                  std::size_t axis) {
  const auto f = [&](double t) { return curve.at(piece, t)[axis]; };
  const std::array<double, 4> v = {f(0.0), f(1.0 / 3.0), f(2.0 / 3.0), f(1.0)};
  const double a3 = 4.5 * (v[3] - 3.0 * v[2] + 3.0 * v[1] - v[0]);
  const double a2 = 4.5 * (v[2] - 2.0 * v[1] + v[0]) - a3;
  const double a1 = v[3] - v[0] - a2 - a3;
  // It is one: a fifth value lies on it.
  EXPECT_NEAR(f(0.5), v[0] + 0.5 * a1 + 0.25 * a2 + 0.125 * a3, 1e-9);
  return {v[0] + share * (a1 + share * (a2 + share * a3)), (a1 + share * (2.0 * a2 + 3.0 * share * a3)) / length,
          (2.0 * a2 + 6.0 * share * a3) / (length * length), 6.0 * a3 / (length * length * length)};
}

class Ends : public testing::TestWithParam<std::pair<std::int16_t, std::int16_t>> {};

// These conditions have one solution: it is the spline.
TEST_P(Ends, CubicSplineIsWhatDefinesIt) {
  const auto points = points_of(kPlaces);
  const auto chords = chords_of(kPlaces);
  const Vector tangent = {3.0, 4.0, 12.0};
  const auto [begin, end] = GetParam();
  const SplineCurve curve(ir::kSplineCubic, 3, points, {begin, tangent}, {end, tangent}, false);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < chords.size(); ++i) {
      EXPECT_NEAR(derivatives(curve, i, 0.0, chords[i], axis)[0], points[i].at[axis], 1e-9);
      EXPECT_NEAR(derivatives(curve, i, 1.0, chords[i], axis)[0], points[i + 1].at[axis], 1e-9);
      if (i == 0) continue;
      const auto before = derivatives(curve, i - 1, 1.0, chords[i - 1], axis);
      const auto after = derivatives(curve, i, 0.0, chords[i], axis);
      EXPECT_NEAR(before[1], after[1], 1e-9);
      EXPECT_NEAR(before[2], after[2], 1e-9);
      const bool free_begin = i == 1 && begin == ir::kSplineFree;
      const bool free_end = i + 1 == chords.size() && end == ir::kSplineFree;
      if (free_begin || free_end) {
        EXPECT_NEAR(before[3], after[3], 1e-9);
      }
    }
    const auto first = derivatives(curve, 0, 0.0, chords.front(), axis);
    const auto last = derivatives(curve, chords.size() - 1, 1.0, chords.back(), axis);
    if (begin == ir::kSplineNatural) {
      EXPECT_NEAR(first[2], 0.0, 1e-9);
    }
    if (end == ir::kSplineNatural) {
      EXPECT_NEAR(last[2], 0.0, 1e-9);
    }
    if (begin == ir::kSplineTangent) {
      EXPECT_NEAR(first[1], tangent[axis] / 13.0, 1e-9);
    }
    if (end == ir::kSplineTangent) {
      EXPECT_NEAR(last[1], tangent[axis] / 13.0, 1e-9);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(All, Ends,
                         testing::Values(std::pair{ir::kSplineTangent, ir::kSplineTangent},
                                         std::pair{ir::kSplineNatural, ir::kSplineFree},
                                         std::pair{ir::kSplineFree, ir::kSplineNatural},
                                         std::pair{ir::kSplineFree, ir::kSplineFree}));

// Places at equal chords on a straight line in space are a cubic over the chord in each axis; with the line's tangents
// nothing else comes out. A parabola's three points without any condition give the parabola.
TEST(SplineCurve, ShortOnes) {
  const std::vector<Place> line = {{0, 0}, {3, 4, 12}, {4.5, 6, 18}};
  const SplineCurve straight(ir::kSplineCubic, 3, points_of(line), {ir::kSplineNatural, {}}, {ir::kSplineNatural, {}},
                             false);
  EXPECT_NEAR(straight.at(0, 0.5)[0], 1.5, 1e-12);
  EXPECT_NEAR(straight.at(1, 0.5)[2], 15.0, 1e-12);
  const std::vector<Place> bend = {{0, 0}, {4, 3}, {8, 0}};  // chords of 5: y is 1.2 s - 0.12 s^2
  const SplineCurve parabola(ir::kSplineCubic, 3, points_of(bend), {ir::kSplineFree, {}}, {ir::kSplineFree, {}}, false);
  EXPECT_NEAR(parabola.at(0, 0.5)[1], 1.2 * 2.5 - 0.12 * 6.25, 1e-12);
  EXPECT_NEAR(parabola.at(1, 0.5)[0], 6.0, 1e-12);
  const std::vector<Place> two = {{0, 0}, {10, 0}};
  const SplineCurve chord(ir::kSplineCubic, 3, points_of(two), {ir::kSplineFree, {}}, {ir::kSplineFree, {}}, false);
  EXPECT_NEAR(chord.at(0, 0.25)[0], 2.5, 1e-12);
}

// Akima's slope at the third of five chords, t = (|m4-m3| m2 + |m2-m1| m3) / (|m4-m3| + |m2-m1|).
double akima_slope(double m1, double m2, double m3, double m4) {
  const double w2 = std::abs(m4 - m3);
  const double w3 = std::abs(m2 - m1);
  return w2 + w3 == 0.0 ? 0.5 * (m2 + m3) : (w2 * m2 + w3 * m3) / (w2 + w3);
}

TEST(SplineCurve, AkimaByItsFormula) {
  const auto points = points_of(kPlaces);
  const auto chords = chords_of(kPlaces);
  const SplineCurve curve(ir::kSplineAkima, 3, points, {ir::kSplineFree, {}}, {ir::kSplineFree, {}}, false);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> m;
    for (std::size_t i = 0; i < chords.size(); ++i)
      m.push_back((points[i + 1].at[axis] - points[i].at[axis]) / chords[i]);
    const auto at = [&](int i) {
      const int last = static_cast<int>(m.size()) - 1;
      if (i < 0) return m[0] + static_cast<double>(-i) * (m[0] - m[1]);
      if (i > last)
        return m[static_cast<std::size_t>(last)] +
               static_cast<double>(i - last) *
                   (m[static_cast<std::size_t>(last)] - m[static_cast<std::size_t>(last - 1)]);
      return m[static_cast<std::size_t>(i)];
    };
    for (int i = 0; i < static_cast<int>(chords.size()); ++i) {
      const auto piece = static_cast<std::size_t>(i);
      const double slope = akima_slope(at(i - 2), at(i - 1), at(i), at(i + 1));
      const double next = akima_slope(at(i - 1), at(i), at(i + 1), at(i + 2));
      EXPECT_NEAR(derivatives(curve, piece, 0.0, chords[piece], axis)[1], slope, 1e-9) << axis << " " << i;
      EXPECT_NEAR(derivatives(curve, piece, 1.0, chords[piece], axis)[1], next, 1e-9) << axis << " " << i;
    }
  }
}

// --- programs

std::vector<ir::Motion> splines(const Result& ran) {
  std::vector<ir::Motion> out;
  for (const ir::Motion& m : ran.motions)
    if (m.kind == ir::MotionKind::spline) out.push_back(m);
  return out;
}
void expect_chain(const std::vector<ir::Motion>& moves) {
  for (std::size_t i = 1; i < moves.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(moves[i].start[axis], moves[i - 1].end[axis], 1e-9);
}
double angle_deg(const ir::Motion& m) {
  return std::atan2(m.end[1] - m.start[1], m.end[0] - m.start[0]) * 180.0 / std::numbers::pi;
}

TEST(SplineRun, GoesThroughItsPointsBlockByBlock) {
  for (const std::string code : {"ASPLINE", "CSPLINE"}) {
    const Result ran = run("G17 G90 G0 X-5 Y0 Z0\nG1 X0 F500\n" + code +
                           " X10 Y5\nM8\nX20 Y-3 Z2 F800\n; a comment\nX=IC(10) Y0\nG1 X40\nM30\n");
    const auto moves = splines(ran);
    ASSERT_GT(moves.size(), 12U) << ran.trace;
    expect_chain(moves);
    for (const auto& [line, x, y, z] : {std::tuple{3U, 10.0, 5.0, 0.0}, {5U, 20.0, -3.0, 2.0}, {7U, 30.0, 0.0, 2.0}}) {
      const auto last =
          std::ranges::find_if(moves.rbegin(), moves.rend(), [&](const ir::Motion& m) { return m.place.line == line; });
      ASSERT_NE(last, moves.rend());
      EXPECT_EQ(last->end[0], x);
      EXPECT_EQ(last->end[1], y);
      EXPECT_EQ(last->end[2], z);
      EXPECT_EQ(last->feed, line == 3 ? 500.0 : 800.0);
    }
    // BTAN and ETAN are in effect where nothing is stated: along X at both ends.
    EXPECT_NEAR(angle_deg(moves.front()), 0.0, 3.0) << code;
    EXPECT_NEAR(angle_deg(moves.back()), 0.0, 3.0) << code;
    // The coolant comes on where it stands.
    const auto coolant =
        std::ranges::find(ran.motions, ir::MotionKind::coolant, [](const ir::Motion& m) { return m.kind; });
    ASSERT_NE(coolant, ran.motions.end());
    EXPECT_EQ((coolant - 1)->place.line, 3U);
    EXPECT_EQ((coolant + 1)->place.line, 5U);
    EXPECT_TRUE(ran.names("how a spline bends, taken as usual and not looked at"));
  }
}

// On a circle: tangents of the arcs before and after it.
TEST(SplineRun, TangentsOfArcs) {
  const Result ran =
      run("G17 G90 G0 X10 Y0 Z0 F500\nG3 X0 Y10 I-10 J0\nCSPLINE X-20 Y14\nX-40 Y10\nG3 X-50 Y0 I0 J-10\n"
          "M30\n");
  const auto moves = splines(ran);
  ASSERT_GT(moves.size(), 4U) << ran.trace;
  EXPECT_NEAR(std::abs(angle_deg(moves.front())), 180.0, 3.0) << ran.trace;
  EXPECT_NEAR(std::abs(angle_deg(moves.back())), 180.0, 3.0) << ran.trace;
}

TEST(SplineRun, NaturalEndsHaveNoCurvature) {
  const Result ran = run("G17 G90 G1 X0 Y0 Z0 F500\nCSPLINE BNAT ENAT X10 Y10\nX20 Y0\nX30 Y10\nG0 Z5\nM30\n");
  const auto moves = splines(ran);
  const std::vector<Place> places = {{0, 0}, {10, 10}, {20, 0}, {30, 10}};
  const SplineCurve curve(ir::kSplineCubic, 3, points_of(places), {ir::kSplineNatural, {}}, {ir::kSplineNatural, {}},
                          false);
  ASSERT_GT(moves.size(), 12U);
  // The middle of the first piece is a place that chords are halved at.
  const AxisValues middle = curve.at(0, 0.5);
  EXPECT_TRUE(std::ranges::any_of(moves, [&](const ir::Motion& m) {
    return std::hypot(m.end[0] - middle[0], m.end[1] - middle[1]) < 1e-9;
  })) << ran.trace;
}

TEST(SplineRun, AWeightedBSplineIsACircle) {
  const Result ran =
      run("G17 G90 G1 X10 Y0 Z0 F500\nBSPLINE SD=2 X10 Y10 PW=0.70710678118655\nX0 Y10 PW=1 PL=3\n"
          "G1 X-10\nM30\n");
  const auto moves = splines(ran);
  ASSERT_GT(moves.size(), 10U) << ran.trace;
  expect_chain(moves);
  for (const ir::Motion& m : moves) {
    EXPECT_NEAR(std::hypot(m.end[0], m.end[1]), 10.0, 1e-9);
    EXPECT_LT(10.0 - std::hypot((m.start[0] + m.end[0]) / 2.0, (m.start[1] + m.end[1]) / 2.0), 1.001e-3);
    EXPECT_EQ(m.place.line, 3U);
  }
  EXPECT_EQ(moves.front().start[0], 10.0);
  EXPECT_NEAR(moves.back().end[1], 10.0, 1e-12);
}

// Two cubic pieces: at the knot between them (P1 + 2 P2 + P3) / 4, by Boehm's insertion; with knot distances of 1 and 3
// P1 and P2, P2 and P3 are first parted 1 : 3, then the result.
TEST(SplineRun, BSplinesByTheirKnots) {
  const std::string head = "G17 G90 G1 X0 Y0 Z0 F500\nBSPLINE X0 Y10\nX10 Y20\n";
  const auto knot = [&](const Result& ran, double x, double y) {
    for (const ir::Motion& m : splines(ran))
      if (m.place.line == 4 && std::hypot(m.end[0] - x, m.end[1] - y) < 1e-9) return true;
    return false;
  };
  EXPECT_TRUE(knot(run(head + "X20 Y10\nX20 Y0\nG1 Y-9\nM30\n"), (0 + 20 + 20) / 4.0, (10 + 40 + 10) / 4.0));
  const double x = (0 * 0.75 + 10 * 0.25) * 0.75 + (10 * 0.75 + 20 * 0.25) * 0.25;
  const double y = (10 * 0.75 + 20 * 0.25) * 0.75 + (20 * 0.75 + 10 * 0.25) * 0.25;
  const Result apart = run(head + "X20 Y10 PL=1\nX20 Y0 PL=3\nG1 Y-9\nM30\n");
  EXPECT_TRUE(knot(apart, x, y)) << apart.trace;
}

// The X of a lathe is a diameter: chords and tangents are of the radius. The same points on a mill are the oracle.
TEST(SplineRun, ALathesDiameter) {
  const auto lathe =
      splines(run("G18 G90 DIAMON G0 X20 Z0\nG1 X20 Z-1 F0.2\nCSPLINE X40 Z-10\nX30 Z-20\nX50 Z-30\n"
                  "G1 Z-40\nM30\n",
                  {}, ir::MachineKind::lathe));
  const auto mill =
      splines(run("G18 G90 G0 X10 Z0\nG1 X10 Z-1 F0.2\nCSPLINE X20 Z-10\nX15 Z-20\nX25 Z-30\n"
                  "G1 Z-40\nM30\n"));
  ASSERT_GT(mill.size(), 12U);
  for (const ir::Motion& m : mill) {
    const bool found = std::ranges::any_of(
        lathe, [&](const ir::Motion& l) { return std::hypot(l.end[0] / 2.0 - m.end[0], l.end[2] - m.end[2]) < 1e-9; });
    EXPECT_TRUE(found) << m.end[0] << " " << m.end[2];
  }
}

// More points than are kept at once: the same curve as of all of them.
TEST(SplineRun, ALongOneIsMadeInParts) {
  for (const auto& [code, kind] : {std::pair<std::string, std::int16_t>{"CSPLINE", ir::kSplineCubic},
                                   {"ASPLINE", ir::kSplineAkima},
                                   {"BSPLINE", ir::kSplineB}}) {
    std::vector<Place> places = {{0, 0}};
    std::string program = "G17 G90 G1 X0 Y0 Z0 F500\n" + code + " BNAT ENAT\n";
    for (int i = 1; i < 2500; ++i) {
      const Place p = {0.7 * i + 0.2 * std::sin(3.0 * i), std::round(1e4 * 3.0 * std::sin(0.37 * i)) / 1e4, 0.0};
      places.push_back({std::round(p.x * 1e4) / 1e4, p.y, 0.0});
      program += "X" + text::format_shortest(places.back().x) + " Y" + text::format_shortest(places.back().y) + "\n";
    }
    const Result ran = run(program + "G0 Z9\nM30\n");
    const auto moves = splines(ran);
    expect_chain(moves);
    const SplineCurve curve(kind, 3, points_of(places), {ir::kSplineNatural, {}}, {ir::kSplineNatural, {}}, false);
    std::size_t at = 0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      if (!curve.has_piece(i)) continue;
      for (const double share : {0.25, 0.5, 0.75, 1.0}) {
        const AxisValues wanted = curve.at(i, share);
        const auto near = [&](const ir::Motion& m) {
          return std::hypot(m.end[0] - wanted[0], m.end[1] - wanted[1]) < 1e-9;
        };
        while (at < moves.size() && !near(moves[at])) ++at;
        ASSERT_LT(at, moves.size()) << code << " piece " << i << " at " << share;
      }
      EXPECT_EQ(moves[at].place.line, i + 3);
    }
  }
}

TEST(SplineRun, OneAfterAnotherAndToTheEndOfTheText) {
  const Result ran = run("G17 G90 G1 X0 Y0 Z0 F500\nCSPLINE X10 Y5\nX20 Y0\nASPLINE X30 Y-5\nX40 Y0\nM30\n");
  const auto moves = splines(ran);
  expect_chain(moves);
  EXPECT_EQ(moves.back().end[0], 40.0);
  EXPECT_EQ(ran.motions.back().kind, ir::MotionKind::end);
  // A move of another axis and a dwell in between stay in their places.
  const Result mixed = run("G17 G90 G1 X0 Y0 Z0 F500\nASPLINE X10 Y5\nG4 F2\nX20 Y0\nG1 X30\nM30\n");
  EXPECT_TRUE(mixed.trace.contains("3 dwell")) << mixed.trace;
  EXPECT_LT(mixed.trace.find("3 dwell"), mixed.trace.find("\n4 spline"));
}

TEST(SplineRun, WhatIsNoSplineIsAFault) {
  const std::string head = "G17 G90 G1 X0 Y0 Z0 F500\n";
  for (const std::string block : {"BSPLINE SD=4 X10", "BSPLINE X10 PW=-1", "BSPLINE X10 PW=3.5", "BSPLINE X10 PL=-1"}) {
    const Result ran = run(head + block + "\nX20 Y5\nM30\n");
    ASSERT_FALSE(ran.result.diagnostics.empty()) << block;
    EXPECT_EQ(ran.result.diagnostics.back().diagnostic.id, text::DiagnosticId::curve_invalid);
    EXPECT_EQ(ran.result.diagnostics.back().line, 2U);
  }
  // From a place that no one knows no curve can be written.
  const Result unknown = run("G17 G90 G1 F500\nCSPLINE X10 Y5\nX20 Y0\nG1 X30\nM30\n");
  EXPECT_TRUE(unknown.names("the curve of a spline"));
}

// In plain blocks of another control a spline is its chords; word by word it is refused.
TEST(SplineRun, OtherControlsGetTheChords) {
  const std::string text = "G17 G71 G90 G94 G40\nG1 X0 Y0 Z0 F500\nCSPLINE X10 Y5\nX20 Y-3\nX30 Y0\nG1 X40\nM30\n";
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
    EXPECT_TRUE(text::has_error(convert(request).diagnostics)) << to;
    // How splines are to end is nothing where there is none.
    request.source = text::Source("program", "G17 G71 G90 G94 G40 BNAT ENAT\nG1 X0 Y0 Z0 F500\nM30\n");
    EXPECT_FALSE(text::has_error(convert(request).diagnostics))
        << messages_of(convert(request).diagnostics, request.source);
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
