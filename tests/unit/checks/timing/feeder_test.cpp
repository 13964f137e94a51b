// The buffer by hand.
#include "checks/timing/feeder.h"

#include <gtest/gtest.h>

namespace dripfeed::timing {
namespace {

FedBlock block(std::uint64_t bytes, double compute_s, double motion_s) { return {1, true, bytes, compute_s, motion_s}; }

TEST(Feeder, WaitsForTheLineWhereMovesAreShort) {
  Feeder feeder({}, 0.01, 0.0);                     // 10 ms a character
  EXPECT_EQ(feeder.feed(block(10, 0, 0.05)), 0.0);  // the wait for the first block is no stall
  EXPECT_NEAR(feeder.end_s(), 0.15, 1e-12);
  EXPECT_NEAR(feeder.feed(block(10, 0, 0.05)), 0.05, 1e-12);  // it arrives at 0.2
  EXPECT_NEAR(feeder.feed(block(2, 0, 1.0)), 0.0, 1e-12);     // at 0.22, before 0.25
  EXPECT_NEAR(feeder.end_s(), 1.25, 1e-12);
}

TEST(Feeder, WaitsForComputing) {
  Feeder feeder({}, 0.0, 0.0);
  feeder.feed(block(0, 0.1, 0.05));
  EXPECT_NEAR(feeder.feed(block(0, 0.1, 0.05)), 0.05, 1e-12);
  EXPECT_NEAR(feeder.feed(block(0, 0.01, 0.05)), 0.0, 1e-12);
}

TEST(Feeder, TheBuffersBlocksLimitHowFarItRunsAhead) {
  // Two blocks fit. Long moves first fill it; then a run of short moves lives on what is buffered.
  Feeder feeder({0, 2}, 0.01, 0.0);
  feeder.feed(block(10, 0, 1.0));   // there at 0.1, moves 0.1 .. 1.1
  feeder.feed(block(10, 0, 0.0));   // there at 0.2
  feeder.feed(block(10, 0, 0.01));  // room at 0.1 when the first starts, there at 0.3
  // Room for the fourth when the second starts, at 1.1: there at 1.2; the third ends at 1.11.
  EXPECT_NEAR(feeder.feed(block(10, 0, 0.01)), 0.09, 1e-12);
}

TEST(Feeder, TheBuffersBytesLimitHowFarItRunsAhead) {
  Feeder feeder({20, 0}, 0.01, 0.0);
  feeder.feed(block(10, 0, 1.0));
  feeder.feed(block(10, 0, 0.01));                                  // there at 0.2
  feeder.feed(block(10, 0, 0.01));                                  // room at 0.1, there at 0.3
  EXPECT_NEAR(feeder.feed(block(10, 0, 0.01)), 1.2 - 1.12, 1e-12);  // room at 1.1
}

TEST(Feeder, ABlockLargerThanTheBufferStillPasses) {
  Feeder feeder({5, 0}, 0.01, 0.0);
  feeder.feed(block(10, 0, 0.5));
  EXPECT_NEAR(feeder.feed(block(10, 0, 0.5)), 0.0, 1e-12);
  EXPECT_NEAR(feeder.end_s(), 1.1, 1e-12);
}

TEST(Feeder, TheSecondMotionOfABlockWaitsForNothing) {
  Feeder feeder({0, 1}, 0.01, 0.0);
  feeder.feed(block(10, 0, 0.5));
  EXPECT_NEAR(feeder.feed({1, false, 0, 0, 0.5}), 0.0, 1e-12);
  EXPECT_NEAR(feeder.end_s(), 1.1, 1e-12);
}

TEST(Feeder, LatencyComesOnce) {
  Feeder feeder({}, 0.01, 0.2);
  feeder.feed(block(10, 0, 0.1));
  EXPECT_NEAR(feeder.end_s(), 0.4, 1e-12);
  EXPECT_NEAR(feeder.feed(block(10, 0, 0.1)), 0.0, 1e-12);
}

}  // namespace
}  // namespace dripfeed::timing
