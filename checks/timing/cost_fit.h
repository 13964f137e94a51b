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

struct CostFit {
  ir::CostModel model;  // `measured`; its origin is the caller's to say
  // Of each row: predicted - measured, ms, and the worst of them as a share of the measured.
  std::vector<double> residual_ms;
  double worst_share = 0.0;
  // By figure in the order of CostModel: above zero. One that the rows do not tell apart from others is not.
  std::array<bool, 5> is_determined{};
};

// Each row counts by its relative error. Errors: no row, a time that is not above zero, rows that determine nothing.
std::expected<CostFit, std::string> fit_cost(std::span<const CostRow> rows);

// The x >= 0 that makes |A·x - b| smallest (C. L. Lawson, R. J. Hanson, "Solving Least Squares Problems", chapter 23).
// `a`: row after row, columns · rows entries. A column that depends on others that are in the solution stays 0.
std::vector<double> non_negative_least_squares(std::span<const double> a, std::span<const double> b,
                                               std::size_t columns);

}  // namespace dripfeed::timing
