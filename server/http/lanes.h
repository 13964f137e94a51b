// The threads that answer requests, by what they may wait for. The HTTP thread itself only reads and writes sockets and
// answers what needs neither the store nor a disk: whatever hangs, a person's stop is read and reaches its lane.
// Nothing that is slow in one lane holds up another.
//
//   here     the HTTP thread: that the server is there, and that there is no such path
//   read     small reads of the store
//   command  stop, cancel, resume, confirm: what a person at a machine waits for
//   arm      arming: the same, and another system may be asked before it
//   write    small changes of the store
//   bulk     texts: uploads, long answers, files
//   heavy    checks, rendering, sweeps: they wait for worker processes
//   secret   signing in: a hash of a password takes a tenth of a second and 64 MiB, one at a time
//   provider signing in by another system, which is asked meanwhile and may not answer
//   spool    files of long bodies that arrive: it waits for the disk (see spool.h)
//
// Each lane has a queue with an end: who comes later is asked to come again.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

namespace dripfeed::http {

enum class Lane : std::uint8_t { here, read, command, arm, write, bulk, heavy, secret, provider, spool };
inline constexpr std::size_t kLanesAndHere = 10;

class Lanes {
 public:
  using Work = std::move_only_function<void()>;

  // Starts the threads. `heavy_threads`: as many as heavy requests may be at work or wait for a worker process.
  explicit Lanes(unsigned heavy_threads);
  // All work must have ended, see stop().
  ~Lanes();
  Lanes(const Lanes&) = delete;
  Lanes& operator=(const Lanes&) = delete;

  // From any thread. False when the lane is full or stopped: then the work was not taken. Not for Lane::here.
  bool submit(Lane lane, Work work);
  // Takes no more, drops what waits, and gives what is at work so much time. False when something still runs then: its
  // thread cannot be ended, only the process.
  bool stop(std::chrono::milliseconds at_most);

 private:
  class One;
  One& at(Lane lane);
  std::unique_ptr<One> lanes_[kLanesAndHere - 1];
};

}  // namespace dripfeed::http
