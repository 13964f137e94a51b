// Direct drawing input: lines by their angle, and where two of them meet. Oracle: the triangles, by tan.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

Played lathe(const std::string& blocks, const std::string& dialect = "fanuc") {
  return run_text("%\nO1\nG21 G99 G18 G00 X40. Z0.\nG01 F0.2\n" + blocks + "M30\n%\n",
                  control(dialect, ir::MachineKind::lathe));
}

bool is_reported(const Played& played) {
  return std::ranges::any_of(played.result.not_interpreted, [](const auto& n) { return n.name.contains("(,A)"); });
}

double tan_deg(double angle) { return std::tan(angle * std::numbers::pi / 180.0); }

TEST(DirectLine, OneCoordinateGivesTheOther) {
  const auto by_z = moves_of(lathe("Z-10. ,A160.\n").motions);
  ASSERT_EQ(by_z.size(), 2U);
  EXPECT_NEAR(by_z[1].end[0], 40.0 + 2.0 * -10.0 * tan_deg(160.0), 1e-9);
  EXPECT_NEAR(by_z[1].end[2], -10.0, 1e-9);
  const auto by_x = moves_of(lathe("X60. ,A120.\n").motions);
  EXPECT_NEAR(by_x[1].end[2], 10.0 / tan_deg(120.0), 1e-9);
  const auto by_increment = moves_of(lathe("W-10. ,A180.\n").motions);
  EXPECT_NEAR(by_increment[1].end[0], 40.0, 1e-9);
}

TEST(DirectLine, TwoLinesMeetWithACornerBetween) {
  const Played plain = lathe(",A180.\nX60. Z-30. ,A90.\n");
  const auto moves = moves_of(plain.motions);
  ASSERT_EQ(moves.size(), 3U);
  EXPECT_NEAR(moves[1].end[0], 40.0, 1e-9);
  EXPECT_NEAR(moves[1].end[2], -30.0, 1e-9);
  EXPECT_NEAR(moves[2].end[0], 60.0, 1e-9);
  EXPECT_FALSE(is_reported(plain));
  const auto rounded = moves_of(lathe(",A180. ,R2.\nX60. Z-30. ,A90.\n").motions);
  ASSERT_EQ(rounded.size(), 4U);
  EXPECT_NEAR(rounded[1].end[2], -28.0, 1e-9);
  EXPECT_NEAR(rounded[2].end[0], 44.0, 1e-9);
  const auto chamfered = moves_of(lathe(",A180. ,C1.\nX60. Z-30. ,A90.\n").motions);
  ASSERT_EQ(chamfered.size(), 4U);
  EXPECT_NEAR(chamfered[1].end[2], -29.0, 1e-9);
}

// Older lathes: the same letters without the comma.
TEST(DirectLine, WithoutTheCommaOnLathes) {
  const auto angle = moves_of(lathe("Z-10. A160.\n").motions);
  ASSERT_EQ(angle.size(), 2U);
  EXPECT_NEAR(angle[1].end[0], 40.0 + 2.0 * -10.0 * tan_deg(160.0), 1e-9);
  const auto rounding = moves_of(lathe("Z-20. R3.\nX60.\n").motions);
  ASSERT_EQ(rounding.size(), 4U);
  EXPECT_NEAR(rounding[1].end[2], -17.0, 1e-9);
  EXPECT_NEAR(rounding[2].end[0], 46.0, 1e-9);
  const auto chamfer = moves_of(lathe("Z-20. I2.\nX60.\n").motions);
  ASSERT_EQ(chamfer.size(), 4U);
  EXPECT_NEAR(chamfer[1].end[2], -18.0, 1e-9);
  EXPECT_NEAR(chamfer[2].end[0], 44.0, 1e-9);
}

TEST(DirectLine, OnAMillTheAngleCountsFromX) {
  const auto moves = moves_of(run_text("%\nO1\nG21 G17 G90 G94 G00 X0. Y0.\nG01 X10. ,A30. F100.\nM30\n%\n",
                                       control("mitsubishi-m80", ir::MachineKind::mill))
                                  .motions);
  ASSERT_EQ(moves.size(), 2U);
  EXPECT_NEAR(moves[1].end[1], 10.0 * tan_deg(30.0), 1e-9);
}

// What does not follow leaves the places unknown, and is reported by name, where the control has no alarm for it.
TEST(DirectLine, WhatDoesNotFollowIsNotCertain) {
  const Played unfinished = lathe(",A150.\nX60.\nZ-50. X70.\n", "mazak");
  EXPECT_TRUE(is_reported(unfinished));
  const Played parallel = lathe(",A180.\nX60. Z-30. ,A180.\n", "mazak");
  EXPECT_TRUE(is_reported(parallel));
  const Played wrong = lathe("X60. Z-30. ,A100.\nX70.\n", "mazak");
  EXPECT_TRUE(is_reported(wrong));
  const auto after = moves_of(wrong.motions);
  EXPECT_NE(after.back().axes_unknown & 4U, 0U) << "Z is not known after it";
  const Played right = lathe("X60. Z-10. ,A135.\n");
  EXPECT_FALSE(is_reported(right));
}

// ANG= is the same on SINUMERIK.
TEST(DirectLine, GoesToANGAndBack) {
  ConvertRequest request;
  request.source =
      text::Source("program", "%\nO1\nG21 G18 G99 G00 X40. Z0.\nG01 ,A180. ,R2. F0.2\nX60. Z-30. ,A90.\nM30\n%\n");
  request.from = control("fanuc", ir::MachineKind::lathe);
  request.to = control("sinumerik-840d", ir::MachineKind::lathe);
  const ConvertResult there = convert(request);
  ASSERT_FALSE(text::has_error(there.diagnostics)) << messages_of(there.diagnostics, request.source);
  EXPECT_TRUE(there.text.contains("ANG=180")) << there.text;
  const auto before = moves_of(run_text(std::string(request.source.text()), request.from).motions);
  expect_same(before, moves_of(run_text(there.text, request.to).motions), 1e-9, there.text);
  ConvertRequest back;
  back.source = text::Source("back", there.text);
  back.from = request.to;
  back.to = request.from;
  const ConvertResult again = convert(back);
  ASSERT_FALSE(text::has_error(again.diagnostics)) << messages_of(again.diagnostics, back.source);
  expect_same(before, moves_of(run_text(again.text, back.to).motions), 1e-9, again.text);
}

TEST(DirectLine, StaysInATranslationBetweenControlsThatHaveIt) {
  ConvertRequest request;
  request.source = text::Source("program", "%\nO1\nG21 G17 G90 G94 G00 X0. Y0.\nG01 X10. ,A30. F100.\nM30\n%\n");
  request.from = control("mazak", ir::MachineKind::mill);
  request.to = control("mitsubishi-m80", ir::MachineKind::mill);
  const ConvertResult result = convert(request);
  EXPECT_TRUE(result.text.contains(",A30.")) << result.text;
  // From SINUMERIK not to mills, some of which do not have it.
  ConvertRequest from;
  from.source = text::Source("program", "G17 G710 G90 G94 G0 X0 Y0\nG1 X10 ANG=30 F100\nM30\n");
  from.from = control("sinumerik-840d", ir::MachineKind::mill);
  from.to = control("fanuc", ir::MachineKind::mill);
  EXPECT_TRUE(text::has_error(convert(from).diagnostics));
}

// Under G16 the plane's letters are a radius and an angle; corners are those of the same places in coordinates.
TEST(PolarCorners, AreThoseOfTheSamePlaces) {
  const std::string head = "%\nO1\nG21 G17 G90 G94 G40\nG00 X0. Y0. Z0.\n";
  for (const std::string dialect : {"fanuc", "mitsubishi-m80"}) {
    const ir::Control mill = control(dialect, ir::MachineKind::mill);
    const auto straight =
        moves_of(run_text(head + "G01 X10. Y0. ,R2. F100.\nX10. Y10. ,C1.\nX0. Y10.\nM30\n%\n", mill).motions);
    const auto polar =
        moves_of(run_text(head + "G16\nG01 X10. Y0. ,R2. F100.\nX[SQRT[200]] Y45. ,C1.\nX10. Y90.\nG15\nM30\n%\n", mill)
                     .motions);
    ASSERT_EQ(straight.size(), 6U) << dialect;
    expect_same(straight, polar, 1e-9, dialect);
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
