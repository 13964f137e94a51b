// Arithmetic of ranges: what all results surely lie in. Each is widened by a few units in the last place, so that
// rounding cannot make it too narrow. For those files that prove something.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "dialects/curves/point.h"

namespace dripfeed::family {

using curves::Range;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr Range kAnything{-kInfinity, kInfinity};
inline constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();

inline Range widened(double low, double high) {
  if (!(low <= high)) return kAnything;  // NaN included
  return {low - kRounding * std::abs(low), high + kRounding * std::abs(high)};
}

inline double most_of(Range a) { return std::max(std::abs(a.low), std::abs(a.high)); }
inline double least_of(Range a) { return a.contains(0.0) ? 0.0 : std::min(std::abs(a.low), std::abs(a.high)); }

inline Range operator+(Range a, Range b) { return widened(a.low + b.low, a.high + b.high); }
inline Range operator-(Range a) { return {-a.high, -a.low}; }
inline Range operator-(Range a, Range b) { return a + -b; }

inline Range operator*(Range a, Range b) {
  const auto product = [](double p, double q) { return p == 0.0 || q == 0.0 ? 0.0 : p * q; };
  const auto [low, high] =
      std::minmax({product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high)});
  return widened(low, high);
}
inline Range operator*(double k, Range a) { return Range{k, k} * a; }

inline Range square(Range a) { return widened(least_of(a) * least_of(a), most_of(a) * most_of(a)); }

}  // namespace dripfeed::family
