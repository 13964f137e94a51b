// Blocks the calling thread, which is one of the pool's. A place is taken before a process is, so that waiting costs
// nothing but the thread.
#include "server/io/worker_desk.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <spdlog/spdlog.h>

namespace dripfeed::io {

namespace {

using app::WorkError;
using app::WorkFault;

constexpr std::chrono::milliseconds kLookEvery{100};
// The work looks at its own budget and says what it knows; only what does not come to that is killed.
constexpr std::chrono::seconds kGrace{5};

bool has_left(int peer) {
  if (peer < 0) return false;
  pollfd polled{peer, POLLRDHUP, 0};
  return ::poll(&polled, 1, 0) > 0 && (polled.revents & (POLLRDHUP | POLLHUP | POLLERR | POLLNVAL)) != 0;
}

WorkError abandoned(const app::Waiter& waiter) {
  return {WorkFault::abandoned, waiter.stop.stop_requested() ? "the server is stopping" : "the client has left"};
}

}  // namespace

WorkerDesk::WorkerDesk(WorkerDeskSettings settings) : settings_(std::move(settings)) { make_ready(); }

WorkerDesk::Load WorkerDesk::load() {
  const std::lock_guard lock(mutex_);
  return load_;
}

std::optional<WorkError> WorkerDesk::take_place(const app::Waiter& waiter) {
  std::unique_lock lock(mutex_);
  if (load_.working >= settings_.at_once && load_.waiting >= settings_.waiting) {
    return WorkError{WorkFault::busy, fmt::format("{} checks are being made and {} more wait: ask again in a while",
                                                  load_.working, load_.waiting)};
  }
  ++load_.waiting;
  while (load_.working >= settings_.at_once && !waiter.stop.stop_requested() && !has_left(waiter.peer))
    left_.wait_for(lock, kLookEvery);
  --load_.waiting;
  if (load_.working >= settings_.at_once) return abandoned(waiter);
  ++load_.working;
  return std::nullopt;
}

void WorkerDesk::leave_place() {
  {
    const std::lock_guard lock(mutex_);
    --load_.working;
  }
  left_.notify_one();
}

// The one that is ready, unless it has been killed meanwhile.
std::expected<WorkerProcess, std::string> WorkerDesk::take_process() {
  {
    const std::lock_guard lock(mutex_);
    if (ready_ && !ready_->has_ended()) {
      std::expected<WorkerProcess, std::string> taken = std::move(*ready_);
      ready_.reset();
      return taken;
    }
    ready_.reset();
  }
  return WorkerProcess::start(settings_.command);
}

void WorkerDesk::make_ready() {
  auto started = WorkerProcess::start(settings_.command);
  if (!started) return;  // the next piece of work tries again, and reports why there is no process
  const std::lock_guard lock(mutex_);
  if (!ready_) ready_.emplace(std::move(*started));
}

class WorkerDesk::Place {
 public:
  explicit Place(WorkerDesk& desk) : desk_(desk) {}
  ~Place() { desk_.leave_place(); }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

 private:
  WorkerDesk& desk_;
};

std::expected<std::string, WorkError> WorkerDesk::carry_out(std::string_view request, std::uint32_t seconds,
                                                            const app::Waiter& waiter) {
  if (auto refused = take_place(waiter)) return std::unexpected(std::move(*refused));
  const Place place(*this);
  auto process = take_process();
  if (!process) return std::unexpected(WorkError{WorkFault::not_begun, "no process for a check: " + process.error()});
  make_ready();
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds) + kGrace;
  bool is_late = false;
  const auto goes_on = [&](bool peer_left) {
    is_late = seconds > 0 && std::chrono::steady_clock::now() >= end;
    return !is_late && !peer_left && !waiter.stop.stop_requested();
  };
  WorkerProcess::Exchange done = process->exchange(request, waiter.peer, goes_on);
  if (is_late)
    return std::unexpected(
        WorkError{WorkFault::time, fmt::format("the check was stopped at the budget of {} s", seconds)});
  if (done.was_given_up) return std::unexpected(abandoned(waiter));
  if (done.end.is_good()) return std::move(done.reply);
  if (done.end.signal == 0 && done.end.exit_code == settings_.memory_exit_code)
    return std::unexpected(WorkError{WorkFault::memory, fmt::format("the program needs more than {} MB to be checked",
                                                                    settings_.memory_bytes >> 20U)});
  const std::string how = done.end.signal != 0 ? fmt::format("signal {}", done.end.signal)
                                               : fmt::format("exit code {}", done.end.exit_code);
  spdlog::error("a check ended abnormally ({}): its program is to be looked at", how);
  return std::unexpected(WorkError{
      WorkFault::ended, fmt::format("the check ended abnormally ({}): nothing is known of the program", how)});
}

}  // namespace dripfeed::io
