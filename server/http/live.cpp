// A watcher holds no queue: it remembers the last id and the generation of progress that it took, and asks for what is
// newer. A slow one costs nothing and skips progress that it missed.
#include "server/http/live.h"

#include <algorithm>
#include <atomic>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <sys/prctl.h>

#include "server/app/base/fence.h"
#include "server/json/records.h"

namespace dripfeed::http {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kProgressEvery = 200ms;
constexpr std::chrono::milliseconds kCheckEvery = 500ms;
constexpr std::chrono::milliseconds kRest = 40ms;  // between two rounds
constexpr std::size_t kWatchersPerRest_ms = 4;     // more watchers, longer rests

std::string framed(const app::Event& event) {
  return fmt::format("id: {}\nevent: {}\ndata: {}\n\n", event.id, json::event_name(event.kind),
                     json::event_data(event));
}

}  // namespace

// What all watchers have: a seat in the hub.
class LiveHub::Seated : public EventSubscription {
 public:
  explicit Seated(LiveHub& hub) : hub_(hub) {}
  Seated(const Seated&) = delete;
  Seated& operator=(const Seated&) = delete;
  ~Seated() override { vacate(); }

  bool ended() override {
    const std::lock_guard lock(hub_.mutex_);
    return hub_.seats_[this].ended;
  }

  void on_ready(std::function<void()> ready) override {
    const std::lock_guard lock(hub_.mutex_);
    hub_.seats_[this].ready = std::move(ready);
  }

 protected:
  // The hub's thread looks at this no more.
  void vacate() {
    const std::lock_guard lock(hub_.mutex_);
    hub_.seats_.erase(this);
  }

 private:
  LiveHub& hub_;
};

class LiveHub::Watcher final : public Seated {
 public:
  Watcher(LiveHub& hub, std::uint64_t after) : Seated(hub), hub_(hub), after_(after) {}

  std::string take() override {
    std::string out;
    const std::lock_guard lock(hub_.mutex_);
    if (is_new_ || after_ < hub_.written_from_) {
      take_from_ring(out);
    } else {
      take_written(out);
    }
    is_new_ = false;
    for (const auto& [machine, shown] : hub_.progress_) {
      if (shown.generation > generation_) out += shown.text;
    }
    generation_ = hub_.generation_;
    return out;
  }

 private:
  // What the hub did not write: from before the first watcher, or older than what it keeps.
  void take_from_ring(std::string& out) {
    const app::Events::Batch batch = hub_.events_.since(after_);
    after_ = batch.last;
    if (batch.reset) out += fmt::format("id: {}\nevent: reset\ndata: {{}}\n\n", batch.last);
    for (const app::Event& event : batch.events) out += framed(event);
  }

  void take_written(std::string& out) {
    auto& written = hub_.written_;
    const auto first = std::ranges::upper_bound(written, after_, {}, &Written::id);
    for (auto it = first; it != written.end(); ++it) out += it->text;
    after_ = std::max(after_, hub_.written_to_);
  }

  LiveHub& hub_;
  std::uint64_t after_;
  std::uint64_t generation_ = 0;
  bool is_new_ = true;
};

class LiveHub::WireWatcher final : public Seated {
 public:
  WireWatcher(LiveHub& hub, std::shared_ptr<app::WireTap> tap, WriteWire write)
      : Seated(hub), tap_(std::move(tap)), write_(std::move(write)), next_(tap_->join()) {}
  WireWatcher(const WireWatcher&) = delete;
  WireWatcher& operator=(const WireWatcher&) = delete;
  ~WireWatcher() override {
    vacate();
    tap_->leave();
  }

  std::string take() override {
    std::string out;
    while (tap_->has(next_)) {
      const app::WireTap::Batch batch = tap_->since(next_);
      next_ = batch.from + batch.entries.size();
      out += write_(batch);
    }
    return out;
  }

  [[nodiscard]] bool has_news() const { return tap_->has(next_) || tap_->ended(); }
  [[nodiscard]] bool is_over() const { return tap_->ended(); }

 private:
  std::shared_ptr<app::WireTap> tap_;
  WriteWire write_;
  std::atomic<std::uint64_t> next_;
};

LiveHub::LiveHub(app::Events& events, Describe describe, StillValid still_valid)
    : events_(events), describe_(std::move(describe)), still_valid_(std::move(still_valid)) {
  watch_ = events_.watch([this] { wake(); });
  thread_ = std::jthread([this](const std::stop_token& stop) { loop(stop); });
}

LiveHub::~LiveHub() { events_.unwatch(watch_); }

void LiveHub::wake() {
  {
    const std::lock_guard lock(wake_mutex_);
    if (woken_) return;  // it looks for all that is new
    woken_ = true;
  }
  wake_.notify_one();
}

std::size_t LiveHub::count_of(const std::string& owner) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(seats_, [&](const auto& seat) { return seat.second.credential.owner == owner; }));
}

std::size_t LiveHub::watchers() {
  const std::lock_guard lock(mutex_);
  return seats_.size();
}

std::expected<std::shared_ptr<EventSubscription>, std::string> LiveHub::watch(std::uint64_t after,
                                                                              Credential credential) {
  auto watcher = std::make_shared<Watcher>(*this, after);
  if (auto seated = seat(*watcher, {.credential = std::move(credential)}); !seated)
    return std::unexpected(seated.error());
  return watcher;
}

std::expected<std::shared_ptr<EventSubscription>, std::string> LiveHub::watch_wire(std::shared_ptr<app::WireTap> tap,
                                                                                   WriteWire write,
                                                                                   Credential credential) {
  auto watcher = std::make_shared<WireWatcher>(*this, std::move(tap), std::move(write));
  if (auto seated = seat(*watcher, {.credential = std::move(credential), .wire = watcher.get()}); !seated)
    return std::unexpected(seated.error());
  return watcher;
}

std::expected<void, std::string> LiveHub::seat(const EventSubscription& watcher, Seat taken) {
  {
    const std::lock_guard lock(mutex_);
    if (seats_.size() >= kMost)
      return std::unexpected(fmt::format("{} watch already: close a page that is not needed", kMost));
    if (count_of(taken.credential.owner) >= kMostOfOne) {
      return std::unexpected(
          fmt::format("{} watch with this token already: give other stations tokens of their own", kMostOfOne));
    }
    if (seats_.empty()) begin_at_newest();
    seats_[&watcher] = std::move(taken);
  }
  wake();
  return {};
}

void LiveHub::loop(const std::stop_token& stop) {
  ::prctl(PR_SET_NAME, "live events");
  std::unique_lock lock(wake_mutex_);
  while (!stop.stop_requested()) {
    lock.unlock();
    const auto due = next_due();
    lock.lock();
    wake_.wait_until(lock, stop, due, [this] { return woken_; });
    if (stop.stop_requested()) return;
    woken_ = false;
    lock.unlock();
    app::fenced("live events", [this] { round(); });
    std::size_t watchers = 0;
    {
      const std::lock_guard seats(mutex_);
      watchers = seats_.size();
    }
    lock.lock();
    wake_.wait_for(lock, stop, kRest + std::chrono::milliseconds(watchers / kWatchersPerRest_ms), [] { return false; });
  }
}

LiveHub::Clock::time_point LiveHub::next_due() {
  const std::lock_guard lock(mutex_);
  if (seats_.empty()) return Clock::now() + 1h;
  const auto due = held_back_ ? std::min(next_progress_, next_check_) : next_check_;
  return watches_wire() ? std::min(due, next_wires_) : due;
}

bool LiveHub::watches_wire() const {
  return std::ranges::any_of(seats_, [](const auto& one) { return one.second.wire != nullptr; });
}

// A line wakes no one when a character passes; who watches it is woken in steps.
bool LiveHub::look_at_wires(Clock::time_point now) {
  if (now < next_wires_) return false;
  next_wires_ = now + kProgressEvery;
  bool news = false;
  for (auto& [watcher, seat] : seats_) {
    if (seat.wire == nullptr || seat.ended) continue;
    news = seat.wire->has_news() || news;
    seat.ended = seat.wire->is_over();
  }
  return news;
}

// With no one there, nothing is written: the first who comes reads the ring.
void LiveHub::round() {
  const auto now = Clock::now();
  const std::lock_guard lock(mutex_);
  if (seats_.empty()) return begin_at_newest();
  bool news = gather_events();
  news = gather_progress(now) || news;
  news = end_invalid(now) || news;
  news = look_at_wires(now) || news;
  if (!news) return;
  for (const auto& [watcher, seat] : seats_) {
    if (seat.ready) seat.ready();
  }
}

void LiveHub::begin_at_newest() {
  written_.clear();
  written_from_ = written_to_ = events_.last_id();
}

bool LiveHub::gather_events() {
  const app::Events::Batch batch = events_.since(written_to_);
  if (batch.reset) {  // more came than the ring holds: everybody reads that there
    begin_at_newest();
    return true;
  }
  for (const app::Event& event : batch.events) written_.push_back({.id = event.id, .text = framed(event)});
  written_to_ = batch.last;
  while (written_.size() > app::Events::kRing) {
    written_from_ = written_.front().id;
    written_.pop_front();
  }
  return !batch.events.empty();
}

bool LiveHub::gather_progress(Clock::time_point now) {
  held_back_ = now < next_progress_;
  if (held_back_) return false;
  next_progress_ = now + kProgressEvery;
  bool news = false;
  for (const app::Progress& progress : events_.snapshot()) {
    app::MachineStatus line_alone;
    line_alone.report = progress.report;
    line_alone.asks = progress.asks;
    std::string line = json::progress(progress.machine, line_alone);
    Shown& shown = progress_[progress.machine];
    if (shown.line == line) continue;
    shown.line = std::move(line);
    shown.text =
        fmt::format("event: progress\ndata: {}\n\n", json::progress(progress.machine, describe_(progress.machine)));
    shown.generation = generation_ + 1;
    news = true;
  }
  if (news) ++generation_;
  return news;
}

// Each credential is asked about once, whoever holds how many watchers.
bool LiveHub::end_invalid(Clock::time_point now) {
  if (now < next_check_) return false;
  next_check_ = now + kCheckEvery;
  std::set<Credential> valid;
  bool news = false;
  for (auto& [watcher, seat] : seats_) {
    if (seat.ended || valid.contains(seat.credential)) continue;
    if (still_valid_(seat.credential)) {
      valid.insert(seat.credential);
    } else {
      seat.ended = true;
      news = true;
    }
  }
  return news;
}

}  // namespace dripfeed::http
