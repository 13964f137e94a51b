// Who may write next: the ledger before everybody else. What a feed waits for is never longer than the one transaction
// that is being made, and transactions are kept short (a long text is written in slices).
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace dripfeed::sqlite {

enum class Turn : std::uint8_t {
  in_order,  // when nobody who goes first waits
  first,     // the ledger
};

class WriteLane {
 public:
  void enter(Turn turn) {
    std::unique_lock lock(mutex_);
    if (turn == Turn::first) {
      ++first_waiting_;
      free_.wait(lock, [this] { return !taken_; });
      --first_waiting_;
    } else {
      free_.wait(lock, [this] { return !taken_ && first_waiting_ == 0; });
    }
    taken_ = true;
  }
  void leave() {
    {
      const std::lock_guard lock(mutex_);
      taken_ = false;
    }
    free_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable free_;
  bool taken_ = false;
  std::uint32_t first_waiting_ = 0;
};

}  // namespace dripfeed::sqlite
