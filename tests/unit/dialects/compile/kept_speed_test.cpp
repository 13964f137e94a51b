// The spindle after a constant surface speed: it keeps what that came to, and never goes back to the S before it.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

// By name, what makes X a diameter of a lathe with S500 in effect, and what limits the spindle there.
struct Lathe {
  std::string dialect;
  std::string head;
  std::string limit;
};
const Lathe kLathes[] = {
    {"fanuc", "O1\nG21 G18 G40 G97 G99\nS500 M03\n", "G50 S3000\n"},
    {"haas", "O1\nG21 G18 G40 G97 G99\nS500 M03\n", "G50 S3000\n"},
    {"mazak", "O1\nG21 G18 G40 G97 G99\nS500 M03\n", "G50 S3000\n"},
    {"mitsubishi-m80", "O1\nG21 G18 G40 G97 G99\nS500 M03\n", "G50 S3000\n"},
    {"sinumerik-840d", "G71 G18 G90 G95 G40 DIAMON\nG97 S500 M3\n", "LIMS=3000\n"},
};

double rpm_at(double surface_m_min, double diameter_mm) {
  return 1000.0 * surface_m_min / (std::numbers::pi * diameter_mm);
}

ir::Motion last_move(const Lathe& lathe, const std::string& blocks) {
  const auto moves =
      moves_of(run_text(lathe.head + blocks + "M30\n", control(lathe.dialect, ir::MachineKind::lathe)).motions);
  EXPECT_FALSE(moves.empty()) << blocks;
  return moves.empty() ? ir::Motion{} : moves.back();
}

void expect_speed(const std::string& blocks, double rpm, bool limited = true) {
  for (const Lathe& lathe : kLathes) {
    const ir::Motion move = last_move(lathe, (limited ? lathe.limit : "") + blocks);
    EXPECT_EQ(move.surface_speed_m_min, 0.0) << lathe.dialect << '\n' << blocks;
    EXPECT_NEAR(move.spindle_rpm, rpm, 1e-9) << lathe.dialect << '\n' << blocks;
  }
}

TEST(KeptSpeed, IsWhatTheSurfaceSpeedCameTo) {
  expect_speed("G00 X100. Z5.\nG96 S200\nG01 X50. F0.2\nG97\nG01 Z-5.\n", rpm_at(200.0, 50.0));
  expect_speed("G00 X100. Z5.\nG96 S200\nG01 X-50. F0.2\nG97\nG01 X80.\n", rpm_at(200.0, 50.0));
}

TEST(KeptSpeed, IsNotHigherThanTheLimit) {
  expect_speed("G00 X100. Z5.\nG96 S200\nG01 X1. F0.2\nG97\nG01 Z-5.\n", 3000.0);
  expect_speed("G00 X100. Z5.\nG96 S200\nG01 X0 F0.2\nG97\nG01 Z-5.\n", 3000.0);
}

// The machine's own limit may be lower than what the surface speed asks for.
TEST(KeptSpeed, IsNotKnownWithoutALimitOrAPlace) {
  expect_speed("G00 X100. Z5.\nG96 S200\nG01 X50. F0.2\nG97\nG01 Z-5.\n", 0.0, false);
  expect_speed("G96 S200\nG97\nG01 Z-5. F0.2\n", 0.0);
}

TEST(KeptSpeed, GivesPlaceToAnotherS) {
  expect_speed("G00 X100. Z5.\nG96 S200\nG01 X50. F0.2\nG97 S700\nG01 Z-5.\n", 700.0);
  expect_speed("G00 X100. Z5.\nG97\nG01 Z-5. F0.2\n", 500.0);
}

// A feed code ends it on a SINUMERIK.
TEST(KeptSpeed, IsLeftByAFeedCode) {
  const Lathe& sinumerik = kLathes[std::size(kLathes) - 1];
  const ir::Motion move = last_move(sinumerik, "LIMS=3000\nG0 X100 Z5\nG96 S200\nG1 X50 F0.2\nG95\nG1 Z-5 F0.2\n");
  EXPECT_NEAR(move.spindle_rpm, rpm_at(200.0, 50.0), 1e-9);
  EXPECT_EQ(move.surface_speed_m_min, 0.0);
}

// The diameter is that of the workpiece's coordinates.
TEST(KeptSpeed, CountsFromAShiftedZero) {
  const Lathe& sinumerik = kLathes[std::size(kLathes) - 1];
  const ir::Motion move =
      last_move(sinumerik, "LIMS=3000\nTRANS X10\nG0 X100 Z5\nG96 S200\nG1 X50 F0.2\nG97\nG1 Z-5\n");
  EXPECT_NEAR(move.spindle_rpm, rpm_at(200.0, 50.0), 1e-9);
}

TEST(KeptSpeed, OfAMillIsNotKnown) {
  const std::string text =
      "O1\nG21 G17 G90 G94 G54\nS500 M03\nG92 S3000\nG00 X100. Y0 Z5.\nG96 S200\nG01 X50. F200.\nG97\nG01 X10.\nM30\n";
  const ir::Motion move = moves_of(run_text(text, control("fanuc", ir::MachineKind::mill)).motions).back();
  EXPECT_EQ(move.spindle_rpm, 0.0);
}

// Written as plain blocks it is left by the surface speed there, too.
TEST(KeptSpeed, IsWrittenWithoutAnS) {
  const Lathe& from = kLathes[0];
  for (const Lathe& to : kLathes) {
    ConvertRequest request;
    request.source = text::Source(
        "program", from.head + from.limit + "G00 X100. Z5.\nG96 S200\nG01 X50. F0.2\nG97\nG01 Z-5.\nM30\n");
    request.from = control(from.dialect, ir::MachineKind::lathe);
    request.to = control(to.dialect, ir::MachineKind::lathe);
    request.mode = ConvertMode::explicit_blocks;
    const ConvertResult result = convert(request);
    EXPECT_FALSE(text::has_error(result.diagnostics)) << to.dialect << messages_of(result.diagnostics, request.source);
    EXPECT_EQ(result.text.find("1273"), std::string::npos) << result.text;
    const ir::Motion move = moves_of(run_text(result.text, request.to).motions).back();
    EXPECT_NEAR(move.spindle_rpm, rpm_at(200.0, 50.0), 1e-6) << result.text;
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
