// A cost model from measured times: least squares with no figure below zero.
#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <vector>

#include "dialects/ir/cost_model.h"

namespace dripfeed::timing {

// What was computed and how long the control took for it.
struct CostRow {
  ir::ComputeCounts counts;
  double measured_ms = 0.0;
};

// What the figures of a fit leave open even where they explain each row: a timer of whole ms, a control that is busy.
inline constexpr double kLeastSpread = 1.1;

struct CostFit {
  // Calibrated; its origin is the caller's to say. Its spread is that of two standard deviations of the rows' ratios.
  ir::CostModel model;
  // Of each row: predicted - measured, ms, and the worst of them as a share of the measured.
  std::vector<double> residual_ms;
  double worst_share = 0.0;
  // By ir::kCostTerms: above zero. One that the rows do not distinguish from others is not.
  std::array<bool, ir::kCostTerms.size()> is_determined{};
};

// Least squares on the logarithms of predicted by measured: a row counts by its ratio, whatever its size. Errors: no
// row, a time that is not above zero, rows that determine nothing.
std::expected<CostFit, std::string> fit_cost(std::span<const CostRow> rows);

// The x >= 0 for which ln(A·x / b) is smallest in the sum of squares, each times its row's weight. `a` as below; every
// b > 0. A weight for each row.
std::vector<double> log_least_squares(std::span<const double> a, std::span<const double> b,
                                      std::span<const double> weights, std::size_t columns);

// exp of two standard deviations of ln(ratio), with as many degrees of freedom as ratios less `figures`; at least one.
double spread_of(std::span<const double> ratios, std::size_t figures);

// The x >= 0 that makes |A·x - b| smallest (C. L. Lawson, R. J. Hanson, "Solving Least Squares Problems", chapter 23).
// `a`: row after row, columns · rows entries. A column that depends on others that are in the solution stays 0.
std::vector<double> non_negative_least_squares(std::span<const double> a, std::span<const double> b,
                                               std::size_t columns);

}  // namespace dripfeed::timing
