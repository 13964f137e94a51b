// Words that stand in a machine's profile and in documents about the machine.
#pragma once

#include <array>
#include <string_view>

namespace dripfeed::json {

inline constexpr std::array<std::string_view, 3> kGSystemWords = {"A", "B", "C"};  // of ir::GSystem
inline constexpr std::array<std::string_view, 3> kFeedModeWords = {"per-minute", "per-revolution",
                                                                   "inverse-time"};  // of ir::FeedMode
inline constexpr std::array<std::string_view, 9> kAxisWords = {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"};

}  // namespace dripfeed::json
