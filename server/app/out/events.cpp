// The ring is a vector used round: event `id` lies at id % kRing.
#include "server/app/out/events.h"

#include <algorithm>
#include <utility>

namespace dripfeed::app {

thread_local Events::Hold* Events::Hold::holding_ = nullptr;

void Events::Hold::release() {
  end();
  for (Event& event : std::exchange(waiting_, {})) events_.publish(std::move(event));
}

void Events::publish(Event event) {
  if (Hold* const hold = Hold::holding_; hold != nullptr && &hold->events_ == this) {
    hold->waiting_.push_back(std::move(event));
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    event.id = next_id_++;
    if (ring_.size() < kRing) ring_.resize(kRing);
    const std::size_t slot = event.id % kRing;
    ring_[slot] = std::move(event);
  }
  wake();
}

void Events::progress(const std::string& machine, const LineReport& report, const Asks& asks) {
  {
    const std::lock_guard lock(mutex_);
    Progress& shown = progress_[machine];
    const LineReport& known = shown.report;
    if (known.changes == report.changes && known.handed == report.handed && known.clocked == report.clocked &&
        known.confirmed == report.confirmed && known.job == report.job && known.machine == report.machine &&
        shown.asks == asks) {
      return;
    }
    shown = {machine, report, asks};
  }
  wake();
}

Events::Batch Events::since(std::uint64_t after) const {
  const std::lock_guard lock(mutex_);
  Batch batch;
  batch.last = next_id_ - 1;
  const std::uint64_t oldest = std::max(next_id_, first_id_ + kRing) - kRing;
  // An id that was never given comes from a server before this one.
  batch.reset = after + 1 < oldest || after >= next_id_;
  for (std::uint64_t id = std::max(after + 1, oldest); !batch.reset && id < next_id_; ++id) {
    batch.events.push_back(ring_[id % kRing]);
  }
  return batch;
}

std::vector<Progress> Events::snapshot() const {
  const std::lock_guard lock(mutex_);
  std::vector<Progress> all;
  all.reserve(progress_.size());
  for (const auto& [machine, shown] : progress_) all.push_back(shown);
  return all;
}

std::uint64_t Events::last_id() const {
  const std::lock_guard lock(mutex_);
  return next_id_ - 1;
}

Events::Watch Events::watch(std::function<void()> ready) {
  const std::lock_guard lock(watch_mutex_);
  watchers_[next_watch_] = std::move(ready);
  return next_watch_++;
}

void Events::unwatch(Watch watch) {
  const std::lock_guard lock(watch_mutex_);
  watchers_.erase(watch);
}

void Events::wake() {
  const std::lock_guard lock(watch_mutex_);
  for (const auto& [id, ready] : watchers_) ready();
}

}  // namespace dripfeed::app
