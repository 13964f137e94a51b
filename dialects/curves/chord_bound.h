// Bounds of how far a chord lies from its curve, each with its proof. Nothing here is sampled.
#pragma once

#include <algorithm>
#include <cmath>

#include "dialects/curves/point.h"

namespace dripfeed::curves {

// A function whose second derivative stays below `second` in size, interpolated over `width`: the error is at most
// second·width²/8 (the interpolation error (u - a)(u - b)/2·f'' is largest in the middle). Holds along z for x = f(z)
// and, with |C''|, for a curve over its parameter.
constexpr double interpolation_bound(double second, double width) { return second * width * width / 8.0; }

// The longest step whose interpolation error stays within `tolerance`.
inline double longest_step(double second, double tolerance) { return std::sqrt(8.0 * tolerance / second); }

// Largest height over a chord of a curve that bends in one direction and nowhere more than `curvature` (1/mm, > 0):
// that of the circle with that curvature (Schwarz's comparison). Holds while chord <= 2/curvature; the radius beyond.
inline double sagitta_bound(double curvature, double chord) {
  const double half = 0.5 * chord * curvature;
  return half >= 1.0 ? 1.0 / curvature : half * 0.5 * chord / (1.0 + std::sqrt(1.0 - half * half));
}

// The gap h = path - curve over a range of z, where h is known at both ends and h'' lies within `second`:
// |h| <= max(|h_low|, |h_high|) + max|h''|·width²/8, because h less its chord vanishes at both ends. The normal
// distance is never larger than this gap along x.
inline double gap_bound(double gap_low, double gap_high, Range second, double width) {
  return std::max(std::fabs(gap_low), std::fabs(gap_high)) +
         interpolation_bound(std::max(std::fabs(second.low), std::fabs(second.high)), width);
}

}  // namespace dripfeed::curves
