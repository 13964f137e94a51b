// Programmable frames between controls: chains of frames there, G52 and frames about a point here; positions by radius
// and angle, which both have in forms of their own.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

std::string expect_same_moves(const std::string& text, const std::string& from, const std::string& to,
                              double tolerance = 1e-6) {
  const ConvertResult result = translated(text, from, to);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, text::Source("program", text));
  if (text::has_error(result.diagnostics)) return {};
  const auto before = moves_of(run_text(text, control(from, ir::MachineKind::mill)).motions);
  expect_same(before, moves_of(run_text(result.text, control(to, ir::MachineKind::mill)).motions), tolerance,
              result.text);
  return result.text;
}

void expect_refused(const std::string& text, const std::string& from, const std::string& to, std::string_view named) {
  const ConvertResult result = translated(text, from, to);
  EXPECT_TRUE(text::has_error(result.diagnostics)) << result.text;
  const std::string all = messages_of(result.diagnostics, text::Source("program", text));
  EXPECT_TRUE(all.contains(named)) << all;
}

const std::string kTo = "sinumerik-840d";
const std::string kHead = "G21 G17 G90 G94 G40 G49 G80\nG54\nG00 X0. Y0. Z5.\nG01 X10. Y5. F200.\n";
const std::string kOwnHead = "G71 G17 G90 G94 G40\nG54\nG0 X0 Y0 Z5\nG1 X10 Y5 F200\n";

TEST(FramesToSinumerik, RotationAboutAPoint) {
  for (const std::string from : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const std::string to = expect_same_moves(
        kHead + "G68 X10. Y5. R30.\nX20. Y5.\nG02 X30. Y5. I5. J0.\nG69\nG01 X0. Y0.\nM30\n", from, kTo);
    EXPECT_TRUE(to.contains("AROT RPL=30")) << to;
  }
  const std::string at_zero = expect_same_moves(kHead + "G68 X0. Y0. R-45.\nX20.\nG69\nX0.\nM30\n", "fanuc", kTo);
  EXPECT_FALSE(at_zero.contains("ATRANS")) << at_zero;
}

TEST(FramesToSinumerik, RotationInALoopReplacesTheOneBefore) {
  expect_same_moves(kHead + "#1=0\nWHILE[#1LT4]DO1\nG68 X1. Y2. R[#1*20.]\nX20. Y0.\n#1=#1+1\nEND1\nG69\nX0.\nM30\n",
                    "fanuc", kTo);
}

TEST(FramesToSinumerik, ScaleAndMirror) {
  expect_same_moves(kHead + "G51 X1. Y2. Z0. I2. J2. K1.\nX20. Y0.\nG50\nX0.\nM30\n", "fanuc", kTo);
  expect_same_moves(kHead + "G51.1 X4.\nX20. Y1.\nG51.1 Y3.\nX21. Y2.\nG50.1\nX0.\nM30\n", "fanuc", kTo);
}

TEST(FramesToSinumerik, LocalShift) {
  expect_same_moves(kHead + "G52 X5. Y6.\nX1. Y1.\nG52 X7. Y2.\nX2.\nG52 X0. Y0.\nX0.\nM30\n", "fanuc", kTo);
  expect_refused(kHead + "G52 X5. Y6.\nX1. Y1.\nG52 X7.\nX2.\nM30\n", "fanuc", kTo, "program:7");
}

TEST(FramesToSinumerik, RotationWithALocalShift) {
  for (const std::string from : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const std::string to = expect_same_moves(
        kHead +
            "G52 X5. Y6.\nG68 X1. Y2. R10.\nX1. Y7.\nG69\nX2. Y3.\nG52 X0. Y0.\nG68 X3. Y0. R40.\nX9.\nG69\nX0.\nM30\n",
        from, kTo);
    EXPECT_TRUE(to.contains("TRANS X5. Y6.")) << to;
  }
}

TEST(FramesToSinumerik, WhatOneChainCannotSayIsAnError) {
  expect_refused("#1=5.\n" + kHead + "G52 X#1\nG68 X0. Y0. R10.\nX1.\nG69\nM30\n", "fanuc", kTo, "together with a G52");
  expect_refused(kHead + "G68 X0. Y0. R10.\nG52 X5.\nX1.\nG69\nM30\n", "fanuc", kTo, "G52 while");
  expect_refused(kHead + "G51.1 X0.\nG68 X0. Y0. R10.\nX1.\nG69\nM30\n", "fanuc", kTo, "two of");
  expect_refused(kHead + "G68 R10.\nX1.\nG69\nM30\n", "fanuc", kTo, "where the tool stands");
}

TEST(FramesFromSinumerik, ShiftAndRotation) {
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const std::string text = expect_same_moves(
        kOwnHead + "TRANS X30 Y5\nAROT RPL=20\nX10 Y0\nG3 X10 Y10 CR=5\nG1 X0\nTRANS\nX1 Y1\nM30\n", kTo, to);
    EXPECT_TRUE(text.contains("G68 X0. Y0. R20")) << text;
    expect_same_moves(kOwnHead + "TRANS X30 Y5\nROT Z=40\nX10 Y0\nROT\nX1 Y1\nM30\n", kTo, to);
  }
}

TEST(FramesFromSinumerik, MirrorScaleAndRotationInTheOrderThatIsTheSame) {
  expect_same_moves(kOwnHead + "TRANS X3 Y1\nAMIRROR X0\nASCALE X2 Y2\nAROT RPL=15\nX4 Y2\nTRANS\nX0\nM30\n", kTo,
                    "fanuc");
  expect_same_moves(kOwnHead + "MIRROR Y0\nX4 Y2\nMIRROR\nX0\nM30\n", kTo, "fanuc");
}

TEST(FramesFromSinumerik, AddedShiftsAreWrittenAsOne) {
  const std::string to = expect_same_moves(
      kOwnHead +
          "R1=1\nTRANS X10 Y-4\nX1\nATRANS X5 Z2\nX2 Z1\nATRANS Y=R1+3\nY1\nAROT RPL=30\nX4 Y2\nTRANS\nX0 Y0\nM30\n",
      kTo, "fanuc");
  EXPECT_TRUE(to.contains("G52 X15. Y-4. Z2.\n")) << to;
  expect_same_moves(kOwnHead + "ATRANS X5\nX2\nTRANS\nX0\nM30\n", kTo, "mazak");
  expect_refused(kOwnHead + "R1=3\nTRANS X=R1\nATRANS X5\nX1\nTRANS\nM30\n", kTo, "fanuc", "a shift that is computed");
  expect_refused(kOwnHead + "TRANS X3\nG70\nATRANS X5\nX1\nTRANS\nM30\n", kTo, "fanuc", "a shift that is computed");
}

TEST(FramesFromSinumerik, InALoopThatBeginsAgain) {
  expect_same_moves(
      "DEF INT I\n" + kOwnHead + "FOR I=0 TO 3\nTRANS X=I*10 Y=2\nAROT RPL=I*15\nX5 Y1\nENDFOR\nTRANS\nX0 Y0\nM30\n",
      kTo, "fanuc");
}

TEST(FramesFromSinumerik, WhatHasNoEqualIsAnErrorWithItsPlace) {
  expect_refused(kOwnHead + "ROT RPL=10\nATRANS X5\nX1\nTRANS\nM30\n", kTo, "fanuc", "program:6");
  expect_refused(kOwnHead + "ROT RPL=10\nAROT RPL=10\nX1\nTRANS\nM30\n", kTo, "fanuc", "AROT");
  expect_refused(kOwnHead + "ROT X=10\nX1\nTRANS\nM30\n", kTo, "fanuc", "axis on the plane");
  expect_refused("DEF INT I\n" + kOwnHead + "FOR I=0 TO 3\nAROT RPL=10\nX1\nENDFOR\nTRANS\nM30\n", kTo, "fanuc",
                 "not known here");
}

// --- polar positions

constexpr double kRounded = 1e-4;  // four decimals

TEST(PolarFromSinumerik, BecomeCoordinates) {
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const std::string text = expect_same_moves(
        kOwnHead + "G111 X20 Y10\nG1 AP=0 RP=30\nAP=IC(60)\nR1=15\nRP=R1 AP=R1*2\nX1 Y1\nG91\nRP=5 AP=90\nX1\nM30\n",
        kTo, to, kRounded);
    EXPECT_TRUE(text.contains("X50. Y10.")) << text;
    EXPECT_TRUE(text.contains("COS[#")) << text;
  }
}

TEST(PolarFromSinumerik, ArcsRoundThePole) {
  expect_same_moves(kOwnHead + "G111 X10 Y5\nG0 AP=0 RP=30\nG3 AP=90 RP=30\nG2 AP=IC(-45) RP=30\nM30\n", kTo, "fanuc",
                    kRounded);
}

TEST(PolarFromSinumerik, APoleIsWhatItWasWhenItWasSet) {
  expect_same_moves(kOwnHead + "R1=5\nG111 X=R1 Y1\nR1=99\nG0 AP=0 RP=3\nG112 X1 Y=R1\nAP=0 RP=3\nM30\n", kTo, "fanuc",
                    kRounded);
}

// One pole reaches the loop, another is set after it.
TEST(PolarFromSinumerik, LoopsKeepTheirPole) {
  expect_same_moves(
      "DEF INT I\n" + kOwnHead + "G111 X5 Y5\nFOR I=0 TO 3\nG1 AP=I*90 RP=10\nENDFOR\nG111 X1 Y1\nAP=0 RP=1\nM30\n",
      kTo, "fanuc", kRounded);
}

TEST(PolarFromSinumerik, WhatIsNotKnownIsAnErrorWithItsPlace) {
  expect_refused("DEF INT I\n" + kOwnHead + "G111 X5 Y5\nFOR I=0 TO 3\nG1 AP=I*90 RP=10\nG111 X1 Y1\nENDFOR\nM30\n",
                 kTo, "fanuc",
                 "program:8:1: error[translation-not-known]: a polar position whose pole is not known here");
  expect_refused(kOwnHead + "G110 X5 Y5\nG1 AP=10 RP=10\nM30\n", kTo, "fanuc", "counts from the last position");
  expect_refused(kOwnHead + "G111 X5 Y5\nG1 AP=10 RP=R1\nAP=20\nM30\n", kTo, "fanuc", "radius or angle is not known");
}

TEST(PolarToSinumerik, BecomeCoordinates) {
  for (const std::string from : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const std::string text = expect_same_moves(
        kHead + "G16\nG00 X50. Y30.\nY90.\nG91 Y30.\nG90 X40. Y0.\nG15\nX1. Y2.\nM30\n", from, kTo, kRounded);
    EXPECT_TRUE(text.contains("X43.3013 Y25.")) << text;
  }
  const std::string holes = kHead + "G00 Z20.\nG16\nG99 G81 X50. Y30. Z-5. R2.\nY90.\nG80 G15\nM30\n";
  const ConvertResult drilled = translated(holes, "fanuc", kTo);
  EXPECT_TRUE(drilled.text.contains("MCALL CYCLE81(2,2,,-5)\nG0 X43.3013 Y25.\nG0 X0. Y50.\nMCALL\n")) << drilled.text;
}

// The classic circle of holes: each repetition adds the angle again.
TEST(PolarToSinumerik, HolesByRepeatedAngles) {
  const std::string text =
      kHead + "G00 Z20.\nG16\nG99 G81 X50. Y0. Z-5. R2. F100.\nG91 Y90. K3\nG80 G15 G90\nX1. Y2.\nM30\n";
  const auto holes = [](const std::string& program, const std::string& dialect) {
    std::vector<std::pair<double, double>> places;
    for (const ir::Motion& m : run_text(program, control(dialect, ir::MachineKind::mill)).motions)
      if (m.kind == ir::MotionKind::linear && m.end[2] == -5.0)
        places.emplace_back(std::round(m.end[0]), std::round(m.end[1]));
    return places;
  };
  const std::vector<std::pair<double, double>> expected = {{50, 0}, {0, 50}, {-50, 0}, {0, -50}};
  EXPECT_EQ(holes(text, "fanuc"), expected);
  EXPECT_EQ(holes(translated(text, "fanuc", kTo).text, kTo), expected);
}

TEST(PolarToSinumerik, WhatIsNotKnownIsAnErrorWithItsPlace) {
  expect_refused(kHead + "G16\nG91 G00 X5. Y30.\nG15\nG90 X1. Y2.\nM30\n", "fanuc", kTo, "from where the tool stands");
  expect_refused(kHead + "G16\n#1=0\nWHILE[#1LT3]DO1\nG00 X5. Y[#1*30.]\n#1=#1+1\nEND1\nG15\nM30\n", "fanuc", kTo,
                 "G16 over a jump");
}

}  // namespace
}  // namespace dripfeed::compile::test
