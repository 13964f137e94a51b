// The thread asks with poll() before it writes, and writes no more than a pipe takes at once, so that it seldom hangs;
// but it may (a file on a network drive), and nothing waits for it longer than kPatience.
#include "server/cli/logging.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "server/io/steady_clock.h"
#include "server/json/records.h"

namespace dripfeed::cli {

namespace {

constexpr std::chrono::milliseconds kPatience{500};  // at the end
constexpr int kLook_ms = 50;

// False once it cannot be written for good: its reader is gone, or the terminal.
bool write_whole(int descriptor, std::string_view text, const std::atomic<bool>& given_up) {
  while (!text.empty()) {
    pollfd output{.fd = descriptor, .events = POLLOUT, .revents = 0};
    const int ready = ::poll(&output, 1, kLook_ms);
    if (given_up) return false;
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t count = ::write(descriptor, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
    if (count < 0 && errno == EAGAIN) std::this_thread::sleep_for(std::chrono::milliseconds(kLook_ms));
    if (count < 0 && errno != EAGAIN && errno != EINTR) return false;
  }
  return true;
}

// A sentence of the command itself as a line.
std::string line_of(LogForm form, std::string_view sentence) {
  return form == LogForm::json ? json::log_line(io::SteadyClock().wall_ms(), "info", sentence) + "\n"
                               : fmt::format("dripfeed: {}\n", sentence);
}

}  // namespace

struct LineQueue::Shared {
  Shared(int output, LogForm of) : descriptor(output), form(of) {}

  const int descriptor;
  const LogForm form;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::string> lines;  // under mutex, as what follows
  std::size_t bytes = 0;
  std::uint64_t dropped = 0;  // since the last line was taken out
  bool ending = false;
  bool idle = false;  // the thread is over
  std::atomic<bool> given_up = false;
};

LineQueue::LineQueue(int descriptor, LogForm form) : shared_(std::make_shared<Shared>(descriptor, form)) {
  std::thread([shared = shared_] {
    ::pthread_setname_np(::pthread_self(), "log");
    write_until_the_end(shared);
    const std::lock_guard lock(shared->mutex);
    shared->idle = true;
    shared->changed.notify_all();
  }).detach();
}

LineQueue::~LineQueue() {
  std::unique_lock lock(shared_->mutex);
  shared_->ending = true;
  shared_->changed.notify_all();
  shared_->changed.wait_for(lock, kPatience, [this] { return shared_->idle; });
  shared_->given_up = true;
}

LogForm LineQueue::form() const { return shared_->form; }

void LineQueue::push(std::string line) {
  {
    const std::lock_guard lock(shared_->mutex);
    if (shared_->ending) return;
    shared_->bytes += line.size();
    shared_->lines.push_back(std::move(line));
    while (shared_->lines.size() > kMostLines || (shared_->bytes > kMostBytes && shared_->lines.size() > 1)) {
      shared_->bytes -= shared_->lines.front().size();
      shared_->lines.pop_front();
      ++shared_->dropped;
    }
  }
  shared_->changed.notify_one();
}

// The fence of this thread: where memory is out a line is lost, and nothing else.
void LineQueue::write_until_the_end(const std::shared_ptr<Shared>& shared) {
  for (;;) {
    try {
      return write_lines(shared);
    } catch (const std::bad_alloc&) {
      const std::lock_guard lock(shared->mutex);
      ++shared->dropped;
    }
  }
}

void LineQueue::write_lines(const std::shared_ptr<Shared>& shared) {
  std::unique_lock lock(shared->mutex);
  for (;;) {
    shared->changed.wait(lock, [&] { return shared->ending || !shared->lines.empty(); });
    if (shared->lines.empty()) return;
    std::string text = std::move(shared->lines.front());
    shared->lines.pop_front();
    shared->bytes -= text.size();
    if (const std::uint64_t dropped = std::exchange(shared->dropped, 0); dropped > 0) {
      text =
          line_of(shared->form,
                  fmt::format("{} lines of the log were dropped here, because they were not read in time", dropped)) +
          text;
    }
    lock.unlock();
    const bool written = write_whole(shared->descriptor, text, shared->given_up);
    lock.lock();
    if (written) continue;
    // No one will ever read it. What is put in from now on is dropped without a count.
    shared->ending = true;
    return;
  }
}

namespace {

// One a process, while a Logging lives.
struct Outputs {
  std::mutex mutex;
  std::shared_ptr<LineQueue> messages;
  std::shared_ptr<LineQueue> announcements;
};
Outputs& outputs() {
  static Outputs* const only = new Outputs;  // never destroyed: a thread may log while the process ends
  return *only;
}

using Which = std::shared_ptr<LineQueue> Outputs::*;

void put(Which which, int descriptor, std::string line) {
  std::shared_ptr<LineQueue> queue;
  {
    const std::lock_guard lock(outputs().mutex);
    queue = outputs().*which;
  }
  if (queue) return queue->push(std::move(line));
  std::string_view rest = line;
  while (!rest.empty()) {
    const ssize_t count = ::write(descriptor, rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
}

// Formats in the thread that logs, so that the time is that of the event; the queue takes the line.
class QueueSink final : public spdlog::sinks::sink {
 public:
  void log(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t line;
    {
      const std::lock_guard lock(mutex_);
      formatter_->format(message, line);
    }
    put(&Outputs::messages, STDERR_FILENO, std::string(line.data(), line.size()));
  }
  void flush() override {}
  void set_pattern(const std::string& pattern) override {
    set_formatter(std::make_unique<spdlog::pattern_formatter>(pattern));
  }
  void set_formatter(std::unique_ptr<spdlog::formatter> formatter) override {
    const std::lock_guard lock(mutex_);
    formatter_ = std::move(formatter);
  }

 private:
  std::mutex mutex_;
  std::unique_ptr<spdlog::formatter> formatter_ = std::make_unique<spdlog::pattern_formatter>();
};

class JsonFormatter final : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& into) override {
    const auto at = std::chrono::duration_cast<std::chrono::milliseconds>(message.time.time_since_epoch());
    const auto level = spdlog::level::to_string_view(message.level);
    const std::string line = json::log_line(at.count(), std::string_view(level.data(), level.size()),
                                            std::string_view(message.payload.data(), message.payload.size()));
    into.append(line);
    into.push_back('\n');
  }
  [[nodiscard]] std::unique_ptr<spdlog::formatter> clone() const override { return std::make_unique<JsonFormatter>(); }
};

}  // namespace

Logging::Logging(LogForm form) {
  {
    const std::lock_guard lock(outputs().mutex);
    outputs().messages = std::make_shared<LineQueue>(STDERR_FILENO, form);
    outputs().announcements = std::make_shared<LineQueue>(STDOUT_FILENO);
  }
  const auto sink = std::make_shared<QueueSink>();
  if (form == LogForm::json) sink->set_formatter(std::make_unique<JsonFormatter>());
  spdlog::set_default_logger(std::make_shared<spdlog::logger>("", sink));
}

Logging::~Logging() {
  std::shared_ptr<LineQueue> messages;
  std::shared_ptr<LineQueue> announcements;
  const std::lock_guard lock(outputs().mutex);
  std::swap(messages, outputs().messages);
  std::swap(announcements, outputs().announcements);
}

void say(std::string_view sentence) {
  const auto form = [] {
    const std::lock_guard lock(outputs().mutex);
    return outputs().messages ? outputs().messages->form() : LogForm::text;
  };
  put(&Outputs::messages, STDERR_FILENO, line_of(form(), sentence));
}

void announce(std::string_view line) { put(&Outputs::announcements, STDOUT_FILENO, fmt::format("{}\n", line)); }

}  // namespace dripfeed::cli
