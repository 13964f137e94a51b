// A thread that makes rounds: when it is woken, and at least once a period. Nothing runs a round on another thread, so
// what a round works on needs no lock; who wants its effect waits for it, and never the reverse.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>

#include "server/app/ports/line_mutex.h"

namespace dripfeed::app {

// How soon a thread gets the processor, where the system lets us choose.
enum class Urgency : std::uint8_t { usual, before_others };

class RoundThread {
 public:
  // `name` of at most 15 characters stands in the system's list of threads. The rounds begin at once.
  RoundThread(std::string name, std::chrono::milliseconds period, Urgency urgency, std::function<void()> round);
  // As stop().
  ~RoundThread();
  RoundThread(const RoundThread&) = delete;
  RoundThread& operator=(const RoundThread&) = delete;

  // From any thread, cheap.
  void wake();
  // Until a round is over that began after this call, for so long at most. False: it is not over, or there are no
  // rounds any more. Not from inside a round.
  bool wait_for_round(std::chrono::milliseconds patience);
  // One last round, then no more.
  void stop();

 private:
  void loop(const std::stop_token& stop);

  std::string name_;
  std::chrono::milliseconds period_;
  Urgency urgency_;
  std::function<void()> round_;
  LineMutex mutex_{"a round thread"};
  std::condition_variable_any woken_;
  std::condition_variable_any round_over_;
  bool due_ = false;
  bool over_ = false;
  std::uint64_t wanted_ = 0;  // calls of wait_for_round()
  std::uint64_t done_ = 0;    // ... whose round is over
  std::jthread thread_;       // last: it uses all of the above
};

}  // namespace dripfeed::app
