// The active-set method: variables enter the passive set (those free to be above zero) one by one, by the steepest
// descent; where the least-squares solution over the set would push one below zero, the step ends where that one gets
// to zero, and it leaves. The systems have a dozen unknowns: normal equations, after the columns were scaled, will do.
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
bool solve_passive(std::span<const double> a, std::span<const double> b, std::vector<double>& x,
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

}  // namespace

std::vector<double> non_negative_least_squares(std::span<const double> a, std::span<const double> b,
                                               std::size_t columns) {
  if (columns == 0) return {};
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
    if (!solve_passive(scaled, b, x, passive)) {
      refused[best] = true;
      passive = before;
    }
  }
  for (std::size_t j = 0; j < columns; ++j) x[j] *= scale[j];
  return x;
}

// Newton's method of Gauss: ln(p / b) is about ln(p0 / b) + (p - p0) / p0 about the last x, where p = A·x. That is
// linear in x, and its step is shortened until the sum falls, and as long as it falls further.
std::vector<double> log_least_squares(std::span<const double> a, std::span<const double> b,
                                      std::span<const double> weights, std::size_t columns) {
  constexpr int kRounds = 200;
  constexpr double kLeastRatio = 1e-6;  // of a row that nothing in x has a share in
  const std::size_t rows = b.size();
  const auto ratios_of = [&](const std::vector<double>& x) {
    std::vector<double> ratios(rows, 0.0);
    for (std::size_t i = 0; i < a.size(); ++i) ratios[i / columns] += a[i] * x[i % columns] / b[i / columns];
    for (double& ratio : ratios) ratio = std::max(ratio, kLeastRatio);
    return ratios;
  };
  const auto sum_of = [&](const std::vector<double>& ratios) {
    double sum = 0.0;
    for (std::size_t r = 0; r < rows; ++r) sum += weights[r] * std::log(ratios[r]) * std::log(ratios[r]);
    return sum;
  };
  std::vector<double> scaled(a.size());
  std::vector<double> wanted(rows);
  const auto solve_about = [&](const std::vector<double>& ratios) {
    for (std::size_t r = 0; r < rows; ++r) {
      const double weight = std::sqrt(weights[r]);
      for (std::size_t j = 0; j < columns; ++j)
        scaled[r * columns + j] = weight * a[r * columns + j] / (b[r] * ratios[r]);
      wanted[r] = weight * (1.0 - std::log(ratios[r]));
    }
    return non_negative_least_squares(scaled, wanted, columns);
  };
  std::vector<double> x = solve_about(std::vector<double>(rows, 1.0));
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<double> ratios = ratios_of(x);
    const std::vector<double> goal = solve_about(ratios);
    const auto at = [&](double step) {
      std::vector<double> next(columns);
      for (std::size_t j = 0; j < columns; ++j) next[j] = std::max(0.0, x[j] + step * (goal[j] - x[j]));
      return next;
    };
    const auto sum_after = [&](double step) { return sum_of(ratios_of(at(step))); };
    const double before = sum_of(ratios);
    double step = 1.0;
    double sum = sum_after(step);
    while (sum >= before && step > kSmall) sum = sum_after(step /= 2.0);
    if (sum >= before) break;
    // The sum is no parabola: half of a step that is good may be better.
    for (double half = sum_after(step / 2.0); half < sum && step > kSmall; half = sum_after(step / 2.0)) {
      step /= 2.0;
      sum = half;
    }
    x = at(step);
  }
  return x;
}

double spread_of(std::span<const double> ratios, std::size_t figures) {
  double sum = 0.0;
  for (const double ratio : ratios) sum += std::log(ratio) * std::log(ratio);
  const std::size_t freedom = ratios.size() > figures ? ratios.size() - figures : 1;
  return std::exp(2.0 * std::sqrt(sum / static_cast<double>(freedom)));
}

std::expected<CostFit, std::string> fit_cost(std::span<const CostRow> rows) {
  constexpr std::size_t kColumns = ir::kCostTerms.size();
  if (rows.empty()) return std::unexpected("there is no measured row");
  std::vector<double> a;
  std::vector<double> b;
  for (const CostRow& row : rows) {
    if (!(row.measured_ms > 0.0) || !std::isfinite(row.measured_ms))
      return std::unexpected("a measured time is not above zero");
    for (const ir::CostTerm& term : ir::kCostTerms) a.push_back(row.counts.*term.count);
    b.push_back(row.measured_ms);
  }
  const std::vector<double> x = log_least_squares(a, b, std::vector<double>(b.size(), 1.0), kColumns);
  if (std::ranges::all_of(x, [](double one) { return one == 0.0; }))
    return std::unexpected("the measured rows determine no figure");
  CostFit fit;
  fit.model.source = ir::CostSource::calibrated;
  for (std::size_t j = 0; j < kColumns; ++j) {
    fit.model.*ir::kCostTerms[j].ms = x[j];
    fit.is_determined[j] = x[j] > 0.0;
  }
  std::vector<double> ratios;
  for (const CostRow& row : rows) {
    const double predicted = ir::compute_ms(fit.model, row.counts);
    fit.residual_ms.push_back(predicted - row.measured_ms);
    fit.worst_share = std::max(fit.worst_share, std::fabs(fit.residual_ms.back()) / row.measured_ms);
    if (predicted > 0.0) ratios.push_back(predicted / row.measured_ms);
  }
  const auto figures = static_cast<std::size_t>(std::ranges::count(fit.is_determined, true));
  fit.model.spread = std::max(kLeastSpread, spread_of(ratios, figures));
  return fit;
}

}  // namespace dripfeed::timing
