// A watcher holds no queue: it remembers the last id it took and asks for what is newer, so a slow one costs nothing
// and skips progress it missed.
#include "server/http/live.h"

#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "server/json/records.h"

namespace dripfeed::http {

namespace {

constexpr std::chrono::milliseconds kProgressEvery{200};

class Watcher final : public EventSubscription {
 public:
  Watcher(app::Events& events, std::uint64_t after, Describe describe)
      : events_(events), after_(after), describe_(std::move(describe)) {}
  ~Watcher() override { on_ready({}); }

  std::string take() override {
    std::string out;
    const app::Events::Batch batch = events_.since(after_);
    after_ = batch.last;
    if (batch.reset) out += fmt::format("id: {}\nevent: reset\ndata: {{}}\n\n", batch.last);
    for (const app::Event& event : batch.events) {
      out += fmt::format("id: {}\nevent: {}\ndata: {}\n\n", event.id, json::event_name(event.kind),
                         json::event_data(event));
    }
    append_progress(out);
    return out;
  }

  std::optional<std::chrono::milliseconds> due_after() override {
    if (!held_back_) return std::nullopt;
    return kProgressEvery;
  }

  void on_ready(std::function<void()> ready) override {
    const std::lock_guard lock(mutex_);
    if (watch_ != 0) events_.unwatch(watch_);
    watch_ = ready ? events_.watch(std::move(ready)) : 0;
  }

 private:
  void append_progress(std::string& out) {
    const auto now = std::chrono::steady_clock::now();
    held_back_ = now < next_progress_;
    if (held_back_) return;
    next_progress_ = now + kProgressEvery;
    for (const app::Progress& progress : events_.snapshot()) {
      app::MachineStatus line_alone;
      line_alone.report = progress.report;
      std::string data = json::progress(progress.machine, line_alone);
      std::string& sent = sent_[progress.machine];
      if (sent == data) continue;
      out +=
          fmt::format("event: progress\ndata: {}\n\n", json::progress(progress.machine, describe_(progress.machine)));
      sent = std::move(data);
    }
  }

  app::Events& events_;
  std::uint64_t after_;
  std::chrono::steady_clock::time_point next_progress_;
  bool held_back_ = false;
  Describe describe_;
  std::map<std::string, std::string> sent_;  // of each line's report
  std::mutex mutex_;
  app::Events::Watch watch_ = 0;
};

}  // namespace

std::shared_ptr<EventSubscription> watch_events(app::Events& events, std::uint64_t after, Describe describe) {
  return std::make_shared<Watcher>(events, after, std::move(describe));
}

}  // namespace dripfeed::http
