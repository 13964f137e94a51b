// What one check may use of the machine that it runs on, whoever's program it is. The run itself has limits of its own
// (interpreter::Limits).
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include <fmt/format.h>

namespace dripfeed::app {

struct CheckBudget {
  std::uint32_t seconds = 60;  // 0: as long as it takes
  std::uint64_t memory_bytes = std::uint64_t{2} << 30U;
};

// What a command may keep for a text of that size.
constexpr std::uint64_t memory_for(std::uint64_t text_bytes) { return 64 * text_bytes + (std::uint64_t{256} << 20U); }

// For interpreter::RunOptions::used_up: the time begins now.
inline std::function<std::string()> time_budget(std::uint32_t seconds) {
  if (seconds == 0) return {};
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  return
      [seconds, end] { return std::chrono::steady_clock::now() < end ? std::string() : fmt::format("{} s", seconds); };
}

}  // namespace dripfeed::app
