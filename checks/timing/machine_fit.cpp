// Gauss and Newton with differences, damped: two unknowns, smooth but for where another limit takes over.
#include "checks/timing/machine_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dripfeed::timing {

namespace {

constexpr double kStep = 0.02;
constexpr double kFarthest = 1.6;  // of a logarithm: a factor of 5
constexpr int kRounds = 25;

using Logs = std::array<double, 2>;

std::vector<double> errors_at(std::span<const MeasuredRun> runs, const Logs& at) {
  std::vector<double> errors;
  for (const MeasuredRun& run : runs)
    errors.push_back(std::log(run.predict({std::exp(at[0]), std::exp(at[1])}) / run.measured_s));
  return errors;
}
double size_of(const std::vector<double>& errors) {
  double sum = 0.0;
  for (const double one : errors) sum += one * one;
  return sum;
}
std::vector<double> shares(const std::vector<double>& errors) {
  std::vector<double> out;
  for (const double one : errors) out.push_back(std::exp(one) - 1.0);
  return out;
}

}  // namespace

std::expected<MachineFit, std::string> fit_machine(std::span<const MeasuredRun> runs) {
  if (runs.empty()) return std::unexpected("there is no measured run");
  for (const MeasuredRun& run : runs) {
    if (!(run.measured_s > 0.0) || !std::isfinite(run.measured_s))
      return std::unexpected("a measured time is not above zero");
  }
  Logs at{};
  std::vector<double> errors = errors_at(runs, at);
  MachineFit fit{{}, shares(errors), {}};
  double damping = 1e-6;
  for (int round = 0; round < kRounds; ++round) {
    std::array<std::vector<double>, 2> slopes;
    for (std::size_t k = 0; k < 2; ++k) {
      Logs aside = at;
      aside[k] += kStep;
      slopes[k] = errors_at(runs, aside);
      for (std::size_t i = 0; i < runs.size(); ++i) slopes[k][i] = (slopes[k][i] - errors[i]) / kStep;
    }
    double aa = 0, bb = 0, ab = 0, ae = 0, be = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      aa += slopes[0][i] * slopes[0][i];
      bb += slopes[1][i] * slopes[1][i];
      ab += slopes[0][i] * slopes[1][i];
      ae += slopes[0][i] * errors[i];
      be += slopes[1][i] * errors[i];
    }
    if (round == 0 && (aa < 1e-6 || bb < 1e-6 || aa * bb - ab * ab < 1e-6 * aa * bb))
      return std::unexpected("the runs do not separate acceleration from computing");
    aa += damping;
    bb += damping;
    const double determinant = aa * bb - ab * ab;
    Logs next = {std::clamp(at[0] - (bb * ae - ab * be) / determinant, -kFarthest, kFarthest),
                 std::clamp(at[1] - (aa * be - ab * ae) / determinant, -kFarthest, kFarthest)};
    const std::vector<double> found = errors_at(runs, next);
    if (size_of(found) < size_of(errors)) {
      at = next;
      errors = found;
      damping = std::max(1e-9, damping * 0.1);
      if (size_of(errors) < 1e-12) break;
    } else {
      damping = std::max(1e-4, damping * 10.0);
      if (damping > 1e3) break;
    }
  }
  fit.factors = {std::exp(at[0]), std::exp(at[1])};
  fit.after_share = shares(errors);
  return fit;
}

}  // namespace dripfeed::timing
