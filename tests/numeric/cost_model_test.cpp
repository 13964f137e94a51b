// The 810D's cost model against the paper that it is fitted to.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/numeric/paper_times.h"

namespace dripfeed {
namespace {

timing::CostFit fitted() {
  std::vector<timing::CostRow> rows;
  for (const auto& one : paper::kTables1To4) rows.push_back(one.row);
  const auto fit = timing::fit_cost(rows);
  EXPECT_TRUE(fit) << (fit ? "" : fit.error());
  return *fit;
}

TEST(CostModel, MeetsTables1To4WithinThreePercent) {
  const timing::CostFit fit = fitted();
  for (std::size_t i = 0; i < paper::kTables1To4.size(); ++i) {
    const auto& one = paper::kTables1To4[i];
    const double predicted = one.row.measured_ms + fit.residual_ms[i];
    std::printf("%-28s measured %6.2f ms, model %6.2f ms, %+5.1f %%\n", one.what, one.row.measured_ms, predicted,
                100 * fit.residual_ms[i] / one.row.measured_ms);
    EXPECT_LE(std::fabs(fit.residual_ms[i]), 0.03 * one.row.measured_ms) << one.what;
  }
  const ir::CostModel& m = fit.model;
  std::printf("block %.3f, R %.3f, LUD %.3f, operator %.3f, function %.3f ms\n", m.block_ms, m.number_read_ms,
              m.named_read_ms, m.operator_ms, m.function_ms);
  for (const bool one : fit.is_determined) EXPECT_TRUE(one);
}

// What a loop of each kind adds to its body. The body is the same in all rows and falls out of the differences: it is
// taken as three blocks R2=R1+1, nothing of it shows below.
TEST(CostModel, Tables5And6AsDifferences) {
  const ir::CostModel m = fitted().model;
  // R1=R1+1 counts in all but FOR, which counts by itself: one block, one read, one operator in each.
  const double if_goto = ir::compute_ms(m, {.blocks = 1, .number_reads = 1, .operators = 1});   // IF R1<1000 GOTOB
  const double while_do = ir::compute_ms(m, {.blocks = 2, .number_reads = 1, .operators = 1});  // WHILE, ENDWHILE
  const double repeat = ir::compute_ms(m, {.blocks = 1, .number_reads = 1, .operators = 1});    // UNTIL
  std::printf("table 5, differences to WHILE: IF GOTO measured %+.2f model %+.2f, REPEAT %+.2f %+.2f ms\n",
              paper::kIfGoto_ms - paper::kWhile_ms, if_goto - while_do, paper::kRepeat_ms - paper::kWhile_ms,
              repeat - while_do);
  // The paper's loops differ by 0.36 ms at the most, the model's by one block at the most: the model has no figure for
  // what a jump costs, and says the wrong sign for WHILE against the others.
  EXPECT_LE(std::fabs((if_goto - while_do) - (paper::kIfGoto_ms - paper::kWhile_ms)), 2 * m.block_ms);
  EXPECT_EQ(if_goto, repeat);
  // A call: the block of the call and that of the return, of what the paper measured.
  const double call = ir::compute_ms(m, {.blocks = 2});
  std::printf("table 6, a call: measured %.2f model %.2f ms\n", paper::kWithCall_ms - paper::kWithoutCall_ms, call);
  EXPECT_GT(call, 0.0);
  EXPECT_LT(call, paper::kWithCall_ms - paper::kWithoutCall_ms);
}

}  // namespace
}  // namespace dripfeed
