// The buffer by hand, and moves that the control knows too late.
#include "checks/timing/execution.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "checks/timing/look_ahead.h"

namespace dripfeed::timing {
namespace {

class Collect final : public RanSink {
 public:
  bool ran(const Row& /*row*/, const Ran& how) override {
    all.push_back(how);
    return true;
  }
  std::vector<Ran> all;
};

// A block that moves for some time without a speed: the buffer alone.
Row block(std::uint32_t bytes, double compute_s, double event_s, bool is_new = true) {
  return {.line = 1, .bytes = bytes, .is_new = is_new, .compute_s = compute_s, .event_s = event_s};
}

std::vector<Ran> run(const Rows& rows, const SupplySettings& supply, const PieceArrays& pieces = {},
                     std::size_t look_ahead = 0) {
  SpeedPlan plan;
  plan_path(pieces, {look_ahead, 1}, plan);
  std::vector<double> sums;
  change_sums(pieces, sums);
  Collect collect;
  Execution execution(supply);
  execution.run({rows, pieces, plan.speed2, plan.duration_s, sums, pieces.size(), true}, collect);
  return collect.all;
}

TEST(Execution, WaitsForTheLineWhereMovesAreShort) {
  const auto ran = run({block(10, 0, 0.05), block(10, 0, 0.05), block(2, 0, 1.0)}, {{}, 0.01, 0.0});
  EXPECT_EQ(ran[0].waited_s, 0.0);  // the wait for the first block is no stall
  EXPECT_NEAR(ran[0].start_s, 0.1, 1e-12);
  EXPECT_NEAR(ran[1].waited_s, 0.05, 1e-12);  // it arrives at 0.2
  EXPECT_EQ(ran[1].limiter, Limiter::line);
  EXPECT_EQ(ran[2].waited_s, 0.0);  // at 0.22, before 0.25
  EXPECT_NEAR(ran[2].start_s, 0.25, 1e-12);
}

TEST(Execution, WaitsForComputing) {
  const auto ran = run({block(0, 0.1, 0.05), block(0, 0.1, 0.05), block(0, 0.01, 0.05)}, {});
  EXPECT_NEAR(ran[1].waited_s, 0.05, 1e-12);
  EXPECT_EQ(ran[1].limiter, Limiter::compute);
  EXPECT_EQ(ran[2].waited_s, 0.0);
}

TEST(Execution, TheBuffersBlocksLimitHowFarItRunsAhead) {
  // Two blocks fit. Long moves first fill it; then a run of short moves lives on what is buffered.
  const auto ran =
      run({block(10, 0, 1.0), block(10, 0, 0.0), block(10, 0, 0.01), block(10, 0, 0.01)}, {{0, 2}, 0.01, 0.0});
  // Room for the fourth when the second starts, at 1.1: there at 1.2; the third ends at 1.11.
  EXPECT_NEAR(ran[3].waited_s, 0.09, 1e-12);
}

TEST(Execution, TheBuffersBytesLimitHowFarItRunsAhead) {
  const auto ran =
      run({block(10, 0, 1.0), block(10, 0, 0.01), block(10, 0, 0.01), block(10, 0, 0.01)}, {{20, 0}, 0.01, 0.0});
  EXPECT_NEAR(ran[3].waited_s, 1.2 - 1.12, 1e-12);  // room at 1.1
  EXPECT_EQ(ran[1].buffered_blocks, 1U);            // the third came at 0.3, the fourth has not
  EXPECT_EQ(ran[1].buffered_bytes, 10U);
}

TEST(Execution, ABlockLargerThanTheBufferStillPasses) {
  const auto ran = run({block(10, 0, 0.5), block(10, 0, 0.5)}, {{5, 0}, 0.01, 0.0});
  EXPECT_EQ(ran[1].waited_s, 0.0);
  EXPECT_NEAR(ran[1].start_s, 0.6, 1e-12);
}

TEST(Execution, TheSecondMotionOfABlockWaitsForNothing) {
  const auto ran = run({block(10, 0, 0.5), block(0, 0, 0.5, false)}, {{0, 1}, 0.01, 0.0});
  EXPECT_EQ(ran[1].waited_s, 0.0);
  EXPECT_NEAR(ran[1].start_s, 0.6, 1e-12);
}

TEST(Execution, LatencyComesOnce) {
  const auto ran = run({block(10, 0, 0.1), block(10, 0, 0.1)}, {{}, 0.01, 0.2});
  EXPECT_NEAR(ran[0].start_s, 0.3, 1e-12);
  EXPECT_EQ(ran[1].waited_s, 0.0);
}

Row piece_row(std::uint32_t bytes) { return {.line = 1, .bytes = bytes, .is_piece = true}; }

TEST(Execution, BrakesAtTheEndOfWhatItKnows) {
  // Two straight pieces of 50 mm at 100 mm/s and 1000 mm/s², passed without slowing when both are known in time.
  PieceArrays pieces;
  pieces.push_back({50, 1e4, 0, 1000});
  pieces.push_back({50, 1e4, kNoLimit, 1000});
  // The first takes 0.55 s when it need not brake, and would have to brake from 0.5 s on.
  const auto in_time = run({piece_row(10), piece_row(40)}, {{}, 0.01, 0.0}, pieces);
  EXPECT_NEAR(in_time[0].start_s, 0.1, 1e-12);
  EXPECT_NEAR(in_time[0].duration_s, 0.55, 1e-12);
  EXPECT_EQ(in_time[0].limiter, Limiter::motion);
  const auto too_late = run({piece_row(10), piece_row(55)}, {{}, 0.01, 0.0}, pieces);
  EXPECT_NEAR(too_late[0].duration_s, 0.6, 1e-12);
  EXPECT_EQ(too_late[0].end2, 0.0);
  EXPECT_EQ(too_late[0].limiter, Limiter::line);
  EXPECT_EQ(too_late[1].waited_s, 0.0);  // it came while the machine braked
  const auto stalls = run({piece_row(10), piece_row(80)}, {{}, 0.01, 0.0}, pieces);
  EXPECT_NEAR(stalls[1].waited_s, 0.2, 1e-12);
}

TEST(Execution, ABufferTooShortForTheFeedIsReported) {
  // 0.1 mm a block, three of them known: 2·1000·0.3 = 600 mm²/s² at the most, of 10,000.
  PieceArrays pieces;
  for (int i = 0; i < 500; ++i) pieces.push_back({0.1, 1e4, kNoLimit, 1000});
  const Rows rows(500, piece_row(1));
  const auto ran = run(rows, {{0, 3}, 1e-6, 0.0}, pieces);
  for (std::size_t i = 200; i < 300; ++i) {
    ASSERT_LE(ran[i].end2, 600 + 1e-6);
    ASSERT_TRUE(ran[i].limiter == Limiter::buffer || ran[i + 1].limiter == Limiter::buffer) << i;
  }
}

TEST(Execution, IsThePlanWhereEverythingIsKnown) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  PieceArrays pieces;
  for (int i = 0; i < 3000; ++i)
    pieces.push_back({0.01 + unit(random), 1e3 + 1e4 * unit(random), 1e4 * unit(random), 300 + 1000 * unit(random)});
  SpeedPlan plan;
  plan_path(pieces, {}, plan);
  const auto ran = run(Rows(3000, piece_row(0)), {}, pieces);
  for (std::size_t i = 0; i < ran.size(); ++i) ASSERT_EQ(ran[i].duration_s, plan.duration_s[i]) << i;
}

}  // namespace
}  // namespace dripfeed::timing
