// Tables 1 to 4 of the paper alone: five figures explain them, and nothing else (tests/numeric/joint_cost_test.cpp has
// what they say of whole programs).
#include <algorithm>
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
  // A write goes with every block there: which of the two it is that costs, these rows do not show.
  for (std::size_t i = 0; i < ir::kCostTerms.size(); ++i) {
    if (fit.is_determined[i])
      fmt::print("{} {}\n", ir::kCostTerms[i].name, text::format_fixed(fit.model.*ir::kCostTerms[i].ms, 3));
  }
  EXPECT_EQ(std::ranges::count(fit.is_determined, true), 5);
}

}  // namespace
}  // namespace dripfeed
