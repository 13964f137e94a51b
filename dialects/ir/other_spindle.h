// What a block orders of a spindle that it names by a number, as the argument of Function::other_spindle: the number of
// the spindle, and its M function or that a speed is meant. Which spindle is the main one, only the run knows.
#pragma once

#include <cstdint>

namespace dripfeed::ir {

inline constexpr std::uint32_t kMostSpindles = 9;

// As M functions; those of the gear change nothing that is modelled.
inline constexpr int kTurnsClockwise = 3;
inline constexpr int kTurnsCounterclockwise = 4;
inline constexpr int kStopsSpindle = 5;
inline constexpr int kOrientsSpindle = 19;
inline constexpr int kSpindleSpeed = 0;          // by Address::other_speed of the block
inline constexpr int kSpindleSpeedUnknown = 99;  // by a word, which the block holds no longer

constexpr std::int16_t spindle_order(std::uint32_t number, int order) {
  return static_cast<std::int16_t>(static_cast<int>(number) * 100 + order);
}
constexpr std::uint32_t number_of_spindle(std::int16_t argument) { return static_cast<std::uint32_t>(argument / 100); }
constexpr int order_of_spindle(std::int16_t argument) { return argument % 100; }

}  // namespace dripfeed::ir
