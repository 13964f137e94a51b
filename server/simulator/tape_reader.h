// What a control makes of the characters of a program, however they reach it: skips the leader, gathers blocks, runs
// whole ones as long as they take and never an unfinished one, and knows how full its buffer is.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "server/simulator/block_clock.h"
#include "server/simulator/control.h"

namespace dripfeed::simulator {

class TapeReader {
 public:
  TapeReader(const BlockClockSettings& clock, double speed) : settings_(clock), speed_(speed), clock_(clock) {}

  void start(Time_ns now);
  // The operator presses RESET: what was not run is dropped.
  void reset();
  void take(char character, Time_ns at);
  void run(Time_ns now);

  // Bytes of blocks that are not run yet, the unfinished one's included.
  [[nodiscard]] std::uint64_t buffered() const { return buffered_; }
  [[nodiscard]] bool at_end() const { return at_end_; }  // the '%' after the program was read
  [[nodiscard]] bool has_begun() const { return seen_percent_; }
  [[nodiscard]] bool is_busy() const { return running_ || !blocks_.empty(); }
  [[nodiscard]] std::optional<Time_ns> runs_until() const {
    return running_ ? std::optional(run_until_) : std::nullopt;
  }
  [[nodiscard]] Time_ns last_run() const { return run_until_; }
  // "" or why a block could not be run.
  [[nodiscard]] std::string_view fault() const { return clock_.fault(); }
  // Lays its counters over the report's.
  void report(ControlReport& report) const;

 private:
  struct Block {
    std::string text;
    std::uint64_t bytes = 0;
  };

  void finish_block(Time_ns at);

  BlockClockSettings settings_;
  double speed_;
  BlockClock clock_;
  std::deque<Block> blocks_;
  std::string block_;
  std::uint64_t block_bytes_ = 0;
  std::uint64_t buffered_ = 0;
  bool label_skip_ = true;
  bool seen_percent_ = false;
  bool at_end_ = false;
  bool running_ = false;
  Time_ns run_until_ = 0;
  std::optional<Time_ns> dry_since_;  // it ran out of blocks after the first one
  std::uint64_t blocks_run_ = 0;
  std::uint64_t bytes_run_ = 0;
  std::uint64_t stalls_ = 0;
  double stall_s_ = 0.0;
};

}  // namespace dripfeed::simulator
