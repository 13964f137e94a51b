// Collects motions and hands them to the sink in batches. It stamps each with its place and with the work that was done
// since the motion before.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/interpreter/state/run_budget.h"
#include "dialects/ir/motion.h"

namespace dripfeed::interpreter {

// Counts as ir::ComputeCounts has them, wide enough never to wrap in a run; a motion gets them capped.
struct Work {
  std::uint64_t blocks = 0;
  std::uint64_t number_reads = 0;
  std::uint64_t number_writes = 0;
  std::uint64_t named_reads = 0;
  std::uint64_t named_writes = 0;
  std::uint64_t operators = 0;
  std::uint64_t functions = 0;
  std::uint64_t jumps = 0;
  std::uint64_t rounds = 0;
  std::uint64_t calls = 0;
  std::uint64_t indexed = 0;

  void add(const Work& more) {  // once a block
    blocks += more.blocks;
    number_reads += more.number_reads;
    number_writes += more.number_writes;
    named_reads += more.named_reads;
    named_writes += more.named_writes;
    operators += more.operators;
    functions += more.functions;
    jumps += more.jumps;
    rounds += more.rounds;
    calls += more.calls;
    indexed += more.indexed;
  }
  bool operator==(const Work&) const = default;
};

class MotionBuffer {
 public:
  MotionBuffer(ir::MotionSink& sink, RunBudget& budget);

  // The next motion, blank but for place and work. Valid until the next call. Throws BudgetUsedUp.
  ir::Motion& add(ir::MotionKind kind);
  // From here on motions are kept there instead, until nullptr is given; the place must outlive it.
  void capture(std::vector<ir::Motion>* into) { captured_ = into; }
  [[nodiscard]] std::vector<ir::Motion>* captured() const { return captured_; }
  // Keeps everything until it is let go: a move that is in the buffer may still be changed by the one that follows.
  void hold(bool on) { held_ = on; }
  // The same for the straight moves that stand for a spline.
  void hold_spline(bool on) { held_for_spline_ = on; }
  // The same for the pieces of a move on a face or cylinder.
  void hold_plane(bool on) { held_for_plane_ = on; }
  // Takes the motions from `first` on back out of the buffer.
  std::vector<ir::Motion> take_back(std::size_t first);
  // The first `taken` motions that are kept are replaced by others, which are handed over.
  void replace(std::size_t taken, const std::vector<ir::Motion>& made);
  // The move that was added last, as far back as it is remembered; nullptr when there is none.
  [[nodiscard]] const ir::Motion* last_move() const;
  // Of the motions that are kept: here, or where they are captured.
  [[nodiscard]] std::size_t used() const { return captured_ != nullptr ? captured_->size() : used_; }
  [[nodiscard]] ir::Motion& at(std::size_t index) {
    return captured_ != nullptr ? (*captured_)[index] : motions_[index];
  }
  // Nothing waits any more, and nothing is captured: the run was broken off.
  void let_go() {
    captured_ = nullptr;
    held_ = held_for_spline_ = held_for_plane_ = false;
  }
  // Hands over what is there.
  void flush();
  [[nodiscard]] std::uint64_t count() const { return flushed_ + used_; }

  ir::Place place;  // of the block that is executed
  Work work;        // since the last motion

 private:
  ir::MotionSink& sink_;
  RunBudget& budget_;
  std::vector<ir::Motion> motions_;
  std::size_t used_ = 0;
  std::size_t remembered_ = 0;  // from used_ on up to here: what was handed over last
  bool held_ = false;
  bool held_for_spline_ = false;
  bool held_for_plane_ = false;
  std::uint64_t flushed_ = 0;
  std::vector<ir::Motion>* captured_ = nullptr;
};

}  // namespace dripfeed::interpreter
