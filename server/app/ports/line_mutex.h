// The mutex of what a line's threads share with others. Threads that serve lines (the links' and the ledger's) may wait
// for it as long as a few fields are copied, and no longer: a longer wait is measured, and with DRIPFEED_LOCK_LIMIT_MS
// set it ends the process with a name, so that a test finds whoever holds a lock over I/O.
#pragma once

#include <atomic>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string_view>

#include <fmt/format.h>

namespace dripfeed::app {

// What the threads that serve lines waited for locks, since the start of the process.
class LineWaits {
 public:
  // The calling thread serves lines from now on.
  static void serve_lines_here() { serves_lines() = true; }
  [[nodiscard]] static bool& serves_lines() {
    static thread_local bool serves = false;
    return serves;
  }
  [[nodiscard]] static std::chrono::nanoseconds longest() { return std::chrono::nanoseconds(longest_ns().load()); }

  static void note(std::string_view mutex, std::chrono::nanoseconds waited) {
    std::int64_t known = longest_ns().load();
    while (waited.count() > known && !longest_ns().compare_exchange_weak(known, waited.count())) continue;
    static const std::chrono::nanoseconds kLimit = limit();
    if (kLimit.count() == 0 || waited <= kLimit) return;
    fmt::print(stderr, "dripfeed: a thread that serves lines waited {} us for the lock of {}\n",
               std::chrono::duration_cast<std::chrono::microseconds>(waited).count(), mutex);
    std::abort();
  }

 private:
  static std::atomic<std::int64_t>& longest_ns() {
    static std::atomic<std::int64_t> longest = 0;
    return longest;
  }
  // 0: none.
  static std::chrono::nanoseconds limit() {
    const char* const given = std::getenv("DRIPFEED_LOCK_LIMIT_MS");
    const std::string_view text = given == nullptr ? "" : given;
    std::int64_t limit_ms = 0;
    std::from_chars(text.data(), text.data() + text.size(), limit_ms);
    return std::chrono::milliseconds(limit_ms);
  }
};

// As std::mutex. `name` lives as long as the mutex: a literal.
class LineMutex {
 public:
  explicit LineMutex(std::string_view name) : name_(name) {}
  void lock() {
    if (mutex_.try_lock()) return;
    if (!LineWaits::serves_lines()) return mutex_.lock();
    const auto begun = std::chrono::steady_clock::now();
    mutex_.lock();
    LineWaits::note(name_, std::chrono::steady_clock::now() - begun);
  }
  bool try_lock() { return mutex_.try_lock(); }
  void unlock() { mutex_.unlock(); }

 private:
  std::mutex mutex_;
  std::string_view name_;
};

}  // namespace dripfeed::app
