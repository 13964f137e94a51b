// The 810D's cost model against the paper that it is fitted to.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/text/number.h"
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
    fmt::print("{:<28} measured {:>6} ms, model {:>6} ms, {:>5} %\n", one.what,
               text::format_fixed(one.row.measured_ms, 2), text::format_fixed(predicted, 2),
               text::format_fixed(100 * fit.residual_ms[i] / one.row.measured_ms, 1));
    EXPECT_LE(std::fabs(fit.residual_ms[i]), 0.03 * one.row.measured_ms) << one.what;
  }
  const ir::CostModel& m = fit.model;
  fmt::print("block {}, R {}, LUD {}, operator {}, function {} ms\n", text::format_fixed(m.block_ms, 3),
             text::format_fixed(m.number_read_ms, 3), text::format_fixed(m.named_read_ms, 3),
             text::format_fixed(m.operator_ms, 3), text::format_fixed(m.function_ms, 3));
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
  fmt::print("table 5, differences to WHILE: IF GOTO measured {} model {}, REPEAT {} {} ms\n",
             text::format_fixed(paper::kIfGoto_ms - paper::kWhile_ms, 2), text::format_fixed(if_goto - while_do, 2),
             text::format_fixed(paper::kRepeat_ms - paper::kWhile_ms, 2), text::format_fixed(repeat - while_do, 2));
  // The paper's loops differ by 0.36 ms at the most, the model's by one block at the most: the model has no figure for
  // what a jump costs, and says the wrong sign for WHILE against the others.
  EXPECT_LE(std::fabs((if_goto - while_do) - (paper::kIfGoto_ms - paper::kWhile_ms)), 2 * m.block_ms);
  EXPECT_EQ(if_goto, repeat);
  // A call: the block of the call and that of the return, of what the paper measured.
  const double call = ir::compute_ms(m, {.blocks = 2});
  fmt::print("table 6, a call: measured {} model {} ms\n",
             text::format_fixed(paper::kWithCall_ms - paper::kWithoutCall_ms, 2), text::format_fixed(call, 2));
  EXPECT_GT(call, 0.0);
  EXPECT_LT(call, paper::kWithCall_ms - paper::kWithoutCall_ms);
}

}  // namespace
}  // namespace dripfeed
