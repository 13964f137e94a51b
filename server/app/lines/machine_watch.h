// What is known of a machine by its PLC's words: its report, its doorbell, and when to look again while no job makes
// the requests anyway. Makes no request itself.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/modbus/doorbell.h"
#include "server/app/lines/line.h"

namespace dripfeed::app {

class MachineWatch {
 public:
  using Time = std::chrono::nanoseconds;
  // A PLC that does not answer is asked less and less often, so that a dead one leaves the bus to the others.
  static constexpr Time kLongestPoll = std::chrono::seconds(5);
  // Words that were not there are looked for this often.
  static constexpr Time kAskAgain = std::chrono::seconds(60);

  explicit MachineWatch(Time idle_poll) : idle_poll_(idle_poll), wait_(idle_poll) {}

  // Registers to be read from the status on; where a write is answered together with them, the words only if they are
  // known to be there.
  [[nodiscard]] std::size_t registers() const { return probe_.registers(); }
  [[nodiscard]] std::size_t registers_with_write() const;
  // They were read / were not.
  void read(std::span<const std::uint16_t> registers, Time now);
  void read_failed(bool refused, Time now);  // refused: by an exception; else no answer came

  [[nodiscard]] Time next_look() const { return next_look_; }
  [[nodiscard]] const std::optional<MachineReport>& report() const { return report_; }
  modbus::Doorbell& bell() { return bell_; }
  // It does not answer: more than one lost answer.
  [[nodiscard]] bool is_away() const;
  // The stall that the machine itself makes; "" while it makes none.
  [[nodiscard]] std::string_view stall() const;

 private:
  Time idle_poll_;
  Time wait_;
  Time next_look_{};
  Time asked_at_{};
  int failures_ = 0;  // in a row
  modbus::WordsProbe probe_;
  modbus::Doorbell bell_;
  modbus::MachineState state_ = modbus::MachineState::unknown;
  std::optional<MachineReport> report_;
};

}  // namespace dripfeed::app
