// Who may write next: the ledger before everybody else. What a feed waits for is never longer than the one transaction
// that is being made, and transactions are kept short (a long text is written in slices).
//
// Small changes of many callers may share one commit. The caller that has the lane makes its own, then those of the
// others that wait meanwhile, on its thread, and commits once:
//
//   caller 1   take ── own ── of 2 ── of 3 ── commit ── leave
//   caller 2   wait ───────────────────────────────────┘ durable
//   caller 3        wait ──────────────────────────────┘ durable
//
// It takes no further one once the ledger waits.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "store/error.h"
#include "store/sql/lane_use.h"

namespace dripfeed::sql {

enum class Turn : std::uint8_t {
  in_order,  // when no one who goes first waits
  first,     // the ledger
  taken,     // the caller has the lane already
};

// A change that may be made by another thread, with others, while its caller waits. It lives until enter_shared() or
// leave() returned to its caller.
class SharedChange {
 public:
  SharedChange() = default;
  SharedChange(const SharedChange&) = delete;
  SharedChange& operator=(const SharedChange&) = delete;
  virtual ~SharedChange() = default;
  // Makes it, as a savepoint inside the open transaction. It throws nothing.
  virtual void make() = 0;

  std::optional<store::Error> refused;  // by make(): it alone was undone, unless the engine undid all
  store::Result<void> committed;        // the result of the transaction that it was made in

 private:
  friend class WriteLane;
  bool ended_ = false;
  LaneUse::Clock::time_point wanted_at_{};
};

class WriteLane {
 public:
  static constexpr std::size_t kMostShared = 16;  // in one commit

  // Not for Turn::taken.
  void enter(Turn turn) {
    std::unique_lock lock(mutex_);
    const bool is_first = turn == Turn::first;
    LaneUse& use = is_first ? ledger_use_ : others_use_;
    const auto wanted_at = LaneUse::Clock::now();
    use.waits();
    if (is_first) {
      ++first_waiting_;
      changed_.wait(lock, [this] { return !taken_; });
      --first_waiting_;
    } else {
      changed_.wait(lock, [this] { return !taken_ && first_waiting_ == 0; });
    }
    take(use, wanted_at);
  }

  // True: the caller has the lane, and makes the change and those of next_shared(). False: another made it, and
  // `committed` has the result.
  bool enter_shared(SharedChange& change) {
    std::unique_lock lock(mutex_);
    waiting_.push_back(&change);
    change.wanted_at_ = LaneUse::Clock::now();
    others_use_.waits();
    changed_.wait(lock, [&] { return change.ended_ || (!taken_ && first_waiting_ == 0); });
    if (change.ended_) return false;
    std::erase(waiting_, &change);
    take(others_use_, change.wanted_at_);
    return true;
  }

  // The next change to share the caller's commit with; null where none waits, or the ledger does.
  SharedChange* next_shared() {
    const std::lock_guard lock(mutex_);
    if (first_waiting_ > 0 || waiting_.empty() || made_.size() + 1 >= kMostShared) return nullptr;
    SharedChange* const next = waiting_.front();
    waiting_.pop_front();
    others_use_.begins(next->wanted_at_);
    made_.push_back(next);
    return next;
  }

  // Ends what next_shared() gave: their callers go on.
  void leave() {
    {
      const std::lock_guard lock(mutex_);
      taken_ = false;
      in_turn_->ends(taken_at_);
      for (SharedChange* const change : made_) change->ended_ = true;
      made_.clear();
    }
    changed_.notify_all();
  }

  // From any thread; takes no lock.
  [[nodiscard]] store::StoreUse use() const { return {.ledger = ledger_use_.now(), .others = others_use_.now()}; }

 private:
  // Under the lock.
  void take(LaneUse& use, LaneUse::Clock::time_point wanted_at) {
    taken_ = true;
    in_turn_ = &use;
    taken_at_ = LaneUse::Clock::now();
    use.begins(wanted_at);
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool taken_ = false;
  std::uint32_t first_waiting_ = 0;
  std::deque<SharedChange*> waiting_;  // in their order
  std::vector<SharedChange*> made_;    // by the one that has the lane, besides its own
  LaneUse ledger_use_;
  LaneUse others_use_;
  LaneUse* in_turn_ = &others_use_;  // of the one who has the lane
  LaneUse::Clock::time_point taken_at_{};
};

}  // namespace dripfeed::sql
