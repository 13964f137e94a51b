// Line time: when the characters handed so far have left, and how many more may be handed now. All by one absolute
// instant, free_at = max(now, free_at) + n * character time, never by adding up intervals.
#pragma once

#include <algorithm>
#include <cstdint>

#include "protocol/feed/settings.h"

namespace dripfeed::feed {

class LineClock {
 public:
  LineClock(Time char_time, std::uint32_t unsent, std::uint32_t latency_chars)
      : char_time_(char_time),
        unsent_(unsent),
        left_at_refill_(left_at_refill(char_time, unsent)),
        latency_(char_time * latency_chars) {}

  // So many characters are left to send when the next are handed: enough for kRefillAhead, and half of `unsent` at
  // most. As few as can be, because each write costs the same however much is in it.
  static std::uint32_t left_at_refill(Time char_time, std::uint32_t unsent) {
    const auto ahead = static_cast<std::uint64_t>((kRefillAhead + char_time - Time(1)) / char_time);
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(ahead, unsent / 2));
  }

  // A new job: counts from 0 again. What is still on the line stays on the line.
  void restart();
  void handed(std::uint64_t count, Time now);
  // The driver says that so many characters are unsent below it; more than we believed moves free_at out, fewer does
  // not move it in (a FIFO is not in that number, and a pty always says 0).
  void queue_reported(std::uint64_t unsent, Time now);
  // Nothing more is handed until so long after the last character has left.
  void rest(Time gap) { gap_ = gap; }
  // CTS stops and starts the line below us: line time stands still in between.
  void pause(Time now);
  void go_on(Time now);
  bool paused() const { return paused_; }
  // Whole characters that by line time had not begun to leave when it was paused.
  std::uint64_t left_at_pause() const;

  // Characters that may be handed now: refilled to `unsent` once left_at_refill() are left, and until then what was
  // left of it.
  std::uint32_t credit(Time now);
  // When credit() will refill. Meaningful while not paused.
  Time refill_at() const {
    return gap_ > Time::zero() ? free_at_ + gap_ : free_at_ - char_time_ * static_cast<std::int64_t>(left_at_refill_);
  }
  // When line time and latency of everything handed have passed. Meaningful while not paused.
  Time drained_at() const { return free_at_ + latency_; }
  bool is_drained(Time now) const { return !paused_ && now >= drained_at(); }

  std::uint64_t handed() const { return handed_; }
  // Characters whose line time and latency passed; never runs backwards.
  std::uint64_t clocked(Time now);
  // Characters that had left for certain at an earlier instant, as if all since were sent without a pause: no more than
  // clocked() said then.
  std::uint64_t clocked_before(Time instant) const;

 private:
  std::uint64_t queued(Time until) const;

  Time char_time_;
  std::uint32_t unsent_;
  std::uint32_t left_at_refill_;
  Time latency_;
  Time free_at_{};
  Time left_at_pause_{};
  Time gap_{};
  bool paused_ = false;
  std::uint32_t burst_left_ = 0;
  std::uint64_t handed_ = 0;
  std::uint64_t clocked_ = 0;
};

}  // namespace dripfeed::feed
