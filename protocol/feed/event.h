// What a feed reports to its driver: events, stalls by name, counters and the interval of what is known. Plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "protocol/feed/settings.h"
#include "protocol/feed/state.h"
#include "protocol/tape_code/wire_encoder.h"

namespace dripfeed::feed {

// Why nothing goes out although a job is on.
enum class Stall : std::uint8_t {
  none,
  waiting_for_dc1,
  held_by_dc3,
  cts_off,
  peer_gone,
  waiting_for_ledger,  // the reserve is used up
  waiting_for_text,    // the source is not ready
  waiting_for_end,     // all is clocked, the end sign is missing
  stopped_by_person,
  dsr_off,              // where DSR is the flow line
  held_below,           // what is below us takes nothing more, or does not send what it took
  waiting_for_trigger,  // armed, the profile waits for a text
  reset_suspected,      // stopped by a person, and then the control asked again: it may have been reset
};

// Why the state changed or the feed ended.
enum class Cause : std::uint8_t {
  none,
  dc1,
  dc3,
  eot,
  quiet,
  syn,               // the control was reset
  nak,               // the control has an alarm
  unexpected_input,  // a character that has no place here, or wrong parity
  link_lost,
  dsr_off,
  cts_off,
  expired,
  person,         // a command
  text_lost,      // the source failed or was shorter than its facts
  bad_character,  // a character that the line's code cannot carry
  trigger,        // the control's start text
};

enum class EventKind : std::uint8_t {
  state_changed,      // from, to, cause
  stall_changed,      // stall
  dc1_unarmed,        // DC1, but nothing is armed: nothing was sent
  dc3_seen,           // DC3 at rest
  punch_code,         // DC2 or DC4 (byte)
  noticed,            // an input that has no effect in this state (cause, byte)
  command_refused,    // input
  resumed_by_person,  // "resume as if DC1" took effect
  cts_changed,        // up
  dsr_changed,        // up
  link_changed,       // up
};

struct Event {
  EventKind kind = EventKind::state_changed;
  Time at{};
  State from = State::idle;
  State to = State::idle;
  Cause cause = Cause::none;
  Stall stall = Stall::none;
  Input input = Input::dc1;
  std::uint8_t byte = 0;
  bool up = false;
  std::uint64_t clocked = 0;  // counters at that moment
  std::uint64_t handed = 0;
};

// Wire bytes of the job, leader included. handed (the driver took it) >= clocked (its line time and the link's latency
// passed; on a blind link as long ago that no loss can take it back) >= confirmed (acknowledged by the peer; a plain
// serial line never does).
struct Counters {
  std::uint64_t handed = 0;
  std::uint64_t clocked = 0;
  std::uint64_t confirmed = 0;
  std::uint64_t holds = 0;  // DC3 while sending
  Time held_for{};          // time in a held state
  Time stalled_for{};       // time in any stall while a job was on the line, holds included
  Time started_at{};        // the first DC1, or the arming where the profile starts at once
  Time ended_at{};          // when the job was over; 0 while it is on
  bool estimated = false;   // the link is blind: the budget is kept by estimate
};

// What the control may have: more than `from`, no more than `to`. Positions are missing when they are older than what
// the encoder remembers (tape_code::locate finds them from the text).
struct Interval {
  std::uint64_t from = 0;
  std::uint64_t to = 0;
  std::optional<tape_code::WirePosition> from_position{};
  std::optional<tape_code::WirePosition> to_position{};
};

std::string_view name(Stall stall);
std::string_view name(Cause cause);
std::string_view name(EventKind kind);

}  // namespace dripfeed::feed
