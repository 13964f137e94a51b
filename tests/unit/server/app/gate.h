// Holds up whoever comes by until it is opened: for a commit that takes its time.
#pragma once

#include <condition_variable>
#include <mutex>

namespace dripfeed::app::test {

class Gate {
 public:
  void pass() {
    std::unique_lock lock(mutex_);
    someone_waits_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return open_; });
  }
  // Until a person stands before it.
  void await_someone() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return someone_waits_; });
  }
  void open() {
    const std::lock_guard lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool someone_waits_ = false;
  bool open_ = false;
};

}  // namespace dripfeed::app::test
