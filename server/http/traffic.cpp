// Relaxed additions: a reader may see one request in the buckets and not yet in the sum.
#include "server/http/traffic.h"

#include <algorithm>

namespace dripfeed::http {

void Traffic::answered(std::size_t route, Lane lane, unsigned status, std::chrono::nanoseconds took) {
  const std::size_t status_class = std::clamp<std::size_t>(status / 100, 1, kClasses) - 1;
  requests_[std::min(route, routes())][status_class].fetch_add(1, std::memory_order_relaxed);
  Durations& of_lane = durations_[static_cast<std::size_t>(lane)];
  const double took_s = std::chrono::duration<double>(took).count();
  const auto bucket = std::ranges::lower_bound(kBuckets_s, took_s) - kBuckets_s.begin();
  of_lane.buckets[static_cast<std::size_t>(bucket)].fetch_add(1, std::memory_order_relaxed);
  of_lane.sum_ns.fetch_add(static_cast<std::uint64_t>(took.count()), std::memory_order_relaxed);
}

}  // namespace dripfeed::http
