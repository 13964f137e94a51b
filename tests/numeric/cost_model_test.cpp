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

// What a loop of each kind adds to its body. The body is the same in all rows and falls out of the differences.
//
// Table 5. IF…GOTOB, REPEAT…UNTIL and WHILE each compute one condition a round; FOR counts by itself, and the printed
// bodies count, too. As blocks are counted here WHILE has one more than IF…GOTOB and REPEAT, its ENDWHILE, and the
// model says that it is a block's millisecond slower. The paper finds it 0.36 ms faster, and all four within that: less
// than half a block. So this control charges no block for the keyword that only jumps back, and what remains (a label
// that is searched, perhaps) is no matter of the five constants. The count stays: it is right on the safe side, and the
// table is too coarse to tell ENDWHILE from ENDFOR.
TEST(CostModel, Table5AsDifferences) {
  const ir::CostModel m = fitted().model;
  const double if_goto = ir::compute_ms(m, {.blocks = 1, .number_reads = 1, .operators = 1});   // IF R1<1000 GOTOB
  const double while_do = ir::compute_ms(m, {.blocks = 2, .number_reads = 1, .operators = 1});  // WHILE, ENDWHILE
  const double repeat = ir::compute_ms(m, {.blocks = 1, .number_reads = 1, .operators = 1});    // UNTIL
  const double unclosed = ir::compute_ms(m, {.blocks = 1, .number_reads = 1, .operators = 1});  // WHILE alone
  const auto row = [](const char* what, double measured, double model, double without) {
    fmt::print("table 5, {:<18} measured {:>5} model {:>5}, ENDWHILE for nothing {:>5} ms\n", what,
               text::format_fixed(measured, 2), text::format_fixed(model, 2), text::format_fixed(without, 2));
  };
  row("IF GOTO less WHILE", paper::kIfGoto_ms - paper::kWhile_ms, if_goto - while_do, if_goto - unclosed);
  row("REPEAT less WHILE", paper::kRepeat_ms - paper::kWhile_ms, repeat - while_do, repeat - unclosed);
  EXPECT_EQ(if_goto, repeat);
  EXPECT_LT(std::fabs(paper::kIfGoto_ms - paper::kRepeat_ms), 0.05);  // and the paper finds them alike
  for (const double one : {paper::kIfGoto_ms, paper::kRepeat_ms, paper::kFor_ms}) {
    EXPECT_LT(one - paper::kWhile_ms, 0.5 * m.block_ms);  // no block more or less in any of them
    EXPECT_NEAR(one - paper::kWhile_ms, if_goto - unclosed, 0.4);
  }
  EXPECT_NEAR(if_goto - while_do, -m.block_ms, 1e-9);  // as counted: the wrong sign, by one block
}

// Table 6 gives 6.90 ms with a call and 1.48 ms without. The latter is to the digit what table 1 gives for one line
// R2=R1+1: so it is a line's time, not a loop's (four printed lines alone are 5.4 ms), and 6.90 - 1.48 is no call's
// cost unless both are of the same. Two readings: 6.90 ms is a round with the four printed lines, then call, return and
// FOR share what the lines leave of it; or it is a line's time, too, then a call costs 5.42 ms times the lines, which
// are not printed whole. The model's two blocks lie between.
TEST(CostModel, Table6AsItCanBeRead) {
  const ir::CostModel m = fitted().model;
  const double line = ir::compute_ms(m, {.blocks = 1, .number_reads = 1, .operators = 1});  // R2=R1+1
  const double printed = ir::compute_ms(m, {.blocks = 1}) + 3 * line;                       // R1=1, three such lines
  const double call = ir::compute_ms(m, {.blocks = 2});                                     // CALL, M17
  const double round = printed + call;
  const double of_a_line = paper::kWithCall_ms - paper::kWithoutCall_ms;
  fmt::print("table 6: without {} ms, model's line {}; four lines {}, with call and return {}, measured {}\n",
             text::format_fixed(paper::kWithoutCall_ms, 2), text::format_fixed(line, 2), text::format_fixed(printed, 2),
             text::format_fixed(round, 2), text::format_fixed(paper::kWithCall_ms, 2));
  fmt::print("a call by the first reading {}, by the second {} or more, model {} ms\n",
             text::format_fixed(paper::kWithCall_ms - printed, 2), text::format_fixed(4 * of_a_line, 2),
             text::format_fixed(call, 2));
  EXPECT_NEAR(paper::kWithoutCall_ms, line, 0.03 * line);
  EXPECT_GT(printed, 3 * paper::kWithoutCall_ms);
  EXPECT_NEAR(round, paper::kWithCall_ms, 0.1 * paper::kWithCall_ms);
  EXPECT_GT(call, paper::kWithCall_ms - printed);
  EXPECT_LT(call, 4 * of_a_line);
}

}  // namespace
}  // namespace dripfeed
