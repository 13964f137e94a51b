// A lane is a queue and a few threads.
#include "server/http/lanes.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <sys/prctl.h>

#include "server/app/base/fence.h"

namespace dripfeed::http {

namespace {

struct LaneRow {
  Lane lane;
  const char* thread_name;  // at most 15 characters
  unsigned threads;         // 0: as many as the caller says
  std::size_t most_waiting;
};
// None has a low priority: whoever holds the store's lock must not wait for the processor.
constexpr std::array kLanes = {
    LaneRow{Lane::read, "http read", 4, 1024},
    LaneRow{Lane::command, "http command", 2, 256},
    LaneRow{Lane::arm, "http arm", 4, 64},
    LaneRow{Lane::write, "http write", 8, 1024},
    LaneRow{Lane::bulk, "http bulk", 2, 64},
    LaneRow{Lane::heavy, "http heavy", 0, 32},  // they wait for worker processes, which have the low priority
    LaneRow{Lane::secret, "http secret", 1, 32},
    LaneRow{Lane::provider, "http provider", 4, 32},
    LaneRow{Lane::spool, "http spool", 1, 4096},  // a connection has one piece and one file to close at a time
};
static_assert(kLanes.size() + 1 == kLanesAndHere);

}  // namespace

class Lanes::One {
 public:
  One(const LaneRow& row, unsigned threads) : row_(row) {
    for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { loop(); });
  }
  ~One() {
    for (std::thread& thread : threads_) thread.join();
  }
  One(const One&) = delete;
  One& operator=(const One&) = delete;

  bool submit(Work work) {
    {
      const std::lock_guard lock(mutex_);
      if (stopped_ || waiting_.size() >= row_.most_waiting) return false;
      waiting_.push_back(std::move(work));
    }
    changed_.notify_one();
    return true;
  }

  void stop() {
    std::deque<Work> dropped;  // destroyed without the lock
    {
      const std::lock_guard lock(mutex_);
      stopped_ = true;
      dropped.swap(waiting_);
    }
    changed_.notify_all();
  }

  bool wait_until(std::chrono::steady_clock::time_point until) {
    std::unique_lock lock(mutex_);
    return idle_.wait_until(lock, until, [this] { return at_work_ == 0; });
  }

 private:
  void loop() {
    ::prctl(PR_SET_NAME, row_.thread_name);
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return stopped_ || !waiting_.empty(); });
      if (stopped_) return;
      Work work = std::move(waiting_.front());
      waiting_.pop_front();
      ++at_work_;
      lock.unlock();
      run(work);
      work = nullptr;
      lock.lock();
      --at_work_;
      if (at_work_ == 0) idle_.notify_all();
    }
  }

  // The fence of these threads. A request answers its own faults; what still comes here ends that request alone.
  void run(Work& work) const { app::fenced(row_.thread_name, work); }

  const LaneRow& row_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::condition_variable idle_;
  std::deque<Work> waiting_;
  unsigned at_work_ = 0;
  bool stopped_ = false;
  std::vector<std::thread> threads_;
};

Lanes::Lanes(unsigned heavy_threads) {
  for (std::size_t i = 0; i < kLanes.size(); ++i) {
    const LaneRow& row = kLanes[i];
    lanes_[i] = std::make_unique<One>(row, row.threads == 0 ? heavy_threads : row.threads);
  }
}

Lanes::~Lanes() {
  for (const auto& lane : lanes_) lane->stop();
}

Lanes::One& Lanes::at(Lane lane) { return *lanes_[static_cast<std::size_t>(lane) - 1]; }

bool Lanes::submit(Lane lane, Work work) { return at(lane).submit(std::move(work)); }

bool Lanes::stop(std::chrono::milliseconds at_most) {
  for (const auto& lane : lanes_) lane->stop();
  const auto until = std::chrono::steady_clock::now() + at_most;
  return std::ranges::all_of(lanes_, [&](const auto& lane) { return lane->wait_until(until); });
}

}  // namespace dripfeed::http
