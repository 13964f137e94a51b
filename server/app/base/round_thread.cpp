// A round covers the calls of wait_for_round() that came before it began.
#include "server/app/base/round_thread.h"

#include <utility>

#include <sys/prctl.h>
#include <sys/resource.h>

#include "server/app/base/fence.h"

namespace dripfeed::app {

namespace {

constexpr int kBeforeOthers = -10;  // nice value; refused without the right to it, and then the usual one stays

}  // namespace

RoundThread::RoundThread(std::string name, std::chrono::milliseconds period, Urgency urgency,
                         std::function<void()> round)
    : name_(std::move(name)),
      period_(period),
      urgency_(urgency),
      round_(std::move(round)),
      thread_([this](const std::stop_token& stop) { loop(stop); }) {}

RoundThread::~RoundThread() { stop(); }

void RoundThread::wake() {
  const std::lock_guard lock(mutex_);
  due_ = true;
  woken_.notify_one();
}

bool RoundThread::wait_for_round(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  const std::uint64_t mine = ++wanted_;
  due_ = true;
  woken_.notify_one();
  round_over_.wait_for(lock, patience, [&] { return done_ >= mine || over_; });
  return done_ >= mine;
}

void RoundThread::stop() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

void RoundThread::loop(const std::stop_token& stop) {
  ::prctl(PR_SET_NAME, name_.c_str());
  // Linux keeps a nice value per thread; 0 names the calling one.
  if (urgency_ == Urgency::before_others) {
    static_cast<void>(::setpriority(PRIO_PROCESS, 0, kBeforeOthers));
    LineWaits::serve_lines_here();
  }
  for (bool last = false; !last;) {
    std::uint64_t covers = 0;
    {
      std::unique_lock lock(mutex_);
      woken_.wait_for(lock, stop, period_, [this] { return due_; });
      due_ = false;
      covers = wanted_;
      last = stop.stop_requested();
    }
    fenced(name_, round_);
    const std::lock_guard lock(mutex_);
    done_ = covers;
    over_ = last;
    round_over_.notify_all();
  }
}

}  // namespace dripfeed::app
