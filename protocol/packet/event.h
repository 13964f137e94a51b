// What a packet sender reports to its driver: events, stalls and causes by name, counters, and the interval of what is
// known.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "protocol/packet/settings.h"
#include "protocol/packet/state.h"

namespace dripfeed::packet {

// Why nothing goes out although a job is on.
enum class Stall : std::uint8_t {
  none,
  waiting_for_start,
  waiting_for_receiver,  // the call is not answered, or the next frame not asked for
  waiting_for_ack,
  waiting_for_ledger,
  waiting_for_text,
  waiting_for_end,
  stopped_by_person,
  partner_sends,  // 3964: both called, and this side yielded
};
inline constexpr std::size_t kStalls = 9;

enum class Cause : std::uint8_t {
  none,
  start,
  person,
  expired,
  link_lost,
  peer_cancelled,
  peer_restarted,
  peer_reset,
  peer_alarm,
  no_answer,
  too_many_repeats,
  out_of_step,
  text_lost,
  bad_character,
  broken_off,
  second_file,  // a batch of YMODEM goes on after the file that was received
};
inline constexpr std::size_t kCauses = 16;

enum class EventKind : std::uint8_t {
  state_changed,
  stall_changed,
  start_unarmed,    // the receiver asked with nothing armed: no text was sent
  repeated,         // a frame, call or end goes out once more (count: attempts so far)
  noticed,          // a byte that means nothing here
  command_refused,  // input
  telegram,         // 3964: the partner's own, of `count` bytes, came first: Sender::telegram() has it
};

struct Event {
  EventKind kind = EventKind::state_changed;
  Time at{};
  State from = State::idle;
  State to = State::idle;
  Cause cause = Cause::none;
  Stall stall = Stall::none;
  Input input = Input::arm;
  std::uint8_t byte = 0;
  std::uint32_t count = 0;
};

// Bytes of the coded text, leader and trailer included; what the frames add is not in it.
struct Counters {
  std::uint64_t handed = 0;     // to the end of the last frame that went out whole
  std::uint64_t clocked = 0;    // ... whose line time passed
  std::uint64_t confirmed = 0;  // ... that the receiver acknowledged
  std::uint64_t frames = 0;     // accepted
  std::uint64_t repeats = 0;
  std::uint64_t holds = 0;  // times that an answer was late
  Time stalled_for{};       // in any stall but a person's or the start's
  Time line_time{};         // of all that went out
  Time started_at{};
  Time ended_at{};
};

// `start_unarmed` and alike; stalls as people read them ("waiting for ACK"), "" for none.
std::string_view name(Stall stall);
std::string_view name(Cause cause);
std::string_view name(EventKind kind);

}  // namespace dripfeed::packet
