// Hole patterns that a code drills by the cycle in effect: the argument of Function::hole_pattern.
#pragma once

#include <cstdint>

namespace dripfeed::ir {

inline constexpr std::int16_t kHolesOnCircle = 0;  // G34
inline constexpr std::int16_t kHolesOnLine = 1;    // G35
inline constexpr std::int16_t kHolesOnArc = 2;     // G36
inline constexpr std::int16_t kHolesOnGrid = 3;    // G37.1

}  // namespace dripfeed::ir
