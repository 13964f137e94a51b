// Fits whose answer is known, and the conditions that every solution with bounds at zero meets.
#include "checks/timing/cost_fit.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace dripfeed::timing {
namespace {

TEST(CostFit, FindsTheModelThatMadeTheRows) {
  const ir::CostModel model{.block_ms = 1.2,
                            .number_read_ms = 0.3,
                            .named_read_ms = 0.7,
                            .operator_ms = 0.05,
                            .function_ms = 0.6,
                            .origin = {}};
  std::vector<CostRow> rows;
  std::mt19937 random(3);
  for (int i = 0; i < 24; ++i) {
    ir::ComputeCounts counts;
    for (const ir::CostTerm& term : ir::kCostTerms) counts.*term.count = static_cast<std::uint32_t>(random() % 9);
    counts.blocks += 1;
    rows.push_back({counts, ir::compute_ms(model, counts)});
  }
  const auto fit = fit_cost(rows);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->model.block_ms, 1.2, 1e-8);
  EXPECT_NEAR(fit->model.number_read_ms, 0.3, 1e-8);
  EXPECT_NEAR(fit->model.named_read_ms, 0.7, 1e-8);
  EXPECT_NEAR(fit->model.operator_ms, 0.05, 1e-8);
  EXPECT_NEAR(fit->model.function_ms, 0.6, 1e-8);
  EXPECT_LT(fit->worst_share, 1e-8);
}

TEST(CostFit, SaysWhatItCannotFit) {
  EXPECT_FALSE(fit_cost({}));
  EXPECT_FALSE(fit_cost(std::vector<CostRow>{{{.blocks = 1}, 0.0}}));
  EXPECT_FALSE(fit_cost(std::vector<CostRow>{{{.blocks = 1}, std::nan("")}}));
  EXPECT_FALSE(fit_cost(std::vector<CostRow>{{{}, 1.0}}));
  // Blocks and reads always together: one of them takes it all.
  const auto together =
      fit_cost(std::vector<CostRow>{{{.blocks = 1, .number_reads = 1}, 2.0}, {{.blocks = 3, .number_reads = 3}, 6.0}});
  ASSERT_TRUE(together);
  EXPECT_NEAR(together->model.block_ms + together->model.number_read_ms, 2.0, 1e-9);
  EXPECT_FALSE(together->is_determined[0] && together->is_determined[1]);
}

// Two measurements of the same thing: the model lies at their geometric mean, and the spread says how far they are off.
TEST(CostFit, TakesTheMiddleOfRatios) {
  const auto fit = fit_cost(std::vector<CostRow>{{{.blocks = 1}, 1.0}, {{.blocks = 1}, 4.0}});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->model.block_ms, 2.0, 1e-6);
  EXPECT_NEAR(fit->model.spread, std::exp(2 * std::sqrt(2 * std::log(2.0) * std::log(2.0))), 1e-6);
  EXPECT_EQ(fit->model.source, ir::CostSource::calibrated);
}

// No step in any direction that is free makes the sum smaller.
TEST(LogLeastSquares, IsALowestPlace) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.01, 1);
  for (int seed = 0; seed < 300; ++seed) {
    const std::size_t columns = 1 + random() % 5;
    const std::size_t rows = columns + 1 + random() % 8;
    std::vector<double> a(columns * rows), b(rows), weights(rows);
    for (std::vector<double>* all : {&a, &b, &weights})
      for (double& one : *all) one = unit(random);
    const auto sum_at = [&](const std::vector<double>& x) {
      double sum = 0.0;
      for (std::size_t r = 0; r < rows; ++r) {
        double predicted = 0.0;
        for (std::size_t j = 0; j < columns; ++j) predicted += a[r * columns + j] * x[j];
        sum += weights[r] * std::log(predicted / b[r]) * std::log(predicted / b[r]);
      }
      return sum;
    };
    const auto x = log_least_squares(a, b, weights, columns);
    const double lowest = sum_at(x);
    for (std::size_t j = 0; j < columns; ++j) {
      for (const double step : {1e-4, -1e-4}) {
        auto moved = x;
        moved[j] = std::max(0.0, x[j] + step);
        ASSERT_GE(sum_at(moved), lowest - 1e-9) << seed << ' ' << j;
      }
    }
  }
}

TEST(NonNegativeLeastSquares, MeetsTheConditionsOfKarushKuhnAndTucker) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(-1, 1);
  int bounded = 0;
  for (int seed = 0; seed < 3000; ++seed) {
    const std::size_t columns = 1 + random() % 6;
    const std::size_t count = columns + random() % 8;
    std::vector<double> a(columns * count), b(count);
    for (double& one : a) one = unit(random);
    for (double& one : b) one = unit(random);
    const auto x = non_negative_least_squares(a, b, columns);
    std::vector<double> gradient(columns, 0.0);  // A'·(A·x - b)
    for (std::size_t r = 0; r < count; ++r) {
      double rest = -b[r];
      for (std::size_t j = 0; j < columns; ++j) rest += a[r * columns + j] * x[j];
      for (std::size_t j = 0; j < columns; ++j) gradient[j] += a[r * columns + j] * rest;
    }
    for (std::size_t j = 0; j < columns; ++j) {
      ASSERT_GE(x[j], 0.0);
      if (x[j] > 0) {
        ASSERT_NEAR(gradient[j], 0.0, 1e-6) << seed;
      } else {
        ASSERT_GE(gradient[j], -1e-6) << seed;
        ++bounded;
      }
    }
  }
  EXPECT_GT(bounded, 1000);
}

}  // namespace
}  // namespace dripfeed::timing
