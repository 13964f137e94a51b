// Whether the database answers at all. A server that is frozen, or a network that drops what is sent, refuses nothing:
// libpq would wait without an end, and so would a person who wants to stop a line. A thread of its own asks once a
// second on a connection of its own. What waits for an answer gives up when the database is silent, and what comes
// next does not begin to wait. A long statement is not silence, and neither is a database that refuses: whoever asks
// finds that out at once.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

struct pg_conn;

namespace dripfeed::postgresql {

struct HandleDrop {
  void operator()(pg_conn* handle) const;
};
using HandlePtr = std::unique_ptr<pg_conn, HandleDrop>;

class Pulse {
 public:
  // An answer that takes so long is silence.
  static constexpr std::chrono::seconds kPatience{3};

  explicit Pulse(std::string url);
  Pulse(const Pulse&) = delete;
  Pulse& operator=(const Pulse&) = delete;
  // Waits for a question that was asked: at most kPatience, and what the resolver of host names takes.
  ~Pulse();

  // From any thread; takes no lock.
  [[nodiscard]] bool is_silent() const { return is_silent_.load(std::memory_order_relaxed); }

 private:
  void loop(const std::stop_token& stop);
  bool hears_nothing();
  bool opens_nothing();

  std::string url_;
  HandlePtr handle_;
  std::atomic<bool> is_silent_ = false;
  std::mutex mutex_;
  std::condition_variable_any woken_;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::postgresql
