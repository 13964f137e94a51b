// The machine's own words after the status image: what it runs, its state, its alarm, and the doorbell by which it
// asks for something. A receiver may lack them. What a ring means and when it counts is doorbell's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string_view>

#include "protocol/modbus/mailbox.h"

namespace dripfeed::modbus {

// M, right after G: receiver to host, in the same read.
inline constexpr std::size_t kMachineRegisters = 14;
inline constexpr std::size_t kStatusAndMachine = kStatusRegisters + kMachineRegisters;
using MachineImage = std::array<std::uint16_t, kMachineRegisters>;
inline constexpr std::uint16_t kMachineMagic = 0xDF03;

enum class MachineState : std::uint16_t {
  unknown = 0,
  idle = 1,
  running = 2,
  held = 3,  // feed hold, or stopped by the program
  alarm = 4,
  emergency_stop = 5,
  manual = 6,
};
std::string_view name(MachineState state);

struct MachineWords {
  MachineState state = MachineState::unknown;
  std::uint32_t program = 0;  // its number; 0: none, or not known
  std::uint32_t line = 0;     // of the text that is executed, from 1; 0: not known
  std::uint32_t alarm = 0;    // the control's own number; 0: none
  std::uint16_t bell = 0;     // counts the rings; 0: none since the start
  std::uint16_t request = 0;  // BellRequest
  std::uint32_t requested = 0;
  friend bool operator==(const MachineWords&, const MachineWords&) = default;
};
void encode(const MachineWords& words, MachineImage& out);

enum class MachineFault : std::uint8_t {
  absent,   // no such words there
  garbled,  // the check sum does not fit: read while being written; read again
};
// registers: kMachineRegisters of them. A state that is not in the table is `unknown`.
std::expected<MachineWords, MachineFault> decode_machine(std::span<const std::uint16_t> registers);

// Whether the words can be read together with the status. A receiver without them may answer a longer read with an
// exception, or not at all; a failure that has another cause must not hide them for good.
class WordsProbe {
 public:
  // Registers to be read, from the status on.
  [[nodiscard]] std::size_t registers() const { return reads_all_ ? kStatusAndMachine : kStatusRegisters; }
  [[nodiscard]] bool proved() const { return proved_; }
  // The read of so many was answered / was not.
  void answered();
  void failed();
  // Some time passed: words that were absent may be there now.
  void ask_again();

 private:
  static constexpr int kDoubts = 2;
  [[nodiscard]] bool absent() const { return doubts_ >= kDoubts; }

  bool reads_all_ = true;
  bool proved_ = false;
  int failures_ = 0;  // in a row
  int doubts_ = 0;    // a short read was answered where a long one was not
};

}  // namespace dripfeed::modbus
