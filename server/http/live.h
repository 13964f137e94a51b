// Live events as text/event-stream: transitions with their ids, and the newest progress of each machine at most five
// times a second. Each event is written once for all who watch; a thread of its own does it, so that neither the
// publisher nor the HTTP thread waits for the store. Watchers are limited, by credential and in all, and end with it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "server/app/application.h"
#include "server/app/lines/wire_tap.h"
#include "server/http/event_stream.h"
#include "server/http/sessions.h"

namespace dripfeed::http {

// Where a machine stands now, with its program and block: asked for when its line's report has changed.
using Describe = std::function<app::MachineStatus(const std::string& machine)>;
// Whether a watcher may go on watching. Asked about once a second.
using StillValid = std::function<bool(const Credential&)>;
// A batch of what passed on a line, as one event of the stream.
using WriteWire = std::function<std::string(const app::WireTap::Batch&)>;

class LiveHub {
 public:
  static constexpr std::size_t kMostOfOne = 64;  // watchers on one token
  static constexpr std::size_t kMost = 512;

  // What is given must outlive the hub, and the hub its watchers.
  LiveHub(app::Events& events, Describe describe, StillValid still_valid);
  ~LiveHub();
  LiveHub(const LiveHub&) = delete;
  LiveHub& operator=(const LiveHub&) = delete;

  // Everything after event `after`; or a sentence where too many watch.
  std::expected<std::shared_ptr<EventSubscription>, std::string> watch(std::uint64_t after, Credential credential);
  // What passes on a line from now on, five times a second; it ends with the line. For as long as a person watches,
  // and no longer, the tap keeps what passes.
  std::expected<std::shared_ptr<EventSubscription>, std::string> watch_wire(std::shared_ptr<app::WireTap> tap,
                                                                            WriteWire write, Credential credential);
  // How many watch.
  [[nodiscard]] std::size_t watchers();
  // One round now, on the caller's thread. For tests.
  void round();

 private:
  using Clock = std::chrono::steady_clock;
  class Seated;
  class Watcher;
  class WireWatcher;
  struct Written {
    std::uint64_t id = 0;
    std::string text;
  };
  struct Shown {
    std::string line;  // of the line's report alone, to see a change
    std::string text;
    std::uint64_t generation = 0;
  };
  struct Seat {
    Credential credential;
    std::function<void()> ready{};
    bool ended = false;
    const WireWatcher* wire = nullptr;  // of a line's wire
  };

  void loop(const std::stop_token& stop);
  void wake();
  Clock::time_point next_due();
  void begin_at_newest();
  bool gather_events();
  bool gather_progress(Clock::time_point now);
  bool end_invalid(Clock::time_point now);
  [[nodiscard]] bool watches_wire() const;
  bool look_at_wires(Clock::time_point now);
  std::expected<void, std::string> seat(const EventSubscription& watcher, Seat taken);
  [[nodiscard]] std::size_t count_of(const std::string& owner) const;

  app::Events& events_;
  Describe describe_;
  StillValid still_valid_;
  app::Events::Watch watch_ = 0;

  std::mutex mutex_;             // of what follows
  std::deque<Written> written_;  // all events after written_from_, up to written_to_
  std::uint64_t written_from_ = 0;
  std::uint64_t written_to_ = 0;
  std::map<std::string, Shown> progress_;  // by machine
  std::uint64_t generation_ = 0;
  std::map<const EventSubscription*, Seat> seats_;
  Clock::time_point next_progress_{};
  Clock::time_point next_check_{};
  Clock::time_point next_wires_{};
  bool held_back_ = false;

  std::mutex wake_mutex_;
  std::condition_variable_any wake_;
  bool woken_ = false;
  std::jthread thread_;
};

}  // namespace dripfeed::http
