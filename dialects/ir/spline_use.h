// What the argument of the spline functions says.
#pragma once

#include <cstdint>

namespace dripfeed::ir {

// Function::spline
inline constexpr std::int16_t kSplineAkima = 0;  // through its points; the curve depends on near points alone
inline constexpr std::int16_t kSplineCubic = 1;  // through its points, without a jump of its curvature
inline constexpr std::int16_t kSplineB = 2;      // its points are a polygon of control

// Function::spline_begin, Function::spline_end
inline constexpr std::int16_t kSplineTangent = 0;  // as the move before it ends, or the one after it begins
inline constexpr std::int16_t kSplineNatural = 1;  // without curvature
inline constexpr std::int16_t kSplineFree = 2;     // by its points alone

}  // namespace dripfeed::ir
