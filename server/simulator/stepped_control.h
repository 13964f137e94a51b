// The judge: a simulated machine that moves in steps of a millisecond, in virtual time. It reads plain blocks of
// straight moves and dwells by itself, receives them over a line of its own, and integrates speed from what it has
// received; it shares no code with the checks, so that their predictions can be compared with it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::simulator {

struct SteppedSettings {
  std::array<double, 3> acceleration_mm_s2{1000, 1000, 1000};
  std::array<double, 3> rapid_mm_min{20'000, 20'000, 20'000};
  double corner_ms = 4.0;       // each axis may jump by its acceleration times this
  double block_ms = 1.0;        // what computing a block takes
  std::size_t look_ahead = 50;  // computed blocks that the motion sees at a time
  double char_ms = 0.0;         // of the line; 0: the program lies in the memory
  double first_char_ms = 0.0;   // latency
  std::size_t buffer_bytes = 2048;
};

struct SteppedReport {
  double cycle_s = 0.0;
  double first_move_s = 0.0;
  double standstill_s = 0.0;  // without a block, between the first and the last move
  // The first time at which it was slower because it did not know the next block; line 0: never.
  double first_late_s = 0.0;
  std::uint32_t first_late_line = 0;
  std::string fault;  // a block that is not plain
};

// Runs the text to its end, at most `most_s` of virtual time. Lines count from 1.
SteppedReport run_stepped(std::string_view text, const SteppedSettings& settings, double most_s = 36'000.0);

}  // namespace dripfeed::simulator
