// System variables whose assignment is a statement of its own on every '#' control.
#pragma once

#include <cstdint>

namespace dripfeed::macro_b {

inline constexpr std::uint32_t kAlarmVariable = 3000;    // #3000 = n(TEXT): stop with an alarm
inline constexpr std::uint32_t kMessageVariable = 3006;  // #3006 = n(TEXT): stop with a message

}  // namespace dripfeed::macro_b
