// Entry n lies at n modulo the ring's size.
#include "server/app/lines/wire_tap.h"

#include <algorithm>
#include <mutex>

namespace dripfeed::app {

std::uint64_t WireTap::join() {
  std::vector<Entry> ring(kKept);  // before the lock
  const std::lock_guard lock(mutex_);
  if (ring_.empty()) ring_.swap(ring);
  if (watchers_++ == 0) since_ = next_;
  return since_;
}

void WireTap::leave() { --watchers_; }

void WireTap::note(WireKind event, feed::Time at) {
  constexpr std::byte kNone{0};
  note(event, std::span(&kNone, 1), at);
}

void WireTap::keep(WireKind direction, std::span<const std::byte> bytes, feed::Time at) {
  const std::lock_guard lock(mutex_);
  if (ring_.empty()) return;
  for (const std::byte byte : bytes)
    ring_[next_++ % kKept] = {.at = at, .kind = direction, .byte = std::to_integer<std::uint8_t>(byte)};
}

bool WireTap::has(std::uint64_t from) const {
  const std::lock_guard lock(mutex_);
  return next_ > from;
}

WireTap::Batch WireTap::since(std::uint64_t from) const {
  Batch batch;
  batch.entries.reserve(kMostAtOnce);  // before the lock
  const std::lock_guard lock(mutex_);
  const std::uint64_t oldest = next_ > kKept ? next_ - kKept : 0;
  batch.from = std::clamp(from, oldest, next_);
  batch.lost = batch.from - std::min(from, batch.from);
  const std::uint64_t end = std::min<std::uint64_t>(next_, batch.from + kMostAtOnce);
  for (std::uint64_t i = batch.from; i < end; ++i) batch.entries.push_back(ring_[i % kKept]);
  return batch;
}

}  // namespace dripfeed::app
