// The host's side of the doorbell: which ring counts, exactly when it is reported, and what is answered for it. A ring
// counts only where it was seen to come: one that was there already (either side was restarted, or the link was away)
// is answered "missed" and never acted on. What a request asks for is the application's matter.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "protocol/modbus/machine_words.h"

namespace dripfeed::modbus {

enum class BellRequest : std::uint16_t {
  none = 0,
  load = 1,    // program number: for the machine's memory
  drip = 2,    // program number: to be fed
  cancel = 3,  // what an earlier ring asked for
  call = 4,    // a person is wanted
  parts = 5,   // in the program number's place: good parts that were made since the last such ring
  scrap = 6,   // the same of the others
};

enum class BellOutcome : std::uint16_t { none = 0, answered = 1, armed = 2, queued = 3, refused = 4 };
enum class BellReason : std::uint16_t {
  none = 0,
  not_found = 1,     // no released program of this number
  drip_only = 2,     // released, but not for memory
  is_protected = 3,  // O8000 to O9999
  not_allowed = 4,   // by the machine's profile
  busy = 5,          // the job cannot be added or armed now
  missed = 6,        // it was not seen to come: ring again
  unknown = 7,       // no such request
  no_order = 8,      // what went to the machine last belongs to no order that takes parts
};
std::string_view name(BellRequest request);
std::string_view name(BellOutcome outcome);
std::string_view name(BellReason reason);

struct Ring {
  std::uint16_t bell = 0;
  std::uint16_t request = 0;  // BellRequest, or what is no such
  std::uint32_t program = 0;
};

// A, the answer: host to receiver, after the mailbox, one FC16 write.
inline constexpr std::size_t kAnswerRegisters = 7;
using AnswerImage = std::array<std::uint16_t, kAnswerRegisters>;
struct BellAnswer {
  std::uint16_t bell = 0;
  BellOutcome outcome = BellOutcome::none;
  BellReason reason = BellReason::none;
  std::uint32_t job = 0;  // that it made
};
void encode(const BellAnswer& answer, AnswerImage& out);
// The bell that the registers answer; nothing where they are no answer.
std::optional<std::uint16_t> answered_bell(std::span<const std::uint16_t> registers);

enum class BellState : std::uint8_t {
  unmet,      // nothing was read yet
  checking,   // a bell that was not seen to come: is it answered already?
  quiet,      // answered, or none
  rung,       // waits for the application
  answering,  // its answer is to be written
};
inline constexpr std::size_t kBellStates = 5;
enum class BellInput : std::uint8_t {
  same,     // the bell as before
  rang,     // another bell, seen to come
  zero,     // none since the receiver's start
  strange,  // a bell after a restart or a silence
  shown,    // the answer's registers name this bell
  differs,  // they do not
  decided,  // the application's answer to this bell
  written,  // the answer is at the receiver
};
inline constexpr std::size_t kBellInputs = 8;
enum class BellAction : std::uint8_t { never, none, note, miss, keep };
struct BellCell {
  BellAction action = BellAction::never;
  BellState to = BellState::unmet;
};
BellCell cell(BellState state, BellInput input);

class Doorbell {
 public:
  using Time = std::chrono::nanoseconds;
  // A bell that changed after a longer silence was not seen to come.
  static constexpr Time kFresh = std::chrono::seconds(10);

  void seen(std::uint16_t boot_counter, const MachineWords& words, Time now);
  // A ring that counts, reported once.
  std::optional<Ring> take_ring();
  // Of a ring that was reported; one that is not the present ring's is dropped.
  void answer(const BellAnswer& answer);

  enum class Want : std::uint8_t { nothing, read_answer, write_answer };
  [[nodiscard]] Want want() const;
  // The registers of the answer as they stand; empty: the receiver has none.
  void answer_read(std::span<const std::uint16_t> registers);
  [[nodiscard]] AnswerImage image() const;
  void answer_written();

  [[nodiscard]] BellState state() const { return state_; }
  // For a test of the table: called with (state, input) of every cell taken.
  using CellTaken = void (*)(void* context, BellState state, BellInput input);
  void observe_cells(CellTaken taken, void* context) {
    cell_taken_ = taken;
    cell_context_ = context;
  }

 private:
  void react(BellInput input);
  [[nodiscard]] BellInput judge(std::uint16_t boot_counter, const MachineWords& words, Time now) const;

  BellState state_ = BellState::unmet;
  Ring ring_;
  Ring seen_;
  BellAnswer answer_;
  BellAnswer given_;
  bool is_reported_ = false;
  std::uint16_t boot_ = 0;
  Time seen_at_{};
  CellTaken cell_taken_ = nullptr;
  void* cell_context_ = nullptr;
};

}  // namespace dripfeed::modbus
