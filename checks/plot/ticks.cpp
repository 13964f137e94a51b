// Where an axis has its numbers.
#include <algorithm>
#include <cmath>

#include "checks/plot/plot.h"

namespace dripfeed::plot {

std::vector<double> ticks(double low, double high, int most) {
  const double width = high - low;
  if (!(width > 0.0) || !std::isfinite(width)) return {};
  const double least = width / std::max(2, most);
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10.0 * decade;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= least * (1.0 - 1e-9)) {
      step = factor * decade;
      break;
    }
  }
  std::vector<double> all;
  const double slack = 1e-9 * step;
  const double first = std::ceil((low - slack) / step);
  // A width far below the ends' own size leaves no round values between them.
  if (!(step > 0.0) || !(low + step > low) || !(high - step < high)) return {};
  for (int i = 0; i <= 2 * std::max(2, most); ++i) {
    const double value = (first + i) * step;
    if (value > high + slack) break;
    all.push_back(value == 0.0 ? 0.0 : value);
  }
  while (all.size() > static_cast<std::size_t>(std::max(2, most))) all.pop_back();
  return all;
}

}  // namespace dripfeed::plot
