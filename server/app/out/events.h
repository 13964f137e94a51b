// Live events: a ring of transitions, numbered and resumable, and a snapshot of progress per machine that is not a part
// of it. A watcher that is too slow gets `reset` and reloads; it never delays another.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "server/app/lines/asks.h"
#include "server/app/lines/line.h"
#include "store/store.h"

namespace dripfeed::app {

enum class EventKind : std::uint8_t { job, machine, verdict, alarm, receipt };

struct Event {
  std::uint64_t id = 0;
  EventKind kind = EventKind::job;
  std::string machine;
  store::Job job;         // job
  store::Id verdict = 0;  // verdict
  store::Outcome outcome = store::Outcome::unknown;
  std::string text;      // alarm, verdict, receipt: a sentence
  store::Alarm alarm{};  // alarm
};

// What a machine's line does, as a watcher sees it; coalesced, so that only the newest counts.
struct Progress {
  std::string machine;
  LineReport report;
  Asks asks{};
};

class Events {
 public:
  static constexpr std::size_t kRing = 1024;

  // A server begins above all that the one before it gave, so that a watcher who saw that one reloads.
  explicit Events(std::uint64_t first_id = 1) : first_id_(first_id), next_id_(first_id) {}

  // While it lives, what its thread publishes waits, and goes out with release(); without that it never was. For
  // changes that are published only when the transaction around them is durable.
  class Hold {
   public:
    explicit Hold(Events& events) : events_(events), outer_(std::exchange(holding_, this)) {}
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;
    ~Hold() { end(); }
    void release();

   private:
    friend class Events;
    void end() {
      if (holding_ == this) holding_ = outer_;
    }
    static thread_local Hold* holding_;

    Events& events_;
    Hold* outer_;
    std::vector<Event> waiting_;
  };

  void publish(Event event);
  void progress(const std::string& machine, const LineReport& report, const Asks& asks = {});

  // What is newer than `after`; `reset` says that the ring no longer holds all of it.
  struct Batch {
    bool reset = false;
    std::vector<Event> events;
    std::uint64_t last = 0;  // id to ask from next time
  };
  [[nodiscard]] Batch since(std::uint64_t after) const;
  [[nodiscard]] std::vector<Progress> snapshot() const;
  [[nodiscard]] std::uint64_t last_id() const;

  // `ready` is called after each publish and each change of progress, from the publisher's thread: it must only wake a
  // thread.
  using Watch = std::uint64_t;
  Watch watch(std::function<void()> ready);
  void unwatch(Watch watch);

 private:
  void wake();

  mutable std::mutex mutex_;
  std::vector<Event> ring_;
  std::uint64_t first_id_;
  std::uint64_t next_id_;
  std::map<std::string, Progress> progress_;
  std::mutex watch_mutex_;
  std::map<Watch, std::function<void()>> watchers_;
  Watch next_watch_ = 1;
};

}  // namespace dripfeed::app
