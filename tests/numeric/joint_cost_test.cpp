// One cost model for all that the paper measured: its tables and its four programs (G. Nikiel, "Optimization of
// execution speed of the CNC parametric part programs"). The figures that tables 1 to 4 alone give are 2.2 to 5.3 times
// too high at the programs. What reconciles them:
//
// - A round of a table's test program costs a fixed time besides its statements. Ten statements share it in tables 1 to
//   3; in table 4, whose one statement is a round, it is most of the time. What it is (the timer is read, the reading
//   ahead stops for it) the paper does not say. It is not a part of the cost model, because the programs have no room
//   for it: a point of the fourth takes 9 ms with ten blocks.
// - Variables with names cost for reading and for writing. Reading R parameters and operators cost next to nothing: the
//   third program has 122 and 88 of them in 16 ms. Blocks are what costs, which is the paper's own fourth rule.
//
// Figures: those, none below zero, whose worst ratio over all twelve is the smallest (what is left is the model's
// error, not chance, so no other row may hide a row). Jumps and calls come from tables 5 and 6.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/compile/render/compute_cost.h"
#include "dialects/text/number.h"
#include "tests/numeric/paper_times.h"
#include "tests/numeric/seal_ring.h"

namespace dripfeed {
namespace {

using seal_ring::preset;

// What a point of a program computes, the first one left out: with it comes the set-up. Sum and number of points.
std::pair<ir::ComputeCounts, double> counts_of(const char* program) {
  const auto points = seal_ring::points_of(program);
  ir::ComputeCounts sum;
  for (std::size_t i = 1; i < points.size(); ++i)
    for (const ir::CostTerm& term : ir::kCostTerms) sum.*term.count += points[i].compute.*term.count;
  return {sum, static_cast<double>(points.size() - 1)};
}

// Of a round of each loop of table 5, its body left out. GOTOB and UNTIL go back by a jump.
constexpr ir::ComputeCounts kIfGoto = {.blocks = 1, .number_reads = 1, .operators = 1, .jumps = 1};
constexpr ir::ComputeCounts kRepeat = kIfGoto;
constexpr ir::ComputeCounts kWhile = {.blocks = 1, .number_reads = 1, .operators = 1, .rounds = 1};
constexpr ir::ComputeCounts kFor = {
    .blocks = 1, .named_reads = 1, .named_writes = 1, .operators = 1, .rounds = 1};  // PP is an INT of the program

// How much slower a jump back is than the end of a WHILE: IF … GOTOB and REPEAT, next to WHILE, with the same block.
constexpr double kJumpLessRound_ms = (paper::kIfGoto_ms + paper::kRepeat_ms) / 2 - paper::kWhile_ms;

struct Figure {
  std::string what;
  double measured_ms = 0.0;  // of a point or of a round
  std::vector<double> row;   // of what is fitted
  double share = 1.0;        // of measured_ms that the paper prints: a statement's of a round
};

// Columns: block, R read or written, LUD read or written, operator, function, jump or round, a table's round.
constexpr std::size_t kColumns = 7;
std::vector<double> row_of(const ir::ComputeCounts& n, double times, double table_rounds) {
  std::vector<double> row;
  for (const std::uint32_t count : {n.blocks, n.number_reads + n.number_writes, n.named_reads + n.named_writes,
                                    n.operators, n.functions, n.jumps + n.rounds})
    row.push_back(count * times);
  row.push_back(table_rounds);
  return row;
}

std::vector<Figure> twelve_figures() {
  std::vector<Figure> figures;
  for (const paper::PaperRow& one : paper::kTables1To4) {
    const double times = one.a_round;
    figures.push_back({one.what, one.row.measured_ms * times, row_of(one.row.counts, times, 1), 1 / times});
  }
  for (std::size_t k = 0; k < seal_ring::kPrograms.size(); ++k) {
    const auto [sum, points] = counts_of(seal_ring::kPrograms[k]);
    // What table 5 gives for its jumps is taken off before the fit.
    const double known_ms = kJumpLessRound_ms * sum.jumps / points;
    figures.push_back({fmt::format("a point of {}", seal_ring::kPrograms[k]), paper::kSealRing_ms[k] - known_ms,
                       row_of(sum, 1 / points, 0)});
  }
  return figures;
}

std::vector<double> ratios_of(const std::vector<Figure>& figures, const std::vector<double>& x) {
  std::vector<double> ratios;
  for (const Figure& figure : figures) {
    double ms = 0.0;
    for (std::size_t j = 0; j < kColumns; ++j) ms += figure.row[j] * x[j];
    ratios.push_back(ms / figure.measured_ms);
  }
  return ratios;
}

double worst_of(const std::vector<double>& ratios) {
  double worst = 1.0;
  for (const double ratio : ratios) worst = std::max({worst, ratio, 1 / ratio});
  return worst;
}

// C. L. Lawson: least squares whose weights grow where a row is off come to the fit whose worst row is the best.
std::vector<double> fit_worst(const std::vector<Figure>& figures, int rounds) {
  std::vector<double> a;
  std::vector<double> b;
  for (const Figure& figure : figures) {
    a.insert(a.end(), figure.row.begin(), figure.row.end());
    b.push_back(figure.measured_ms);
  }
  std::vector<double> weights(b.size(), 1.0 / static_cast<double>(b.size()));
  std::vector<double> best = timing::log_least_squares(a, b, weights, kColumns);
  for (int i = 0; i < rounds; ++i) {
    const std::vector<double> x = timing::log_least_squares(a, b, weights, kColumns);
    const std::vector<double> ratios = ratios_of(figures, x);
    if (worst_of(ratios) < worst_of(ratios_of(figures, best))) best = x;
    double sum = 0.0;
    for (std::size_t r = 0; r < b.size(); ++r) sum += weights[r] *= std::fabs(std::log(ratios[r]));
    for (double& weight : weights) weight /= sum;
  }
  return best;
}

std::vector<double> figures_of(const ir::CostModel& m, double table_round_ms) {
  return {m.block_ms, m.number_read_ms, m.named_read_ms, m.operator_ms, m.function_ms, m.round_ms, table_round_ms};
}

void print_figures(const char* what, const std::vector<double>& x) {
  fmt::print("{}: block {}, R {}, LUD {}, operator {}, function {}, loop {}, a table's round {} ms\n", what,
             text::format_fixed(x[0], 3), text::format_fixed(x[1], 3), text::format_fixed(x[2], 3),
             text::format_fixed(x[3], 3), text::format_fixed(x[4], 3), text::format_fixed(x[5], 3),
             text::format_fixed(x[6], 2));
}

TEST(JointCost, ThePresetIsTheBestFitOfAllTwelveFigures) {
  const auto figures = twelve_figures();
  const auto squares = fit_worst(figures, 0);
  const auto best = fit_worst(figures, 3000);
  print_figures("least squares", squares);
  print_figures("best worst row", best);
  const ir::CostModel m = preset();
  EXPECT_EQ(m.number_read_ms, m.number_write_ms);
  EXPECT_EQ(m.named_read_ms, m.named_write_ms);
  EXPECT_NEAR(m.jump_ms, m.round_ms + kJumpLessRound_ms, 0.005);
  const auto x = figures_of(m, best[6]);
  print_figures("the preset", x);
  const auto ratios = ratios_of(figures, x);
  for (std::size_t r = 0; r < figures.size(); ++r) {
    const double printed = figures[r].measured_ms * figures[r].share;
    const double predicted = printed * ratios[r];
    fmt::print("{:<28} measured {:>6} ms, model {:>6} ms ({} to {}), ratio {}\n", figures[r].what,
               text::format_fixed(printed, 2), text::format_fixed(predicted, 2),
               text::format_fixed(predicted / m.spread, 2), text::format_fixed(predicted * m.spread, 2),
               text::format_fixed(ratios[r], 2));
    EXPECT_LT(printed, predicted * m.spread) << figures[r].what;
    EXPECT_GT(printed, predicted / m.spread) << figures[r].what;
  }
  fmt::print("worst ratio {} (least squares {}), spread {}\n", text::format_fixed(worst_of(ratios), 3),
             text::format_fixed(worst_of(ratios_of(figures, squares)), 3),
             text::format_fixed(timing::spread_of(ratios, 4), 3));
  EXPECT_LE(worst_of(ratios), 1.3);
  EXPECT_LE(worst_of(ratios), 1.005 * worst_of(ratios_of(figures, best)));
  EXPECT_NEAR(m.spread, timing::spread_of(ratios, 4), 0.02);  // four figures are above zero
  EXPECT_EQ(m.source, ir::CostSource::paper);
}

// As `dripfeed time` predicts it: with the jumps, the loop's round and the move's own block.
TEST(JointCost, OnlyTheFourthProgramMeetsTheLimit) {
  constexpr double kLimit_ms = 15.0;
  const ir::CostModel m = preset();
  double before = 1e9;
  for (std::size_t k = 0; k < seal_ring::kPrograms.size(); ++k) {
    const auto [sum, points] = counts_of(seal_ring::kPrograms[k]);
    const double predicted = ir::compute_ms(m, sum) / points;
    const double measured = paper::kSealRing_ms[k];
    fmt::print("{:<14} measured {:>3} ms a point, predicted {:>5} ({} to {}), ratio {};", seal_ring::kPrograms[k],
               text::format_fixed(measured, 0), text::format_fixed(predicted, 1),
               text::format_fixed(predicted / m.spread, 1), text::format_fixed(predicted * m.spread, 1),
               text::format_fixed(predicted / measured, 2));
    for (const ir::CostTerm& term : ir::kCostTerms)
      if (sum.*term.count > 0) fmt::print(" {} {}", term.name, text::format_fixed(sum.*term.count / points, 1));
    fmt::print("\n");
    EXPECT_LT(predicted, before);
    EXPECT_EQ(predicted <= kLimit_ms, k == 3);
    EXPECT_LT(measured, predicted * m.spread);
    EXPECT_GT(measured, predicted / m.spread);
    before = predicted;
  }
}

compile::ComputeCost run_of(const ir::ComputeCounts& counts) {
  compile::ComputeCost out{.total_ms = ir::compute_ms(preset(), counts)};
  for (std::size_t i = 0; i < out.counts.size(); ++i) out.counts[i] = counts.*ir::kCostTerms[i].count;
  return out;
}

// Table 5. The bodies are not printed whole ("…"), but are the same in all rows and fall out of the differences.
TEST(JointCost, Table5AsDifferences) {
  const ir::CostModel m = preset();
  const auto row = [&](const char* what, double measured, const ir::ComputeCounts& counts) {
    const double difference = measured - paper::kWhile_ms;
    const double predicted = ir::compute_ms(m, counts) - ir::compute_ms(m, kWhile);
    const compile::Saving less = compile::saving_between(run_of(counts), run_of(kWhile), m);
    fmt::print("table 5, {:<18} measured {:>5} ms, model {:>5} ms ({} to {})\n", what,
               text::format_fixed(difference, 2), text::format_fixed(predicted, 2),
               text::format_fixed(less.least_ms, 2), text::format_fixed(less.most_ms, 2));
    EXPECT_NEAR(less.ms, predicted, 1e-9) << what;
    EXPECT_GT(difference, less.least_ms) << what;
    EXPECT_LT(difference, less.most_ms) << what;
    EXPECT_NEAR(predicted, difference, 0.05) << what;  // as far as the same row of tables 1 and 2 differs
  };
  row("IF GOTO less WHILE", paper::kIfGoto_ms, kIfGoto);
  row("REPEAT less WHILE", paper::kRepeat_ms, kRepeat);
  row("FOR less WHILE", paper::kFor_ms, kFor);
  EXPECT_GT(ir::compute_ms(m, kIfGoto), ir::compute_ms(m, kFor));  // the paper's order: GOTO is the slowest, WHILE
  EXPECT_GT(ir::compute_ms(m, kFor), ir::compute_ms(m, kWhile));   // the fastest
  // Whole, with the ten statements that tables 1 to 3 are read with, and their fixed time a round.
  const auto best = fit_worst(twelve_figures(), 3000);
  const double body = ir::compute_ms(m, {.blocks = 10, .number_reads = 10, .number_writes = 10, .operators = 10});
  const double whole = body + ir::compute_ms(m, kWhile) + best[6];
  fmt::print("a round of WHILE with ten statements: measured {} ms, model {} ms\n",
             text::format_fixed(paper::kWhile_ms, 2), text::format_fixed(whole, 2));
  EXPECT_LT(std::fabs(std::log(whole / paper::kWhile_ms)), std::log(1.3));
}

// Table 6 gives 6.90 ms with a call and 1.48 ms without. The latter is to the digit what table 1 gives for a statement
// R2=R1+1, so both are of a statement, and a round with ten of them has one call: 54.2 ms. With the four statements
// that are printed it were 21.7.
TEST(JointCost, Table6AsADifference) {
  const ir::CostModel m = preset();
  const double measured = paper::kStatementsOfARound * (paper::kWithCall_ms - paper::kWithoutCall_ms);
  const double predicted = ir::compute_ms(m, {.blocks = 2, .calls = 1});  // CALL and M17
  fmt::print("table 6, a call: measured {} ms (ten statements; with four {}), model {} ms ({} to {})\n",
             text::format_fixed(measured, 1), text::format_fixed(measured * 0.4, 1), text::format_fixed(predicted, 1),
             text::format_fixed(predicted / m.spread, 1), text::format_fixed(predicted * m.spread, 1));
  EXPECT_NEAR(predicted, measured, 0.1);
}

}  // namespace
}  // namespace dripfeed
