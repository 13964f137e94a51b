// Polar and cylindrical interpolation. Oracle: the plane that the program is written in: the axes' path between the
// ends of each piece, brought back to the face or the circumference, must lie on the line or circle, and the pieces'
// times must add up to its length over the feed.
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;
constexpr std::size_t kC = 5;

struct Place {
  double along = 0.0;
  double across = 0.0;
};
// On the face: X is a diameter.
Place on_face(double x, double c_deg) {
  return {x / 2.0 * std::cos(c_deg / kDegrees), x / 2.0 * std::sin(c_deg / kDegrees)};
}

std::vector<ir::Motion> lathe(const std::string& blocks, const std::string& dialect = "fanuc") {
  ir::Control machine = control(dialect, ir::MachineKind::lathe);
  machine.axes = "XZC";
  const bool siemens = dialect == "sinumerik-840d";
  const std::string head =
      siemens ? "G18 G90 G71 G94 DIAMON\nG0 X50 Z5 C0\n" : "%\nO1\nG21 G98 G97 G40\nG00 X50. Z5. C0.\n";
  return moves_of(run_text(head + blocks + (siemens ? "M30\n" : "M30\n%\n"), machine).motions);
}

// The greatest distance of the axes' path from where it should be, at places of each piece.
double farthest(const std::vector<ir::Motion>& moves, std::uint32_t line,
                const std::function<double(Place)>& distance) {
  double most = 0.0;
  for (const ir::Motion& m : moves) {
    if (m.place.line != line) continue;
    for (int i = 0; i <= 10; ++i) {
      const double t = i / 10.0;
      const auto at = [&](std::size_t axis) { return m.start[axis] + t * (m.end[axis] - m.start[axis]); };
      most = std::max(most, distance(on_face(at(kX), at(kC))));
    }
  }
  return most;
}

double minutes(const std::vector<ir::Motion>& moves, std::uint32_t line) {
  double sum = 0.0;
  for (const ir::Motion& m : moves) {
    if (m.place.line != line || m.kind == ir::MotionKind::rapid) continue;
    EXPECT_EQ(m.feed_mode, ir::FeedMode::inverse_time);
    sum += 1.0 / m.feed;
  }
  return sum;
}

TEST(PolarInterpolation, LinesOnTheFace) {
  const auto moves = lathe("G12.1\nG01 X20. C10. F100.\nG13.1\n");
  ASSERT_GT(moves.size(), 4U);
  const ir::Motion& last = moves.back();
  EXPECT_NEAR(last.end[kX], 2.0 * std::hypot(10.0, 10.0), 1e-9);
  EXPECT_NEAR(last.end[kC], 45.0, 1e-9);
  // From (25, 0) to (10, 10).
  const double length = std::hypot(15.0, 10.0);
  const auto aside = [&](Place p) { return std::abs((p.along - 25.0) * 10.0 + p.across * 15.0) / length; };
  EXPECT_LT(farthest(moves, 6, aside), 1.1e-3);
  EXPECT_NEAR(minutes(moves, 6), length / 100.0, 1e-4 * length / 100.0);
}

TEST(PolarInterpolation, ArcsOnTheFace) {
  const auto moves = lathe("G12.1\nG01 X20. C0. F100.\nG03 X-20. C0. I-10. J0.\nG13.1\n");
  EXPECT_LT(farthest(moves, 7, [](Place p) { return std::abs(std::hypot(p.along, p.across) - 10.0); }), 1.1e-3);
  EXPECT_NEAR(moves.back().end[kC], 180.0, 1e-9);
  EXPECT_NEAR(moves.back().end[kX], 20.0, 1e-9);
  const auto eccentric = lathe("G12.1\nG01 X20. C0. F100.\nG02 X20. C0. I4. J0.\nG13.1\n");
  EXPECT_LT(farthest(eccentric, 7, [](Place p) { return std::abs(std::hypot(p.along - 14.0, p.across) - 4.0); }),
            1.1e-3);
  EXPECT_NEAR(minutes(eccentric, 7), 8.0 * std::numbers::pi / 100.0, 1e-4);
}

TEST(PolarInterpolation, TheRotaryAxisGoesOnTurning) {
  const auto moves = lathe("G12.1\nG01 X20. C-10. F100.\nC10.\nX-20.\nC-10.\nX20.\nG13.1\nG01 C90.\n");
  const ir::Motion& after = moves.back();
  EXPECT_NEAR(after.start[kC], 315.0, 1e-9);  // -45 and once round
  EXPECT_NEAR(after.end[kC], 90.0, 1e-9);     // degrees again
  EXPECT_NEAR(after.end[kX], 2.0 * std::hypot(10.0, 10.0), 1e-9);
}

TEST(PolarInterpolation, ThroughTheCenterTheAxisTurnsAtAStand) {
  const auto moves = lathe("G12.1\nG01 X20. C0. F100.\nX-20.\nG13.1\n");
  EXPECT_NEAR(std::abs(moves.back().end[kC]), 180.0, 1e-9);
  EXPECT_NEAR(moves.back().end[kX], 20.0, 1e-9);
  const auto turn = std::ranges::find_if(moves, [](const ir::Motion& m) { return m.start[kC] != m.end[kC]; });
  ASSERT_NE(turn, moves.end());
  EXPECT_NEAR(turn->end[kX], 0.0, 1e-9);
}

TEST(CylindricalInterpolation, LinesAndArcsOnTheCircumference) {
  const auto moves = lathe("G07.1 C20.\nG01 Z-5. C90. F100.\nG02 Z-15. C118.6479 R10.\nG07.1 C0.\n");
  const double quarter = 20.0 * std::numbers::pi / 2.0;
  EXPECT_NEAR(minutes(moves, 6), std::hypot(10.0, quarter) / 100.0, 1e-9);
  // Clockwise from Z to the circumference: about (-5, quarter + 10).
  double most = 0.0;
  std::size_t pieces = 0;
  for (const ir::Motion& m : moves) {
    if (m.place.line != 7) continue;
    ++pieces;
    for (const double t : {0.0, 0.3, 0.5, 0.8}) {
      const double z = m.start[kZ] + t * (m.end[kZ] - m.start[kZ]);
      const double c = (m.start[kC] + t * (m.end[kC] - m.start[kC])) / kDegrees * 20.0;
      most = std::max(most, std::abs(std::hypot(z + 5.0, c - quarter - 10.0) - 10.0));
    }
  }
  EXPECT_GT(pieces, 4U);
  EXPECT_LT(most, 1.2e-3);
  EXPECT_NEAR(moves.back().end[kC], 118.6479, 1e-9);
}

TEST(Transmit, IsTheFaceInXAndY) {
  const auto moves = lathe("TRANSMIT\nG17 G1 X20 Y10 F100\nX-20\nTRAFOOF\n", "sinumerik-840d");
  const auto same = lathe("G12.1\nG01 X20. C10. F100.\nX-20.\nG13.1\n");
  ASSERT_EQ(moves.size(), same.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    EXPECT_NEAR(moves[i].end[kX], same[i].end[kX], 1e-9) << i;
    EXPECT_NEAR(moves[i].end[kC], same[i].end[kC], 1e-9) << i;
  }
}

TEST(Tracyl, IsTheCircumference) {
  const auto moves = lathe("TRACYL(40)\nG19 G1 Z-5 Y=10*3.14159265358979 F100\nTRAFOOF\nG1 C10\n", "sinumerik-840d");
  ASSERT_EQ(moves.size(), 3U);
  EXPECT_NEAR(moves[1].end[kC], 90.0, 1e-9);
  EXPECT_NEAR(moves[1].end[kZ], -5.0, 1e-9);
  EXPECT_NEAR(moves[2].end[kC], 10.0, 1e-9);
}

ConvertResult lathe_translated(const std::string& text, const std::string& from, const std::string& to) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = control(from, ir::MachineKind::lathe);
  request.to = control(to, ir::MachineKind::lathe);
  request.from.axes = request.to.axes = "XZC";
  return convert(request);
}

std::vector<ir::Motion> lathe_moves(const std::string& text, const std::string& dialect) {
  ir::Control machine = control(dialect, ir::MachineKind::lathe);
  machine.axes = "XZC";
  return real_moves(run_text(text, machine).motions);
}

void expect_equal_paths(const std::string& text, const std::string& from, const std::string& to) {
  const ConvertResult made = lathe_translated(text, from, to);
  ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
  const auto original = lathe_moves(text, from);
  const auto moves = lathe_moves(made.text, to);
  ASSERT_EQ(original.size(), moves.size()) << made.text;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    EXPECT_EQ(original[i].kind, moves[i].kind) << i << made.text;
    for (const std::size_t axis : {kX, kZ, kC}) EXPECT_NEAR(original[i].end[axis], moves[i].end[axis], 2e-3) << i;
    EXPECT_NEAR(original[i].feed, moves[i].feed, 1e-3 * original[i].feed) << i;
  }
}

const std::string kFaceAndCylinder =
    "%\nO1\nG21 G18 G98 G97 G40\nG00 X50. Z5. C0.\nG12.1\nG01 X20. C10. F100.\nX-20.\nG03 X20. C-10. R15.\n"
    "G01 H5.\nG02 X30. C5. R10.\nG13.1\nG00 X60.\nC30.\nG01 X40. Z-2. F100.\nG07.1 C20.\nG01 Z-5. C90.\n"
    "H-20.\nG07.1 C0.\nG00 X100. C0.\nM30\n%\n";

// The same path of the machine's own axes, whichever letter the coordinate across has.
TEST(PolarInterpolation, BetweenControls) {
  const ConvertResult made = lathe_translated(kFaceAndCylinder, "fanuc", "sinumerik-840d");
  for (const char* word : {"TRANSMIT", "TRACYL(40)", "TRAFOOF", "Y=IC(5.)", "Y31.4159"})
    EXPECT_NE(made.text.find(word), std::string::npos) << word << "\n" << made.text;
  for (const std::string to : {"sinumerik-840d", "mazak", "mitsubishi-m80"})
    expect_equal_paths(kFaceAndCylinder, "fanuc", to);
  const std::string siemens =
      "G18 G90 G94 G71 DIAMON G40\nG0 X50 Z5 C0\nTRANSMIT\nG17 G1 X20 Y10 F100\nX-20\nG3 X20 Y10 CR=30\nG1 Y=IC(4)\n"
      "TRAFOOF\nG18\nG0 X60 C40\nTRACYL(40)\nG19 G1 Z-5 Y31.4159 F100\nY=IC(-3)\nTRAFOOF\nG18\nG1 C10\nG0 X100\n"
      "M30\n";
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) expect_equal_paths(siemens, "sinumerik-840d", to);
}

// From G18, whose first axis is Z, to G19, whose first one is Y.
TEST(CylindricalInterpolation, ArcsGoInReverse) {
  const std::string text =
      "%\nO1\nG21 G18 G98 G97 G40\nG00 X50. Z5. C0.\nG01 X40. Z-5. F100.\nG07.1 C20.\nC90.\nG02 Z-15. C118.6479 R10.\n"
      "G07.1 C0.\nM30\n%\n";
  const ConvertResult made = lathe_translated(text, "fanuc", "sinumerik-840d");
  ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
  EXPECT_NE(made.text.find("G3 Z-15."), std::string::npos) << made.text;
  double most = 0.0;
  for (const ir::Motion& m : lathe_moves(made.text, "sinumerik-840d")) {
    if (m.end[kZ] >= -5.0 || m.end[kZ] < -15.0) continue;
    const double c = m.end[kC] / kDegrees * 20.0;
    most = std::max(most, std::abs(std::hypot(m.end[kZ] + 5.0, c - 20.0 * std::numbers::pi / 2.0 - 10.0) - 10.0));
  }
  EXPECT_GT(most, 0.0);
  EXPECT_LT(most, 2e-3);
}

TEST(PolarInterpolation, WhatWouldMeanSomethingElseIsRefused) {
  const std::string head = "%\nO1\nG21 G18 G98 G97 G40\nG00 X50. Z5.\n";
  for (const std::string blocks :
       {"G12.1\nG01 X20. F100.\nG13.1\n",                                       // C is anywhere
        "C30.\nG12.1\nG01 X20. F100.\nG13.1\n",                                 // C counts from 30 degrees
        "C0.\nG12.1\nM98 P9\nG13.1\n",                                          // what it calls has words of its own
        "C0.\nG07.1 C20.\nG01 C10. F100.\nG02 Z0. C20. I1. K1.\nG07.1 C0.\n"})  // by the centre
    EXPECT_TRUE(text::has_error(lathe_translated(head + blocks + "M30\n%\n", "fanuc", "sinumerik-840d").diagnostics))
        << blocks;
  const std::string ends = "%\nO1\nG21 G17 G90 G94 G40\nG13.1\nG00 X0. Y0. Z5.\nM30\n%\n";
  EXPECT_FALSE(text::has_error(translated(ends, "fanuc", "sinumerik-840d").diagnostics));
  EXPECT_FALSE(
      text::has_error(translated("G17 G71 G90 G94\nTRAFOOF\nG0 X0\nM30\n", "sinumerik-840d", "fanuc").diagnostics));
  EXPECT_TRUE(
      text::has_error(translated("G17 G71 G90 G94\nTRANSMIT\nG0 X0\nM30\n", "sinumerik-840d", "fanuc").diagnostics));
}

TEST(Transmit, FromAnUnknownPlaceIsReported) {
  ir::Control machine = control("sinumerik-840d", ir::MachineKind::lathe);
  machine.axes = "XZC";
  const Played played = run_text("G18 G90 G71 G94\nTRANSMIT\nG17 G1 X20 F100\nTRAFOOF\nM30\n", machine);
  EXPECT_TRUE(std::ranges::any_of(played.result.not_interpreted,
                                  [](const auto& n) { return n.name.contains("face or cylinder"); }));
}

// How far a place lies from a path of lines and arcs in the plane of X and Y.
double next_to_it(const std::vector<ir::Motion>& path, Place p) {
  double least = 1e9;
  for (const ir::Motion& m : path) {
    const double dx = m.end[0] - m.start[0];
    const double dy = m.end[1] - m.start[1];
    double t = ((p.along - m.start[0]) * dx + (p.across - m.start[1]) * dy) / std::max(1e-12, dx * dx + dy * dy);
    t = std::clamp(t, 0.0, 1.0);
    const double to_line = std::hypot(p.along - m.start[0] - t * dx, p.across - m.start[1] - t * dy);
    if (m.kind == ir::MotionKind::linear) {
      least = std::min(least, to_line);
    } else if (m.kind != ir::MotionKind::rapid) {
      // Less than half a circle: on the chord's side that is away from the centre.
      const double x = p.along - m.start[0] - m.center[0];
      const double y = p.across - m.start[1] - m.center[1];
      const double mx = 0.5 * dx - m.center[0];
      const double my = 0.5 * dy - m.center[1];
      const bool on_arc = x * mx + y * my >= mx * mx + my * my - 1e-6;
      if (on_arc) least = std::min(least, std::abs(std::hypot(x, y) - std::hypot(m.center[0], m.center[1])));
    }
  }
  return least;
}

// Chamfers and roundings on the face are those of the same contour on a mill; lengths over the feed are the time.
TEST(PolarInterpolation, Corners) {
  const std::string contour = "G1 X=10*F Y-10 F100 RND=3\nM8\nY10 CHR=2\nX=-10*F RND=2.5\nY0\n";
  const auto with = [&](const std::string& factor) {
    std::string out = contour;
    for (std::size_t at = out.find("*F"); at != std::string::npos; at = out.find("*F")) out.replace(at, 2, factor);
    return out;
  };
  const auto mill = moves_of(
      run_text("G17 G90 G71 G94\nG0 X25 Y0 Z5\n" + with("") + "M30\n", control("sinumerik-840d", ir::MachineKind::mill))
          .motions);
  const auto moves = lathe("TRANSMIT\nG17\n" + with("*2") + "TRAFOOF\n", "sinumerik-840d");
  ASSERT_EQ(mill.size(), 8U);
  double length = 0.0;
  for (std::size_t i = 1; i < mill.size(); ++i) {
    const ir::Motion& m = mill[i];
    const double chord = std::hypot(m.end[0] - m.start[0], m.end[1] - m.start[1]);
    const double radius = std::hypot(m.center[0], m.center[1]);
    length += m.kind == ir::MotionKind::linear ? chord : 2.0 * radius * std::asin(chord / 2.0 / radius);
  }
  double time = 0.0;
  for (std::uint32_t line = 5; line <= 9; ++line) {
    EXPECT_LT(farthest(moves, line, [&](Place p) { return next_to_it(mill, p); }), 1.1e-3) << line;
    time += minutes(moves, line);
  }
  EXPECT_NEAR(time, length / 100.0, 1e-4 * length / 100.0);
  // Each corner is there: somewhere the path is in the middle of it.
  for (std::size_t i : {2U, 4U, 6U}) {
    const ir::Motion& m = mill[i];
    Place middle{0.5 * (m.start[0] + m.end[0]), 0.5 * (m.start[1] + m.end[1])};
    if (m.kind != ir::MotionKind::linear) {
      const Place c{m.start[0] + m.center[0], m.start[1] + m.center[1]};
      const double stretch =
          std::hypot(m.center[0], m.center[1]) / std::hypot(middle.along - c.along, middle.across - c.across);
      middle = {c.along + stretch * (middle.along - c.along), c.across + stretch * (middle.across - c.across)};
    }
    double least = 1e9;
    for (const ir::Motion& one : moves)
      for (int k = 0; k <= 200; ++k) {
        const double t = k / 200.0;
        const Place p = on_face(one.start[kX] + t * (one.end[kX] - one.start[kX]),
                                one.start[kC] + t * (one.end[kC] - one.start[kC]));
        least = std::min(least, std::hypot(p.along - middle.along, p.across - middle.across));
      }
    EXPECT_LT(least, 0.05) << i;
  }
  for (std::size_t i = 2; i < moves.size(); ++i)
    if (moves[i].place.line >= 5 && moves[i].place.line <= 9) {
      EXPECT_NEAR(moves[i].start[kX], moves[i - 1].end[kX], 1e-9);
      EXPECT_NEAR(moves[i].start[kC], moves[i - 1].end[kC], 1e-9);
    }
}

// What waits for its next move when the mode begins is closed before it.
TEST(PolarInterpolation, WhatWaitsEndsBeforeTheMode) {
  const auto spline =
      lathe("G1 X50 Z4 F100\nCSPLINE X40 Z0\nX44 Z-5\nTRANSMIT\nG17 X20 Y10\nTRAFOOF\n", "sinumerik-840d");
  const auto of_line = [](const std::vector<ir::Motion>& moves, std::uint32_t line) {
    return std::ranges::count(moves, line, [](const ir::Motion& m) { return m.place.line; });
  };
  EXPECT_GT(of_line(spline, 4), 3);
  EXPECT_GT(of_line(spline, 5), 3);
  EXPECT_NEAR(spline.back().end[kX], 2.0 * std::hypot(10.0, 10.0), 1e-9);
  const auto corner = lathe("G1 X50 Z4 F100\nX40 RND=1\nTRANSMIT\nG17 X20 Y10\nTRAFOOF\n", "sinumerik-840d");
  EXPECT_EQ(of_line(corner, 4), 1);
  EXPECT_NEAR(corner.back().end[kX], 2.0 * std::hypot(10.0, 10.0), 1e-9);
}

}  // namespace
}  // namespace dripfeed::compile::test
