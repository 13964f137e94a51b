// The active-set method: variables enter the passive set (those free to be above zero) one by one, by the steepest
// descent; where the least-squares solution over the set would push one below zero, the step ends where that one gets
// to zero, and it leaves. The systems have five unknowns: normal equations, after the columns were scaled, will do.
#include "checks/timing/cost_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dripfeed::timing {

namespace {

constexpr double kSmall = 1e-10;

// Solves the normal equations over the columns of `passive` by Gauss; empty when they are dependent.
std::vector<double> solve(std::span<const double> a, std::span<const double> b, std::size_t columns,
                          const std::vector<std::size_t>& passive) {
  const std::size_t n = passive.size();
  std::vector<std::vector<double>> m(n, std::vector<double>(n + 1, 0.0));
  for (std::size_t r = 0; r < b.size(); ++r) {
    for (std::size_t i = 0; i < n; ++i) {
      const double left = a[r * columns + passive[i]];
      for (std::size_t j = 0; j < n; ++j) m[i][j] += left * a[r * columns + passive[j]];
      m[i][n] += left * b[r];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < n; ++k) {
      if (std::fabs(m[k][i]) > std::fabs(m[pivot][i])) pivot = k;
    }
    if (std::fabs(m[pivot][i]) < kSmall) return {};
    std::swap(m[i], m[pivot]);
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i) continue;
      const double factor = m[k][i] / m[i][i];
      for (std::size_t j = i; j <= n; ++j) m[k][j] -= factor * m[i][j];
    }
  }
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = m[i][n] / m[i][i];
  return x;
}

// Steepest descent at x: A'·(b - A·x).
std::vector<double> descent(std::span<const double> a, std::span<const double> b, const std::vector<double>& x) {
  std::vector<double> w(x.size(), 0.0);
  for (std::size_t r = 0; r < b.size(); ++r) {
    double rest = b[r];
    for (std::size_t j = 0; j < x.size(); ++j) rest -= a[r * x.size() + j] * x[j];
    for (std::size_t j = 0; j < x.size(); ++j) w[j] += a[r * x.size() + j] * rest;
  }
  return w;
}

// Moves x towards the solution over the passive set until all of that is above zero. False: the set is dependent.
bool settle(std::span<const double> a, std::span<const double> b, std::vector<double>& x,
            std::vector<std::size_t>& passive) {
  for (;;) {
    const std::vector<double> s = solve(a, b, x.size(), passive);
    if (s.size() != passive.size()) return false;
    double step = 1.0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (s[i] <= 0.0) step = std::min(step, x[passive[i]] / (x[passive[i]] - s[i]));
    }
    for (std::size_t i = 0; i < s.size(); ++i) x[passive[i]] += step * (s[i] - x[passive[i]]);
    if (step >= 1.0) return true;
    std::erase_if(passive, [&](std::size_t j) {
      if (x[j] > kSmall) return false;
      x[j] = 0.0;
      return true;
    });
  }
}

std::array<double, 5> columns_of(const ir::ComputeCounts& n) {
  return {static_cast<double>(n.blocks), static_cast<double>(n.number_reads), static_cast<double>(n.named_reads),
          static_cast<double>(n.operators), static_cast<double>(n.functions)};
}

}  // namespace

std::vector<double> non_negative_least_squares(std::span<const double> a, std::span<const double> b,
                                               std::size_t columns) {
  // Columns of length one.
  std::vector<double> scale(columns, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) scale[i % columns] += a[i] * a[i];
  for (double& one : scale) one = one > 0.0 ? 1.0 / std::sqrt(one) : 0.0;
  std::vector<double> scaled(a.begin(), a.end());
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] *= scale[i % columns];

  std::vector<double> x(columns, 0.0);
  std::vector<std::size_t> passive;
  std::vector<bool> refused(columns, false);
  double size = 0.0;
  for (const double one : b) size += one * one;
  // Each round takes one in; the objective falls in every one, so that no set comes twice. The bound is for rounding.
  for (std::size_t round = 0; round < 3 * columns + 10; ++round) {
    const std::vector<double> w = descent(scaled, b, x);
    std::size_t best = columns;
    for (std::size_t j = 0; j < columns; ++j) {
      const bool is_in = std::ranges::find(passive, j) != passive.end();
      if (!is_in && !refused[j] && w[j] > kSmall * std::sqrt(size) && (best == columns || w[j] > w[best])) best = j;
    }
    if (best == columns) break;
    const auto before = passive;
    passive.push_back(best);
    if (!settle(scaled, b, x, passive)) {
      refused[best] = true;
      passive = before;
    }
  }
  for (std::size_t j = 0; j < columns; ++j) x[j] *= scale[j];
  return x;
}

std::expected<CostFit, std::string> fit_cost(std::span<const CostRow> rows) {
  constexpr std::size_t kColumns = 5;
  if (rows.empty()) return std::unexpected("there is no measured row");
  std::vector<double> a;
  std::vector<double> b;
  for (const CostRow& row : rows) {
    if (!(row.measured_ms > 0.0) || !std::isfinite(row.measured_ms))
      return std::unexpected("a measured time is not above zero");
    for (const double count : columns_of(row.counts)) a.push_back(count / row.measured_ms);
    b.push_back(1.0);
  }
  const std::vector<double> x = non_negative_least_squares(a, b, kColumns);
  if (std::ranges::all_of(x, [](double one) { return one == 0.0; }))
    return std::unexpected("the measured rows determine no figure");
  CostFit fit;
  fit.model = {x[0], x[1], x[2], x[3], x[4], true, {}};
  for (std::size_t j = 0; j < kColumns; ++j) fit.is_determined[j] = x[j] > 0.0;
  for (const CostRow& row : rows) {
    fit.residual_ms.push_back(ir::compute_ms(fit.model, row.counts) - row.measured_ms);
    fit.worst_share = std::max(fit.worst_share, std::fabs(fit.residual_ms.back()) / row.measured_ms);
  }
  return fit;
}

}  // namespace dripfeed::timing
