// The judge's stopwatch: seconds of a block from its words by hand-made sums, and what it will not run.
#include "server/simulator/block_clock.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace dripfeed::simulator {
namespace {

constexpr BlockClockSettings kPlain{
    .x_is_diameter = false, .comment_open = '(', .rapid_mm_min = 6000.0, .acceleration_mm_s2 = 1000.0, .block_ms = 1.0};
constexpr double kBlock_s = 0.001;
// From rest to rest: the distance at full speed, and once the time to reach it.
double move_s(double length_mm, double speed_mm_s) {
  if (length_mm < speed_mm_s * speed_mm_s / 1000.0) return 2.0 * std::sqrt(length_mm / 1000.0);
  return length_mm / speed_mm_s + speed_mm_s / 1000.0;
}

TEST(BlockClock, MovesFromRestToRest) {
  BlockClock clock(kPlain);
  EXPECT_NEAR(clock.run("G0X300.Z400."), kBlock_s + move_s(500.0, 100.0), 1e-9);
  EXPECT_NEAR(clock.run("X300.Z400."), kBlock_s, 1e-12) << "already there";
  EXPECT_NEAR(clock.run("G1 X310. F600"), kBlock_s + move_s(10.0, 10.0), 1e-9);
  EXPECT_NEAR(clock.run("x320."), kBlock_s + move_s(10.0, 10.0), 1e-9) << "modal, and small letters";
  EXPECT_NEAR(clock.run("G91X5."), kBlock_s + move_s(5.0, 10.0), 1e-9);
  EXPECT_NEAR(clock.run("G0X1."), kBlock_s + move_s(1.0, 100.0), 1e-9) << "too short for full speed";
}

TEST(BlockClock, FeedPerRevolutionAndSurfaceSpeed) {
  BlockClock clock(kPlain);
  clock.run("G99S600M3");
  EXPECT_NEAR(clock.run("G1Z-10.F0.5"), kBlock_s + move_s(10.0, 5.0), 1e-9);
  clock.run("G0X100.");
  clock.run("G96S314.159265");
  const double rpm = 314.159265 * 1000.0 / (std::numbers::pi * 100.0);
  EXPECT_NEAR(clock.run("G1Z-20."), kBlock_s + move_s(10.0, 0.5 * rpm / 60.0), 1e-9);
}

TEST(BlockClock, DiametersAndInches) {
  BlockClockSettings turning = kPlain;
  turning.x_is_diameter = true;
  BlockClock lathe(turning);
  EXPECT_NEAR(lathe.run("G0X400."), kBlock_s + move_s(200.0, 100.0), 1e-9);
  BlockClock inches(kPlain);
  EXPECT_NEAR(inches.run("G20G1X10.F60"), kBlock_s + move_s(254.0, 25.4), 1e-9);
}

TEST(BlockClock, Dwells) {
  BlockClock clock(kPlain);
  EXPECT_NEAR(clock.run("G4P1500"), kBlock_s + 1.5, 1e-12);
  EXPECT_NEAR(clock.run("G04X2.5"), kBlock_s + 2.5, 1e-12);
  BlockClockSettings siemens = kPlain;
  siemens.comment_open = ';';
  BlockClock other(siemens);
  other.run("G1 X1 F600");
  EXPECT_NEAR(other.run("G4 F3"), kBlock_s + 3.0, 1e-12);
  EXPECT_NEAR(other.run("X11"), kBlock_s + move_s(10.0, 10.0), 1e-9) << "the F of a dwell is no feed";
}

TEST(BlockClock, CommentsNamesAndEndsTakeABlocksTime) {
  BlockClock clock(kPlain);
  for (const char* block : {"", "%", "O0001(X99.)", "(G0X99.)", "/N10", "N20 (open", "T0101M6"}) {
    EXPECT_NEAR(clock.run(block), kBlock_s, 1e-12) << block;
    EXPECT_EQ(clock.fault(), "") << block;
  }
  EXPECT_FALSE(clock.ended());
  clock.run("M30");
  EXPECT_TRUE(clock.ended());
  BlockClockSettings siemens = kPlain;
  siemens.comment_open = ';';
  BlockClock other(siemens);
  for (const char* block : {"N10 DIAMON", "MSG(\"G0 X99\")", "LIMS=3000", "T=\"DRILL\" ; X99", "CR=5"}) {
    EXPECT_NEAR(other.run(block), kBlock_s, 1e-12) << block;
    EXPECT_EQ(other.fault(), "") << block;
  }
  other.run("M17");
  EXPECT_TRUE(other.ended());
}

TEST(BlockClock, WhatIsNotPlainIsNotRun) {
  BlockClock clock(kPlain);
  for (const char* block : {"#1=5", "WHILE[#1LT3]DO1", "GOTO10", "X[1+2]", "X#1", "X", "X-", "\"", "X1.\x01"}) {
    clock.run(block);
    EXPECT_NE(clock.fault(), "") << block;
  }
  EXPECT_NEAR(clock.run("G0X100."), kBlock_s + move_s(100.0, 100.0), 1e-9) << "and the position is as before";
  EXPECT_EQ(clock.fault(), "");
  BlockClockSettings siemens = kPlain;
  siemens.comment_open = ';';
  BlockClock other(siemens);
  for (const char* block : {"IF R1==2 GOTOF X", "FOR R1=1 TO 5", "R1=5+", "$AA"}) {
    other.run(block);
    EXPECT_NE(other.fault(), "") << block;
  }
}

TEST(BlockClock, NumbersBeyondReasonGiveATimeAllTheSame) {
  BlockClock clock(kPlain);
  for (const char* block : {"G99999999999999999999", "M99999999999999999999", "G1X1.F0.00000000000001",
                            "G4P1"
                            "000000000000000000000000",
                            "G1X99999999999999999999999999999.F1", "G1X0.F0", "G96S1X0.F1Z5."}) {
    const double seconds = clock.run(block);
    EXPECT_TRUE(std::isfinite(seconds)) << block;
    EXPECT_GE(seconds, 0.0) << block;
    EXPECT_LE(seconds, 1e6) << block;
  }
}

}  // namespace
}  // namespace dripfeed::simulator
