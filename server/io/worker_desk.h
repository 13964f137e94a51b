// Hands work to worker processes: so many at once, so many more that wait, first come, first served; the rest is sent
// away. One process is kept
// ready, so that a short piece of work need not wait for one to start; each does one piece of work and ends.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "server/app/ports/workplace.h"
#include "server/io/spawned_worker.h"
#include "server/io/steady_clock.h"

namespace dripfeed::io {

struct WorkerDeskSettings {
  std::vector<std::string> command;  // starts a worker that reads its request from standard input
  unsigned at_once = 1;
  unsigned waiting = 16;           // for one of those to be done
  std::uint64_t memory_bytes = 0;  // what the command gives each; for the message alone
  int memory_exit_code = 0;        // with which a worker says that it is not enough
};

class WorkerDesk final : public app::Workplace {
 public:
  explicit WorkerDesk(WorkerDeskSettings settings);
  std::expected<std::string, app::WorkError> carry_out(std::string_view request, std::uint32_t seconds,
                                                       const app::Waiter& waiter) override;
  std::vector<app::Work> works() override;
  bool cancel(std::uint64_t work, std::string_view by) override;

  // From any thread: how processes are started from now on; the one that is kept ready ends.
  void set_command(std::vector<std::string> command, std::uint64_t memory_bytes);

  // Threads that may be in carry_out() before one is sent away, and that one.
  [[nodiscard]] unsigned threads() const { return settings_.at_once + settings_.waiting + 1; }

 private:
  struct Entry {
    app::Work work;
    std::optional<std::string> cancelled_by;
    [[nodiscard]] bool waits() const { return work.running_since_ms == 0; }
  };
  using Entries = std::list<Entry>;
  class Place;
  std::expected<Entries::iterator, app::WorkError> take_place(const app::Waiter& waiter, std::uint32_t seconds);
  void leave_place(Entries::iterator entry);
  [[nodiscard]] unsigned working() const;
  [[nodiscard]] bool is_next(Entries::const_iterator entry) const;
  [[nodiscard]] bool is_cancelled(Entries::const_iterator entry);
  app::WorkError given_up(Entries::const_iterator entry, const app::Waiter& waiter);
  std::vector<std::string> command();
  std::expected<WorkerProcess, std::string> take_process();
  void make_ready();
  app::WorkError over_memory();

  WorkerDeskSettings settings_;  // command and memory under the mutex, the others stay
  std::mutex mutex_;
  std::condition_variable_any left_;
  Entries entries_;  // what runs and what waits, in the order in which it came
  std::uint64_t last_id_ = 0;
  SteadyClock clock_;
  std::optional<WorkerProcess> ready_;
};

}  // namespace dripfeed::io
