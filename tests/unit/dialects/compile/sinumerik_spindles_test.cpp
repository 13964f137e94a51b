// Spindles of a SINUMERIK by their numbers: which of them S, M3 and feeds per revolution mean, and that no translation
// loses an order to one. (PG, "Spindle motion".)
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

Result lathe(const std::string& text) {
  return run("G18 G90 G95 G710 DIAMON G54\nT1 D1\n" + text + "M30\n", {}, ir::MachineKind::lathe);
}

bool leaves_open(const Result& ran) {
  return std::ranges::any_of(ran.result.not_interpreted,
                             [](const interpreter::NotInterpreted& one) { return !one.effects_known; });
}

double last_speed(const Result& ran) { return ran.motions.empty() ? -1.0 : ran.motions.back().spindle_rpm; }

ir::SpindleState last_state(const Result& ran) {
  const auto cut = std::ranges::find_if(ran.motions.rbegin(), ran.motions.rend(),
                                        [](const ir::Motion& m) { return ir::is_move(m.kind); });
  return cut == ran.motions.rend() ? ir::SpindleState::stopped : cut->spindle;
}

TEST(SinumerikSpindles, AnotherSpindleLeavesTheMainOneAlone) {
  const Result ran = lathe("S500 M3\nS2=1200 M2=4\nG1 X1 F0.1\nM2=5\n");
  EXPECT_EQ(last_speed(ran), 500.0);
  EXPECT_EQ(last_state(ran), ir::SpindleState::clockwise);
  EXPECT_TRUE(ran.names("S2"));
  EXPECT_TRUE(ran.names("M2=4"));
  EXPECT_FALSE(leaves_open(ran));
}

TEST(SinumerikSpindles, TheMainOneIsChosenWithTheSpeedThatItHas) {
  const Result ran = lathe("S500 M3\nS2=1200 M2=4\nSETMS(2)\nG1 X1 F0.1\n");
  EXPECT_EQ(last_speed(ran), 1200.0);
  EXPECT_EQ(last_state(ran), ir::SpindleState::counterclockwise);
  EXPECT_FALSE(leaves_open(ran));
}

TEST(SinumerikSpindles, WithoutNumbersTheMainOneIsMeant) {
  const Result ran = lathe("S500 M3\nSETMS(3)\nS800 M4\nG1 X1 F0.1\n");
  EXPECT_EQ(last_speed(ran), 800.0);
  EXPECT_EQ(last_state(ran), ir::SpindleState::counterclockwise);
}

TEST(SinumerikSpindles, TheUsualOneComesBackAsItWasLeft) {
  for (const char* back : {"SETMS", "SETMS()", "SETMS(1)"}) {
    const Result ran = lathe("S500 M3\nSETMS(2)\nS800 M4\n" + std::string(back) + "\nG1 X1 F0.1\n");
    EXPECT_EQ(last_speed(ran), 500.0) << back;
    EXPECT_EQ(last_state(ran), ir::SpindleState::clockwise) << back;
  }
}

TEST(SinumerikSpindles, TheFirstOneByItsNumberIsNotTheMainOneThen) {
  const Result ran = lathe("SETMS(2)\nS800 M4\nS1=300 M1=3\nG1 X1 F0.1\nSETMS\nG1 X2\n");
  ASSERT_GE(ran.motions.size(), 2U);
  EXPECT_EQ(last_speed(ran), 300.0);
  EXPECT_EQ(last_state(ran), ir::SpindleState::clockwise);
  EXPECT_TRUE(ran.trace.contains("S800.0000/rpm")) << ran.trace;
  const Result main = lathe("S1=300 M1=3\nSETMS(2)\nSETMS(1)\nG1 X1 F0.1\n");
  EXPECT_EQ(last_speed(main), 300.0);
}

TEST(SinumerikSpindles, ByItsNumberTheMainOneIsMeantToo) {
  const Result ran = lathe("SETMS(2)\nS2=700 M2=3\nG1 X1 F0.1\n");
  EXPECT_EQ(last_speed(ran), 700.0);
  EXPECT_EQ(last_state(ran), ir::SpindleState::clockwise);
  EXPECT_EQ(last_state(lathe("SETMS(2)\nS2=700 M2=3\nM2=5\nG1 X1 F0.1\n")), ir::SpindleState::stopped);
  EXPECT_EQ(last_state(lathe("SETMS(2)\nS2=700 M2=3\nSPOS[2]=90\nG1 X1 F0.1\n")), ir::SpindleState::stopped);
}

TEST(SinumerikSpindles, OfTwoSpeedsInABlockTheSecondIsNotKnown) {
  EXPECT_EQ(last_speed(lathe("S2=700 S3=900\nSETMS(2)\nM3\nG1 X1 F0.1\n")), 700.0);
  EXPECT_EQ(last_speed(lathe("S2=700 S3=900\nSETMS(3)\nM3\nG1 X1 F0.1\n")), 0.0);
}

TEST(SinumerikSpindles, WhatIsComputedIsLeftOpen) {
  EXPECT_TRUE(leaves_open(lathe("R1=2\nSETMS(R1)\n")));
  EXPECT_TRUE(leaves_open(lathe("R1=2\nS[R1]=500\n")));
  EXPECT_TRUE(leaves_open(lathe("R1=2\nSPOS[R1]=5\n")));
  EXPECT_FALSE(leaves_open(lathe("R1=2\nS2=R1*100\n")));
}

TEST(SinumerikSpindles, PositionsAndTheirControlLeaveNothingOpen) {
  for (const char* text : {"SPOS=90\n", "SPOS=IC(20)\n", "SPOSA=DC(5)\nWAITS\n", "SPOS[1]=ACP(3)\n", "SPOS[2]=5\n",
                           "M2=19\n", "M2=43\n", "SPCON\nSPCOF\n"})
    EXPECT_FALSE(leaves_open(lathe(text))) << text;
  EXPECT_TRUE(leaves_open(lathe("M2=70\n")));
}

// Feeds of axes that move by themselves, and along which axes the path's counts.
TEST(SinumerikSpindles, HowFeedsCountLeavesNoPathOpen) {
  for (const char* text : {"FGROUP(X,Z)\nFGROUP()\n", "POS[Z]=5 FA[Z]=100\n", "CYCLE832(0.01,_ROUGH,1)\n",
                           "CYCLE832(0.1,3,1)\n", "CYCLE832()\n", "CYCLE832(0.01)\n"})
    EXPECT_FALSE(leaves_open(lathe(text))) << text;
  // Older versions switched transformations by the digits above the tens.
  EXPECT_TRUE(leaves_open(lathe("CYCLE832(0.1,112101)\n")));
  EXPECT_TRUE(leaves_open(lathe("R1=3\nCYCLE832(0.1,R1,1)\n")));
}

// --- translations

TEST(SinumerikSpindles, NoTranslationLosesAnOrderToASpindle) {
  const std::string head = "G17 G90 G94 G710 G54\nT1 D1 M6\nS500 M3\nG0 X0 Y0 Z5\n";
  for (const char* order : {"S2=500\n", "M2=3\n", "SPOS=90\n", "SPOSA=90\n", "SPOS[2]=90\n", "SETMS(2)\n", "SETMS\n",
                            "M2=19\n", "FGROUP(X)\n", "POS[X]=5 FA[X]=100\n"})
    for (const char* to : {"fanuc", "haas", "mazak", "mitsubishi-m80"})
      for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
        ConvertRequest request;
        request.source = text::Source("program", head + order + "G1 X5 F100\nM30\n");
        request.from = control("sinumerik-840d", ir::MachineKind::mill);
        request.to = control(to, ir::MachineKind::mill);
        request.mode = mode;
        EXPECT_TRUE(text::has_error(convert(request).diagnostics)) << order << to << static_cast<int>(mode);
      }
}

}  // namespace
}  // namespace dripfeed::compile::test
