// Hands work to worker processes: so many at once, so many more that wait, the rest is sent away. One process is kept
// ready, so that a short piece of work need not wait for one to start; each does one piece of work and ends.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "server/app/ports/workplace.h"
#include "server/io/spawned_worker.h"

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

  struct Load {
    unsigned working = 0;
    unsigned waiting = 0;
  };
  [[nodiscard]] Load load();
  // Threads that may be in carry_out() before one is sent away, and that one.
  [[nodiscard]] unsigned threads() const { return settings_.at_once + settings_.waiting + 1; }

 private:
  class Place;
  std::optional<app::WorkError> take_place(const app::Waiter& waiter);
  void leave_place();
  std::expected<WorkerProcess, std::string> take_process();
  void make_ready();

  const WorkerDeskSettings settings_;
  std::mutex mutex_;
  std::condition_variable_any left_;
  Load load_;
  std::optional<WorkerProcess> ready_;
};

}  // namespace dripfeed::io
