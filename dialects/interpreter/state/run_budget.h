// What a run may still use: motions, room for motions that wait, and whatever the caller measures (time). Everything
// that makes motions or goes round in circles asks here; what is used up is thrown, because an emitter is deep in its
// cycle by then, and Machine catches it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "dialects/interpreter/interpreter.h"

namespace dripfeed::interpreter {

// "motions", "60 s": as "limit of ..." says it.
struct BudgetUsedUp {
  std::string what;
};

class RunBudget {
 public:
  explicit RunBudget(const RunOptions& options) : options_(options), until_asked_(kAskEvery) { until_full_ = stride(); }

  // One motion more, or throws.
  void take_motion() {
    if (until_full_-- == 0) [[unlikely]]
      refill();
  }
  // One block or pass of a loop more; counting them is the machine's.
  void take_step() {
    if (--until_asked_ == 0) [[unlikely]]
      ask();
  }
  // So many motions wait for what follows them.
  void keep(std::size_t motions) const {
    if (is_open_ && motions > options_.limits.kept_motions) [[unlikely]]
      throw BudgetUsedUp{"motions that wait for a later block"};
  }
  // The run has ended: what is left to be tidied up is not counted.
  void close() { is_open_ = false; }

 private:
  static constexpr std::uint32_t kAskEvery = 4096;

  std::uint32_t stride();
  void refill();
  void ask();

  const RunOptions& options_;
  std::uint64_t taken_ = 0;  // motions that were allowed so far
  std::uint32_t until_full_ = 0;
  std::uint32_t until_asked_;
  bool is_open_ = true;
};

}  // namespace dripfeed::interpreter
