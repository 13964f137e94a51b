// How long a line is made for people at a control, who see no more of it at once.
#pragma once

#include <cstdint>

namespace dripfeed::ir {

// Columns: up to here assignments share a line, and expressions are merged.
inline constexpr std::uint32_t kReadableLine = 110;

}  // namespace dripfeed::ir
