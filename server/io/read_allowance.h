// How much may be read from one link: far more than a serial line can bring, and far less than a socket can. What is
// over it stays with the system, whose window or buffer holds the other side back, so that one peer that floods costs
// the other lines nothing.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "server/app/ports/clock.h"

namespace dripfeed::io {

inline constexpr std::int64_t kReadsPerSecond_bytes = 262'144;  // 28 lines of 115,200 baud
inline constexpr std::int64_t kReadsAtOnce_bytes = 16'384;

class ReadAllowance {
 public:
  // Bytes that may be read now; at most kReadsAtOnce_bytes, and none where only a few are left.
  std::int64_t left(feed::Time now) {
    const feed::Time since = std::min<feed::Time>(now - filled_at_, std::chrono::seconds(1));
    const std::int64_t more = since.count() * kReadsPerSecond_bytes / kSecond_ns;
    if (more > 0) {
      left_ = std::min(left_ + more, kReadsAtOnce_bytes);
      filled_at_ = now;
    }
    return left_ >= kWorthARead_bytes ? left_ : 0;
  }
  // So many were read. May go a piece beyond what was left.
  void took(std::size_t bytes, feed::Time now) {
    static_cast<void>(left(now));
    left_ -= static_cast<std::int64_t>(bytes);
    if (left_ >= kWorthARead_bytes) return;
    if (now - dry_at_ > kRelief) flood_began_at_ = now;
    dry_at_ = now;
  }
  // Nothing is left: reading rests for so long.
  static constexpr feed::Time kRest = std::chrono::milliseconds(5);

  // It ran dry a moment ago: more of the same may be in transit, held back by a window that is closed.
  [[nodiscard]] bool pressed(feed::Time now) const { return now - dry_at_ < kRelief; }
  // It ran dry again and again for a second, and not long ago: no burst that a network held back.
  [[nodiscard]] bool flooded(feed::Time now) const {
    return dry_at_ - flood_began_at_ >= kBurst && now - dry_at_ < kRemembered;
  }

 private:
  static constexpr std::int64_t kWorthARead_bytes = 256;
  static constexpr std::int64_t kSecond_ns = 1'000'000'000;
  static constexpr feed::Time kRelief = std::chrono::milliseconds(500);
  static constexpr feed::Time kBurst = std::chrono::seconds(1);
  static constexpr feed::Time kRemembered = std::chrono::seconds(10);

  std::int64_t left_ = kReadsAtOnce_bytes;
  feed::Time filled_at_{};
  feed::Time dry_at_ = -kRelief * 2;
  feed::Time flood_began_at_ = -kRelief * 2;
};

}  // namespace dripfeed::io
