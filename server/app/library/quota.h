// Whether one more text or file may be stored, by the limits of the shop. What the store has is counted now and then: a
// limit is held to what is stored within some seconds, not to the byte.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>

#include "server/app/base/error.h"
#include "server/app/base/library_limits.h"
#include "store/store.h"

namespace dripfeed::app {

class Quota {
 public:
  Quota(store::Store& store, const LibraryLimits& limits) : store_(store), limits_(limits) {}

  [[nodiscard]] const LibraryLimits& limits() const { return limits_; }
  // Before so many bytes are stored; from any thread. Errors: too_large, over_quota, and the store's.
  Result<void> may_keep_program(std::uint64_t bytes);
  Result<void> may_keep_attachment(std::uint64_t bytes);

 private:
  Result<void> has_room(std::uint64_t bytes);

  store::Store& store_;
  LibraryLimits limits_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point counted_at_{};  // never
  std::uint64_t stored_bytes_ = 0;                      // then, and what was let in since
};

}  // namespace dripfeed::app
