// How long a plain block takes on the simulated machine: its own small reader of words and its own motion arithmetic
// (constant acceleration from rest to rest). Deliberately independent of the interpreter and of the planner: it is the
// judge's stopwatch.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace dripfeed::simulator {

struct BlockClockSettings {
  bool x_is_diameter = false;
  char comment_open = '(';  // '(' to ')'; ';' to the end of the block
  double rapid_mm_min = 10'000.0;
  double acceleration_mm_s2 = 1000.0;
  double block_ms = 1.0;  // what computing any block takes
};

class BlockClock {
 public:
  explicit BlockClock(const BlockClockSettings& settings) : settings_(settings) {}

  // Seconds that this block takes, its EOB left out. Blocks that it cannot read (a loop, a jump) are not run: see
  // fault().
  double run(std::string_view block);
  // Empty, or why the last block could not be run.
  [[nodiscard]] std::string_view fault() const { return fault_; }
  // M30, M02 (M17 with ';' comments) was run.
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  struct Words;
  bool read(std::string_view block, Words& words);
  bool read_word(std::string_view block, std::size_t& i, Words& words);
  bool skip_name(std::string_view block, std::size_t& i);
  void apply_code(int code);
  void apply_function(int code);
  double move_s(const Words& words);
  [[nodiscard]] double speed_mm_s(double x_mm) const;

  BlockClockSettings settings_;
  std::array<double, 26> position_{};
  int motion_ = 0;
  bool incremental_ = false;
  bool inch_ = false;
  bool per_revolution_ = false;
  bool surface_speed_ = false;
  double feed_ = 0.0;
  double spindle_ = 0.0;
  bool ended_ = false;
  std::string_view fault_;
};

}  // namespace dripfeed::simulator
