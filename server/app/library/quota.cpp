// Counting is one sum over the rows of all contents.
#include "server/app/library/quota.h"

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kCountEvery{10};

}  // namespace

Result<void> Quota::may_keep_program(std::uint64_t bytes) {
  if (bytes > limits_.program_bytes)
    return fail(ErrorCode::too_large,
                fmt::format("the text has {} bytes; a program has {} at most here", bytes, limits_.program_bytes));
  return has_room(bytes);
}

Result<void> Quota::may_keep_attachment(std::uint64_t bytes) {
  if (bytes > limits_.attachment_bytes)
    return fail(ErrorCode::too_large, fmt::format("the file has {} bytes; an attached one has {} at most here", bytes,
                                                  limits_.attachment_bytes));
  return has_room(bytes);
}

Result<void> Quota::has_room(std::uint64_t bytes) {
  if (limits_.store_bytes == 0) return {};
  const std::lock_guard lock(mutex_);
  if (counted_at_ == Clock::time_point{} || Clock::now() - counted_at_ > kCountEvery) {
    const auto counted = lift(store_.contents().total_bytes());
    if (!counted) return std::unexpected(counted.error());
    stored_bytes_ = *counted;
    counted_at_ = Clock::now();
  }
  if (stored_bytes_ + bytes > limits_.store_bytes)
    return fail(ErrorCode::over_quota,
                fmt::format("the store has {} bytes of texts and files, and {} more are over its "
                            "limit of {}",
                            stored_bytes_, bytes, limits_.store_bytes));
  stored_bytes_ += bytes;
  return {};
}

}  // namespace dripfeed::app
