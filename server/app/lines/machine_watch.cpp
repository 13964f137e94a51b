// Words that are not answered for any more are dropped at the second failure: one lost answer says nothing.
#include "server/app/lines/machine_watch.h"

#include <algorithm>
#include <array>

#include "protocol/modbus/mailbox.h"

namespace dripfeed::app {

namespace {

constexpr int kFailuresUntilUnknown = 2;
constexpr int kSilencesUntilDoubted = 6;  // that the words are still there, where they were: a bad line loses answers

struct StallRow {
  modbus::MachineState state;
  std::string_view stall;
};
constexpr std::array kStalls = {
    StallRow{modbus::MachineState::held, "machine held"},
    StallRow{modbus::MachineState::alarm, "machine alarm"},
    StallRow{modbus::MachineState::emergency_stop, "machine in emergency stop"},
};

}  // namespace

std::size_t MachineWatch::registers_with_write() const {
  return probe_.proved() ? probe_.registers() : modbus::kStatusRegisters;
}

void MachineWatch::read(std::span<const std::uint16_t> registers, Time now) {
  failures_ = 0;
  wait_ = idle_poll_;
  next_look_ = now + wait_;
  if (registers.size() == probe_.registers()) probe_.answered();
  if (now - asked_at_ >= kAskAgain) {
    asked_at_ = now;
    probe_.ask_again();
  }
  if (registers.size() < modbus::kStatusAndMachine) return;
  const auto status = modbus::decode_status(registers.first(modbus::kStatusRegisters));
  if (!status) return;  // read while it was written, or no mailbox: the sender says so
  const auto words = modbus::decode_machine(registers.subspan(modbus::kStatusRegisters));
  if (!words && words.error() == modbus::MachineFault::garbled) return;
  if (!words) {
    report_.reset();
    state_ = modbus::MachineState::unknown;
    return;
  }
  state_ = words->state;
  report_ = {
      .state = modbus::name(words->state), .program = words->program, .line = words->line, .alarm = words->alarm};
  bell_.seen(status->boot_counter, *words, now);
}

void MachineWatch::read_failed(bool refused, Time now) {
  next_look_ = now + wait_;
  wait_ = std::min(2 * wait_, std::max(kLongestPoll, idle_poll_));
  ++failures_;
  if (refused || !probe_.proved() || failures_ >= kSilencesUntilDoubted) probe_.failed();
  if (!is_away()) return;
  report_.reset();
  state_ = modbus::MachineState::unknown;
}

bool MachineWatch::is_away() const { return failures_ >= kFailuresUntilUnknown; }

std::string_view MachineWatch::stall() const {
  const auto row = std::ranges::find(kStalls, state_, &StallRow::state);
  return row == kStalls.end() ? std::string_view() : row->stall;
}

}  // namespace dripfeed::app
