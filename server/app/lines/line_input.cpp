// The bytes of a reception are moved, not copied, when it ends.
#include "server/app/lines/line_input.h"

#include <utility>

namespace dripfeed::app {

std::optional<receive::EndedBy> LineInput::take(std::byte byte, receive::Time now) {
  ended_by_.reset();
  while (receiver_.receive(std::span(&byte, 1), now) == 0) collect(now);  // a reception had ended by time before it
  collect(now);
  return ended_by_;
}

void LineInput::tick(receive::Time now) {
  receiver_.tick(now);
  collect(now);
}

void LineInput::link_lost(receive::Time now) {
  receiver_.tick(now);
  collect(now);
  receiver_.link_lost(now);
  collect(now);
}

void LineInput::collect(receive::Time now) {
  const auto kept = receiver_.kept();
  raw_.insert(raw_.end(), kept.begin(), kept.end());
  receiver_.mark_taken();
  const std::lock_guard lock(mutex_);
  if (const auto ended = receiver_.ended()) {
    ended_by_ = ended->by;
    ++count_;
    if (finished_.size() < kMaxWaiting) {
      finished_.push_back({.raw = std::exchange(raw_, {}), .ending = *ended, .settings = receiver_.settings()});
    } else {
      ++lost_;
      raw_.clear();
    }
  }
  receiver_.can_take(finished_.size() < kMaxWaiting / 2, now);
}

std::vector<Reception> LineInput::take_finished() {
  const std::lock_guard lock(mutex_);
  return std::exchange(finished_, {});
}

}  // namespace dripfeed::app
