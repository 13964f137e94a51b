// Blocks the calling thread, which is one of the pool's. A place is taken before a process is, so that waiting costs
// nothing but the thread.
#include "server/io/worker_desk.h"

#include <algorithm>
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

std::vector<app::Work> WorkerDesk::works() {
  const std::lock_guard lock(mutex_);
  std::vector<app::Work> all;
  std::uint32_t place = 0;
  for (const Entry& entry : entries_) {
    all.push_back(entry.work);
    if (entry.waits()) all.back().place = ++place;
  }
  return all;
}

bool WorkerDesk::cancel(std::uint64_t work, std::string_view by) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(entries_, work, [](const Entry& entry) { return entry.work.id; });
    if (found == entries_.end()) return false;
    if (!found->cancelled_by) found->cancelled_by = by;
  }
  left_.notify_all();
  return true;
}

unsigned WorkerDesk::working() const {
  return static_cast<unsigned>(std::ranges::count_if(entries_, [](const Entry& entry) { return !entry.waits(); }));
}

// The first of those that wait, and there is a place.
bool WorkerDesk::is_next(Entries::const_iterator entry) const {
  const auto first = std::ranges::find_if(entries_, &Entry::waits);
  return first == entry && working() < settings_.at_once;
}

bool WorkerDesk::is_cancelled(Entries::const_iterator entry) {
  const std::lock_guard lock(mutex_);
  return entry->cancelled_by.has_value();
}

WorkError WorkerDesk::given_up(Entries::const_iterator entry, const app::Waiter& waiter) {
  const std::lock_guard lock(mutex_);
  if (!entry->cancelled_by) return abandoned(waiter);
  return {WorkFault::cancelled, fmt::format("it was cancelled by {}: nothing is known of it", *entry->cancelled_by)};
}

std::expected<WorkerDesk::Entries::iterator, WorkError> WorkerDesk::take_place(const app::Waiter& waiter,
                                                                               std::uint32_t seconds) {
  std::unique_lock lock(mutex_);
  const unsigned working_now = working();
  const std::size_t waiting = entries_.size() - working_now;
  if (working_now >= settings_.at_once && waiting >= settings_.waiting) {
    return std::unexpected(WorkError{
        WorkFault::busy,
        fmt::format("{} checks are being made and {} more wait: ask again in a while", working_now, waiting)});
  }
  const app::Work work{.id = ++last_id_,
                       .name = waiter.work,
                       .waiting_since_ms = clock_.wall_ms(),
                       .running_since_ms = 0,
                       .place = 0,
                       .budget_s = seconds};
  const auto entry = entries_.insert(entries_.end(), Entry{.work = work, .cancelled_by = std::nullopt});
  while (!is_next(entry) && !entry->cancelled_by && !waiter.stop.stop_requested() && !has_left(waiter.peer))
    left_.wait_for(lock, kLookEvery);
  if (is_next(entry) && !entry->cancelled_by) {
    entry->work.running_since_ms = clock_.wall_ms();
    lock.unlock();
    left_.notify_all();  // another place may be free for the next one
    return entry;
  }
  lock.unlock();
  WorkError error = given_up(entry, waiter);
  leave_place(entry);
  return std::unexpected(std::move(error));
}

void WorkerDesk::leave_place(Entries::iterator entry) {
  {
    const std::lock_guard lock(mutex_);
    entries_.erase(entry);
  }
  left_.notify_all();
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
  return WorkerProcess::start(command());
}

void WorkerDesk::set_command(std::vector<std::string> command, std::uint64_t memory_bytes) {
  {
    const std::lock_guard lock(mutex_);
    settings_.command = std::move(command);
    settings_.memory_bytes = memory_bytes;
    ready_.reset();
  }
  make_ready();
}

std::vector<std::string> WorkerDesk::command() {
  const std::lock_guard lock(mutex_);
  return settings_.command;
}

void WorkerDesk::make_ready() {
  const std::vector<std::string> command = this->command();
  auto started = WorkerProcess::start(command);
  if (!started) return;  // the next piece of work tries again, and reports why there is no process
  const std::lock_guard lock(mutex_);
  if (!ready_ && command == settings_.command) ready_.emplace(std::move(*started));
}

app::WorkError WorkerDesk::over_memory() {
  const std::lock_guard lock(mutex_);
  return {app::WorkFault::memory,
          fmt::format("the program needs more than {} MB to be checked", settings_.memory_bytes >> 20U)};
}

class WorkerDesk::Place {
 public:
  Place(WorkerDesk& desk, Entries::iterator entry) : desk_(desk), entry_(entry) {}
  ~Place() { desk_.leave_place(entry_); }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

 private:
  WorkerDesk& desk_;
  Entries::iterator entry_;
};

std::expected<std::string, WorkError> WorkerDesk::carry_out(std::string_view request, std::uint32_t seconds,
                                                            const app::Waiter& waiter) {
  const auto entry = take_place(waiter, seconds);
  if (!entry) return std::unexpected(entry.error());
  const Place place(*this, *entry);
  auto process = take_process();
  if (!process) return std::unexpected(WorkError{WorkFault::not_begun, "no process for a check: " + process.error()});
  make_ready();
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds) + kGrace;
  bool is_late = false;
  const auto goes_on = [&](bool peer_left) {
    is_late = seconds > 0 && std::chrono::steady_clock::now() >= end;
    return !is_late && !peer_left && !waiter.stop.stop_requested() && !is_cancelled(*entry);
  };
  WorkerProcess::Exchange done = process->exchange(request, waiter.peer, goes_on);
  if (is_late)
    return std::unexpected(
        WorkError{WorkFault::time, fmt::format("the check was stopped at the budget of {} s", seconds)});
  if (done.was_given_up) return std::unexpected(given_up(*entry, waiter));
  if (done.end.is_good()) return std::move(done.reply);
  if (done.end.signal == 0 && done.end.exit_code == settings_.memory_exit_code) return std::unexpected(over_memory());
  const std::string how = done.end.signal != 0 ? fmt::format("signal {}", done.end.signal)
                                               : fmt::format("exit code {}", done.end.exit_code);
  spdlog::error("a check ended abnormally ({}): its program is to be looked at", how);
  return std::unexpected(WorkError{
      WorkFault::ended, fmt::format("the check ended abnormally ({}): nothing is known of the program", how)});
}

}  // namespace dripfeed::io
