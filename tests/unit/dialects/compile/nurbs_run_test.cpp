// G06.2. Oracle: a circle, which a rational curve of order 3 is exactly, and the Bernstein polynomials of one cubic
// piece.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

constexpr auto kHead = "%\nO1\nG21 G17 G90 G94 G40\nG00 X10. Y0. Z0.\n";

std::vector<ir::Motion> curve(const std::string& blocks, const std::string& dialect) {
  auto moves = moves_of(run_text(kHead + blocks + "M30\n%\n", control(dialect, ir::MachineKind::mill)).motions);
  std::erase_if(moves, [](const ir::Motion& m) { return m.kind != ir::MotionKind::spline; });
  return moves;
}

TEST(NurbsRun, AQuarterOfACircle) {
  const std::string text = "G06.2 P3 K0. X10. Y0. F500.\nK0. X10. Y10. R0.70710678\nK0. X0. Y10.\nK1.\nK1.\nK1.\n";
  for (const std::string dialect : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const auto moves = curve(text, dialect);
    ASSERT_GT(moves.size(), 10U) << dialect;
    for (const ir::Motion& m : moves) {
      EXPECT_NEAR(std::hypot(m.end[0], m.end[1]), 10.0, 1e-6);
      const double middle = std::hypot((m.start[0] + m.end[0]) / 2.0, (m.start[1] + m.end[1]) / 2.0);
      EXPECT_LT(10.0 - middle, 1.001e-3);
      EXPECT_EQ(m.feed, 500.0);
    }
    EXPECT_NEAR(moves.back().end[0], 0.0, 1e-12);
    EXPECT_NEAR(moves.back().end[1], 10.0, 1e-12);
    EXPECT_EQ(moves.back().place.line, 7U);  // of the last point
  }
}

// Two cubic pieces with a knot between: what is not named stays, and the ends are the control points.
TEST(NurbsRun, TwoPiecesOfOrderFour) {
  const auto moves =
      curve("G06.2 P4 K0. X10. Y0. Z0. F500.\nK0. X12. Z2.\nK0. Y3.\nK0. X20. Y6.\nK1. X22. Z4.\nK2.\nK2.\nK2.\nK2.\n",
            "fanuc");
  ASSERT_GT(moves.size(), 8U);
  EXPECT_NEAR(moves.back().end[0], 22.0, 1e-9);
  EXPECT_NEAR(moves.back().end[1], 6.0, 1e-9);
  EXPECT_NEAR(moves.back().end[2], 4.0, 1e-9);
  // At the knot 1: P1/4 + P2 (3/8 + …) by Boehm's insertion: (P1 + 2 P2 + P3) / 4 of uniform ends.
  const auto at_knot = std::ranges::find(moves, 9U, [](const ir::Motion& m) { return m.place.line; });
  ASSERT_NE(at_knot, moves.end());
  EXPECT_NEAR(at_knot->start[0], (12.0 + 2.0 * 12.0 + 20.0) / 4.0, 1e-9);
  EXPECT_NEAR(at_knot->start[1], (0.0 + 2.0 * 3.0 + 6.0) / 4.0, 1e-9);
  for (std::size_t i = 1; i < moves.size(); ++i) EXPECT_EQ(moves[i].start, moves[i - 1].end);
}

// In plain blocks a curve is its chords.
TEST(NurbsRun, PlainBlocksHaveTheChords) {
  ConvertRequest request;
  request.source = text::Source(
      "program", std::string(kHead) +
                     "G06.2 P3 K0. X10. Y0. F500.\nK0. X10. Y10. R0.70710678\nK0. X0. Y10.\nK1.\nK1.\nK1.\nM30\n%\n");
  request.from = control("fanuc", ir::MachineKind::mill);
  request.to = control("sinumerik-840d", ir::MachineKind::mill);
  request.mode = ConvertMode::explicit_blocks;
  const ConvertResult made = convert(request);
  EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, request.source);
  const auto moves = moves_of(run_text(made.text, request.to).motions);
  ASSERT_GT(moves.size(), 10U);
  EXPECT_NEAR(moves.back().end[0], 0.0, 1e-4);
  EXPECT_NEAR(moves.back().end[1], 10.0, 1e-4);
}

// Word by word it has no counterpart on a control with other splines: refused, never dropped.
TEST(NurbsRun, HasNoCounterpartElsewhere) {
  const ConvertResult made = translated(
      std::string(kHead) + "G06.2 P3 K0. X10. Y0. F500.\nK0. X10. Y10.\nK0. X0. Y10.\nK1.\nK1.\nK1.\nM30\n%\n", "fanuc",
      "sinumerik-840d");
  EXPECT_TRUE(text::has_error(made.diagnostics));
}

}  // namespace
}  // namespace dripfeed::compile::test
