// A slice, then a pause of the time that it took.
#include "server/app/base/kept_content.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace dripfeed::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kSlice_bytes = std::size_t{256} * 1024;
constexpr std::chrono::milliseconds kShortestPause{2};
constexpr std::chrono::milliseconds kLongestPause{20};

void let_others_write(Clock::time_point begin) {
  const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin);
  std::this_thread::sleep_for(std::clamp(took, kShortestPause, kLongestPause));
}

}  // namespace

Result<store::Content> keep_in_slices(store::Contents& contents, const Pieces& pieces) {
  auto writer = lift(contents.begin());
  if (!writer) return std::unexpected(writer.error());
  std::vector<char> slice(kSlice_bytes);
  while (true) {
    const auto begin = Clock::now();
    const auto count = pieces(slice);
    if (!count) return fail(ErrorCode::unavailable, count.error());
    if (*count == 0) return lift((*writer)->finish());
    if (auto written = lift((*writer)->append({slice.data(), *count})); !written)
      return std::unexpected(written.error());
    if (*count == kSlice_bytes) let_others_write(begin);
  }
}

Result<store::Content> keep_in_slices(store::Contents& contents, std::string_view bytes) {
  if (bytes.size() <= kSlice_bytes) return lift(contents.put(bytes));
  return keep_in_slices(contents, [&](std::span<char> into) -> std::expected<std::size_t, std::string> {
    const std::size_t count = std::min(into.size(), bytes.size());
    std::ranges::copy_n(bytes.data(), static_cast<std::ptrdiff_t>(count), into.data());
    bytes.remove_prefix(count);
    return count;
  });
}

}  // namespace dripfeed::app
