// Line time by one absolute instant.
#include "protocol/feed/line_clock.h"

#include <algorithm>

namespace dripfeed::feed {

void LineClock::restart() {
  handed_ = 0;
  clocked_ = 0;
  burst_left_ = 0;
  gap_ = Time::zero();
}

void LineClock::handed(std::uint64_t count, Time now) {
  const Time line_time = char_time_ * static_cast<std::int64_t>(count);
  if (paused_) {
    left_at_pause_ += line_time;
  } else {
    free_at_ = std::max(free_at_, now) + line_time;
  }
  handed_ += count;
  burst_left_ -= static_cast<std::uint32_t>(std::min<std::uint64_t>(count, burst_left_));
}

void LineClock::queue_reported(std::uint64_t unsent, Time now) {
  const Time line_time = char_time_ * static_cast<std::int64_t>(std::min<std::uint64_t>(unsent, kMaxBudget));
  if (paused_) {
    left_at_pause_ = std::max(left_at_pause_, line_time);
  } else {
    free_at_ = std::max(free_at_, now + line_time);
  }
}

void LineClock::pause(Time now) {
  if (paused_) return;
  left_at_pause_ = std::max(Time::zero(), free_at_ - now);
  paused_ = true;
}

void LineClock::go_on(Time now) {
  if (!paused_) return;
  paused_ = false;
  if (left_at_pause_ > Time::zero()) free_at_ = std::max(free_at_, now + left_at_pause_);
}

std::uint64_t LineClock::left_at_pause() const {
  if (!paused_ || left_at_pause_ <= Time::zero()) return 0;
  return static_cast<std::uint64_t>(left_at_pause_.count() / char_time_.count());
}

// Characters whose line time has not passed at that instant; one that is half out counts.
std::uint64_t LineClock::queued(Time until) const {
  if (free_at_ <= until) return 0;
  const Time left = free_at_ - until;
  return static_cast<std::uint64_t>((left.count() + char_time_.count() - 1) / char_time_.count());
}

std::uint32_t LineClock::credit(Time now) {
  if (paused_) return 0;
  if (gap_ > Time::zero()) {
    if (now < refill_at()) return 0;
    gap_ = Time::zero();
  }
  const std::uint64_t queue = queued(now);
  const auto room = static_cast<std::uint32_t>(queue < unsent_ ? unsent_ - queue : 0);
  burst_left_ = now >= refill_at() ? room : std::min(burst_left_, room);
  return burst_left_;
}

std::uint64_t LineClock::clocked(Time now) {
  if (!paused_) clocked_ = std::max(clocked_, clocked_before(now));
  return clocked_;
}

std::uint64_t LineClock::clocked_before(Time instant) const {
  return paused_ ? 0 : handed_ - std::min(queued(instant - latency_), handed_);
}

}  // namespace dripfeed::feed
