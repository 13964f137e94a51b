// Fits whose answer is known, and the conditions that every solution with bounds at zero meets.
#include "checks/timing/cost_fit.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace dripfeed::timing {
namespace {

TEST(CostFit, FindsTheModelThatMadeTheRows) {
  const ir::CostModel model{1.2, 0.3, 0.7, 0.05, 0.6, true, {}};
  std::vector<CostRow> rows;
  std::mt19937 random(3);
  for (int i = 0; i < 12; ++i) {
    const ir::ComputeCounts counts{1 + static_cast<std::uint32_t>(random() % 9),
                                   static_cast<std::uint32_t>(random() % 9), static_cast<std::uint32_t>(random() % 9),
                                   static_cast<std::uint32_t>(random() % 9), static_cast<std::uint32_t>(random() % 9)};
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
