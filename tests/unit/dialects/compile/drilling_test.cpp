// Drilling cycles between controls with and without modal cycles: the same holes by the same moves, written as
// each control's own cycles where these do the same.
#include <algorithm>
#include <ranges>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

std::string expect_same_holes(const std::string& text, const std::string& from, const std::string& to,
                              double tolerance = 1e-6) {
  const ConvertResult result = translated(text, from, to);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, text::Source("program", text));
  if (text::has_error(result.diagnostics)) return {};
  const auto before = real_moves(run_text(text, control(from, ir::MachineKind::mill)).motions);
  const auto after = real_moves(run_text(result.text, control(to, ir::MachineKind::mill)).motions);
  expect_same(before, after, tolerance, result.text);
  return result.text;
}

void expect_refused(const std::string& text, const std::string& from, const std::string& to, std::string_view named) {
  const ConvertResult result = translated(text, from, to);
  EXPECT_TRUE(text::has_error(result.diagnostics)) << result.text;
  EXPECT_TRUE(result.text.empty());
  const std::string all = messages_of(result.diagnostics, text::Source("program", text));
  EXPECT_TRUE(all.contains(named)) << all;
}

const std::string kHead = "G21 G17 G90 G94 G40 G49 G80\nG54\nS800 M03\nG00 X0. Y0. Z40.\n";
const std::string kOwnHead = "G71 G17 G90 G94 G40\nG54\nS800 M3\nG0 X0 Y0 Z40\nF120\n";
constexpr std::string_view kSinumerik = "sinumerik-840d";
const std::string kTo(kSinumerik);
constexpr double kPrinted = 6e-5;  // computed places are printed with four decimals

TEST(DrillingToSinumerik, ReturnLevelsAreRetractionPlanes) {
  const std::string to =
      expect_same_holes(kHead + "G99 G81 X10. Y10. Z-8. R3. F120.\nX30.\nG98 Y30.\nG80\nG00 Z50.\nM30\n", "fanuc", kTo);
  EXPECT_TRUE(to.contains("MCALL CYCLE81(3,3,,-8)")) << to;
  EXPECT_TRUE(to.contains("MCALL CYCLE81(40,3,,-8)")) << to;
  EXPECT_TRUE(to.contains("\nMCALL\n")) << to;
}

TEST(DrillingToSinumerik, PecksAndDwellsStay) {
  for (const std::string from : {"fanuc", "mazak", "mitsubishi-m80"}) {
    expect_same_holes(kHead + "G99 G83 X50. Y10. Z-25. R3. Q8. F100.\nY30.\nG80\nM30\n", from, kTo);
    expect_same_holes(kHead + "G98 G82 X70. Y10. Z-5. R3. P500 F90.\nX80.\nG80\nG00 Z60.\nM30\n", from, kTo);
    expect_same_holes(kHead + "G98 G85 X70. Y10. Z-5. R3. F90.\nX80.\nG80\nG00 Z60.\nM30\n", from, kTo);
    expect_same_holes(kHead + "G98 G89 X70. Y10. Z-5. R3. P200 F90.\nX80.\nG80\nG00 Z60.\nM30\n", from, kTo);
  }
}

// K is a length elsewhere, and K2 of one would be 0.002 mm; in a boring cycle of another plane it is one.
TEST(DrillingOfNumberedControls, HowManyHolesStaysANumber) {
  for (const std::string to : {"mazak", "mitsubishi-m80"}) {
    const std::string made = expect_same_holes(
        kHead + "G91 G99 G81 X10. Z-30. R-3. K2 F100.\nX5. K3\nG80\nG90 G00 Z50.\nM30\n", "fanuc", to);
    EXPECT_TRUE(made.contains("K2 F100.")) << made;
    EXPECT_TRUE(made.contains("X5. K3")) << made;
    const std::string aside =
        expect_same_holes(kHead + "G18 G99 G76 X10. Z10. Y-30. R3. I500 K500 F100.\nG80\nG00 Y50.\nM30\n", "fanuc", to);
    EXPECT_TRUE(aside.contains("I0.5 K0.5")) << aside;
  }
}

// The chips are broken all the same; that the return takes longer or shorter is reported.
TEST(DrillingToSinumerik, ChipBreakingGoesBackAtAnotherSpeed) {
  const std::string numbered = kHead + "G99 G73 X50. Y10. Z-25. R3. Q8. F100.\nG80\nG00 Z50.\nM30\n";
  const std::string named = kOwnHead + "CYCLE83(40,3,0,-25,,,8,0,,,1,0)\nG0 Z50\nM30\n";
  for (const auto& [text, from, to] :
       {std::tuple(numbered, std::string("fanuc"), kTo), std::tuple(named, kTo, std::string("fanuc"))}) {
    const ConvertResult made = translated(text, from, to);
    EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
    const std::string all = messages_of(made.diagnostics, text::Source("program", text));
    EXPECT_TRUE(all.contains("the retract between the pecks")) << all;
  }
}

TEST(DrillingToSinumerik, WordsStayFromBlockToBlockAndChangeAlone) {
  expect_same_holes(kHead + "G98 G81 X10. Y10. Z-8. R3. F120.\nZ-12.\nX20. R1.\nG82 X30. P300\nG80\nM30\n", "fanuc",
                    kTo);
}

TEST(DrillingToSinumerik, InALoopWithComputedPlaces) {
  expect_same_holes(kHead +
                        "#1=0\nG99 G81 Z-8. R3. F120. K0\nWHILE[#1LT5]DO1\nX[10.*#1] Y[#1*#1]\n#1=#1+1\nEND1\nG80\n"
                        "G01 X0. F200.\nM30\n",
                    "fanuc", kTo);
}

TEST(DrillingToSinumerik, FromAPlaceThatIsComputed) {
  const std::string to = expect_same_holes(
      "#5=33.\n" + kHead + "G00 Z#5\nG98 G81 X10. Y10. Z-8. R3. F120.\nX20.\nG80\nM30\n", "fanuc", kTo);
  EXPECT_TRUE(to.contains("$P_EP[Z]")) << to;
}

TEST(DrillingToSinumerik, IncrementsAndRepeats) {
  expect_same_holes(kHead + "G91 G99 G81 X10. Y5. Z-11. R-37. F120. K4\nG80\nG90 G00 Z40.\nM30\n", "fanuc", kTo);
}

TEST(DrillingToSinumerik, TheMotionAfterTheCycleIsReported) {
  const std::string to =
      expect_same_holes(kHead + "G01 X1. F100.\nG99 G81 X10. Z-8. R3.\nG80\nX50.\nM30\n", "fanuc", kTo);
  EXPECT_TRUE(to.contains("MCALL\nG1\n") || to.contains("MCALL\nG01\n")) << to;
}

TEST(DrillingToSinumerik, WhatHasNoEqualIsAnErrorWithItsPlace) {
  expect_refused(kHead + "G18 G98 G76 X1. Z1. Y-5. R2. Q1. F50.\nG80\nM30\n", "fanuc", kTo, "program:5");
  expect_refused(kHead + "G18 G98 G76 X1. Z1. Y-5. R2. Q1. F50.\nG80\nM30\n", "fanuc", kTo, "boring");
  // The initial level is lost after G99.
  expect_refused("#5=33.\n" + kHead + "G00 Z#5\nG99 G81 X10. Z-8. R3. F120.\nG98 X20.\nG80\nM30\n", "fanuc", kTo,
                 "level where the drilling cycle began");
  // A depth of an earlier block that may be another by now.
  expect_refused(kHead + "#1=-5.\nG99 G81 X10. Z#1 R3. F120.\n#1=-9.\nX20. R2.\nG80\nM30\n", "fanuc", kTo, "Z of the");
  // A cycle that the operator's switch leaves out.
  expect_refused(kHead + "/G99 G81 X10. Z-8. R3. F120.\nX20.\nG80\nM30\n", "fanuc", kTo, "two control-flow paths");
  // Two paths with different cycles.
  expect_refused(kHead + "#1=2.\nG99 G81 X10. Z-8. R3. F120.\nIF[#1GT1.]GOTO10\nG80\nN10 X20.\nM30\n", "fanuc", kTo,
                 "two control-flow paths");
}

TEST(DrillingToSinumerik, TapsGetTheirLead) {
  const ConvertResult result = translated(kHead + "G98 G84 X10. Y10. Z-8. R3. F1000.\nG80\nM30\n", "fanuc", kTo);
  ASSERT_FALSE(text::has_error(result.diagnostics));
  EXPECT_TRUE(result.text.contains("MCALL CYCLE84(40,3,,-8,,,3,,1.25,,800)")) << result.text;
}

TEST(DrillingFromSinumerik, ToModalCyclesWhereTheToolStandsAtTheRetractionPlane) {
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const std::string text =
        expect_same_holes(kOwnHead + "MCALL CYCLE81(40,2,1,-8)\nX10 Y10\nX20\nMCALL\nG0 Z60\nM30\n", kTo, to);
    EXPECT_TRUE(text.contains("G98 G81 Z-8. R3. K0")) << text;
    EXPECT_TRUE(text.contains("\nX20.\nG80\n")) << text;
  }
}

TEST(DrillingFromSinumerik, ToMovesWhereItDoesNot) {
  const std::string text =
      expect_same_holes(kOwnHead + "MCALL CYCLE82(10,2,1,-8,,0.5)\nX10 Y10\nX20\nMCALL\nG0 Z60\nM30\n", kTo, "fanuc");
  EXPECT_FALSE(text.contains("G82")) << text;
  EXPECT_TRUE(text.contains("G04 P500")) << text;
}

TEST(DrillingFromSinumerik, PecksBoresAndPatterns) {
  expect_same_holes(kOwnHead + "MCALL CYCLE83(40,2,0,-20,,,8,0,,,1,1,,,,,1)\nX10 Y10\nX20\nMCALL\nM30\n", kTo, "mazak");
  expect_same_holes(kOwnHead + "MCALL CYCLE85(40,2,1,-8,,,80,160)\nX10 Y10\nX20\nMCALL\nM30\n", kTo, "fanuc");
  expect_same_holes(kOwnHead + "MCALL CYCLE81(40,2,1,,8)\nHOLES1(5,5,30,10,12,4)\nMCALL\nM30\n", kTo, "fanuc",
                    kPrinted);
  expect_same_holes(kOwnHead + "MCALL CYCLE81(10,2,1,,8)\nHOLES2(5,5,30,10,0,6)\nMCALL\nM30\n", kTo, "mitsubishi-m80",
                    kPrinted);
}

// Away from RTP the initial level of G98 would be another: the cycle ends at R, and the tool goes on to RTP.
TEST(DrillingFromSinumerik, PecksFromAboveAndBelowTheRetractionPlane) {
  const std::string holes = "MCALL CYCLE83(10,2,0,-20,,,8,0,,,1,1,,,,,1)\nX10 Y10\nX20\nMCALL\nM30\n";
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    for (const std::string height : {"", "Z8\n"}) {
      const std::string text = std::string(kOwnHead).append(height).append(holes);
      const ConvertResult result = translated(text, kTo, to);
      ASSERT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, text::Source("p", text));
      EXPECT_EQ(result.not_verified, "");
      EXPECT_TRUE(result.text.contains("X10. Y10.\nG99 G83 Z-20. R2. Q8.\nG80\nG00 Z10.\n")) << result.text;
      const auto before = real_moves(run_text(text, control(kTo, ir::MachineKind::mill)).motions);
      const auto after = real_moves(run_text(result.text, control(to, ir::MachineKind::mill)).motions);
      const auto highest = [](const std::vector<ir::Motion>& moves) {
        return std::ranges::max(moves | std::views::drop(1) |
                                std::views::transform([](const ir::Motion& m) { return m.end[2]; }));
      };
      EXPECT_EQ(highest(before), highest(after)) << result.text;
    }
  }
}

TEST(DrillingFromSinumerik, PecksToAComputedDepth) {
  const std::string text =
      "DEF REAL DEPTH=-9\n" + kOwnHead + "Z10\nCYCLE83(10,2,0,DEPTH,,,4,0,,,1,1,,,,,1)\nX20\nM30\n";
  const std::string to = expect_same_holes(text, kTo, "fanuc");
  EXPECT_TRUE(to.contains("G98 G83 Z#100 R2. Q4.")) << to;
}

TEST(DrillingFromSinumerik, ASingleCallIsOneHole) {
  const std::string text = expect_same_holes(
      kOwnHead + "CYCLE81(40,2,1,-8)\nG1 X20 F100\nCYCLE81(40,2,1,-8)\nX30\nG0 Z60\nM30\n", kTo, "fanuc");
  EXPECT_TRUE(text.contains("G81")) << text;
}

TEST(DrillingFromSinumerik, LevelsThatAreComputedWithoutAClearance) {
  expect_same_holes(
      "DEF REAL TOP=10, REF=2, BOTTOM=-7\n" + kOwnHead + "MCALL CYCLE81(TOP,REF,,BOTTOM)\nX10 Y10\nMCALL\nM30\n", kTo,
      "fanuc");
}

TEST(DrillingFromSinumerik, WhatHasNoEqualIsAnErrorWithItsPlace) {
  expect_refused("DEF REAL TOP=10\n" + kOwnHead + "MCALL CYCLE81(TOP,2,1,-8)\nX1\nMCALL\nM30\n", kTo, "fanuc",
                 "which side");
  expect_refused(kOwnHead + "MCALL CYCLE83(TOP,2,1,-20,,,8,0,,,1,1)\nX=$AA_IW[X]\nMCALL\nM30\n", kTo, "fanuc",
                 "program:6");
  expect_refused(kOwnHead + "MCALL CYCLE83(40,2,1,-20,,,8,2,,,1,1)\nX=$AA_IW[X]\nMCALL\nM30\n", kTo, "fanuc",
                 "grow less");
  expect_refused(kOwnHead + "CYCLE86(40,2,1,-20,,0,3,1,1,1,30)\nM30\n", kTo, "fanuc", "CYCLE86");
}

// A level that is stated by itself counts from there on (a retract past a clamp).
TEST(DrillingToSinumerik, AReturnLevelByItself) {
  for (const std::string level : {"G98\n", "G98 M08\n", "G90 G98\n"}) {
    std::string from = kHead + "G99 G81 X10. Z-5. R2. F100.\nX20.\n";
    from.append(level).append("X30.\nG99\nX40.\nG80\nM30\n");
    const std::string to = expect_same_holes(from, "fanuc", kTo);
    EXPECT_TRUE(to.contains("MCALL CYCLE81(40,2,,-5)\nG0 X30.\nMCALL CYCLE81(2,2,,-5)\nG0 X40.\n")) << to;
  }
}

// Words of a dwell or a shift are no positions and no words of the cycle.
TEST(DrillingToSinumerik, DwellsAndShiftsBetweenHoles) {
  const std::string to =
      expect_same_holes(kHead + "G98 G82 X1. Z-5. R2. P100 F100.\nG4 P200\nG04 X2.\nX3.\nG80\nM30\n", "fanuc", kTo);
  EXPECT_TRUE(to.contains("G4 F0.2\nG4 F2\nG0 X3.")) << to;
  expect_same_holes(kHead + "G98 G81 X1. Z-5. R2. F100.\nG52 X10. Y5.\nX2. Y0\nG52 X0 Y0\nX3.\nG80\nM30\n", "fanuc",
                    kTo);
  expect_refused(kHead + "G98 G81 X1. Z-5. R2. F100.\nG53 X20. Y5.\nX3.\nG80\nM30\n", "fanuc", kTo,
                 "G53 in a block of a drilling cycle");
  expect_refused(kHead + "G98 G81 X1. Z-5. R2. F100.\nG28 Z40.\nX3.\nG80\nM30\n", "fanuc", kTo, "PS0044");
}

// Whether G84 alone is a rigid tap, a parameter decides; where pecks count from, the cycle.
TEST(DrillingToSinumerik, WhatThePictureOfTheHoleLeavesOpenIsReported) {
  const auto messages = [](const std::string& text, const std::string& from, const std::string& to) {
    return messages_of(translated(text, from, to).diagnostics, text::Source("p", text));
  };
  const std::string tap = "G98 G84 X1. Z-5. R2. F600.\nG80\nM30\n";
  EXPECT_TRUE(messages(kHead + "S600 M3\n" + tap, "fanuc", kTo).contains("written as a rigid one"));
  EXPECT_FALSE(messages(kHead + "S600 M3\nM29 S600\n" + tap, "fanuc", kTo).contains("written as a rigid one"));
  const std::string own = "G17 G90 G710 G94 F100 S1000 M3\nT1 D1 M6\nG0 X0 Y0 Z10\n";
  EXPECT_TRUE(messages(own + "MCALL CYCLE83(10,0,2,-20,,-5,,0,0,0,1,1)\nX=$AA_IW[X]\nMCALL\nM30\n", kTo, "fanuc")
                  .contains("counts from R"));
  EXPECT_FALSE(messages(own + "CYCLE83(10,0,0,-20,,-5,,0,0,0,1,1)\nM30\n", kTo, "fanuc").contains("counts from R"));
}

// Mazak's second feed, of the retract of a reamed hole.
TEST(DrillingToOthers, EOfMazakIsRefusedAndReported) {
  const std::string text = kHead + "G98 G85 X1. Z-5. R2. F100. E200.\nX3.\nG80\nM30\n";
  for (const std::string& to : {std::string("fanuc"), std::string("mitsubishi-m80"), kTo})
    EXPECT_TRUE(text::has_error(translated(text, "mazak", to).diagnostics)) << to;
  const Played played = run_text(text, control("mazak", ir::MachineKind::mill));
  EXPECT_TRUE(std::ranges::any_of(played.result.not_interpreted,
                                  [](const auto& one) { return one.name == "E together with a drilling cycle"; }));
}

// CYCLE84 leaves the speed as it was, CYCLE85 its own feed; a lead is a feed per turn where G95 is in effect.
TEST(DrillingFromSinumerik, WhatACycleLeavesInEffect) {
  const std::string tap = "CYCLE84(40,0,2,-15,,,3,,1.25,0,500,500)\n";
  const ConvertResult per_minute = translated(
      kOwnHead + "MCALL CYCLE85(2,0,2,-5,,,100,300)\nX10\nMCALL\nG0 Z40\n" + tap + "G1 X70\nM30\n", kTo, "fanuc");
  EXPECT_TRUE(per_minute.text.contains("G84 Z-15. R2. F625.\nG80\nS800 F300. M03\n")) << per_minute.text;
  const ConvertResult per_turn =
      translated("G71 G17 G90 G95 G40\nS800 M3\nG0 X0 Y0 Z40\nF0.12\n" + tap + "G1 X70\nM30\n", kTo, "fanuc");
  EXPECT_TRUE(per_turn.text.contains("F1.25\nG80\nS800 F0.12 M03\n")) << per_turn.text;
  const Played ran = run_text(kOwnHead + tap + "G1 X70\nM30\n", control(kTo, ir::MachineKind::mill));
  EXPECT_EQ(ran.motions.back().spindle_rpm, 800.0);
}

}  // namespace
}  // namespace dripfeed::compile::test
