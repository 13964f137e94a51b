// The states of a feed, what moves it from one to another, and the table of all of that. No state changes outside the
// table: reacting to an input (a character, a line, a command) is one row of kReactions, moving on because a condition
// became true is one row of kProgress. There is no wildcard: every state answers every input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace dripfeed::feed {

enum class State : std::uint8_t {
  idle,             // nothing was ever armed, or a torn line was confirmed reset
  armed,            // a person armed a job; waiting for DC1
  sending,          // bytes go out as the pacing, CTS, ledger and text allow
  held,             // by DC3, until DC1
  stopping,         // a person said stop: the block is sent to its EOB and clocked
  stopping_held,    // ... but DC3 holds it inside the block
  stopped,          // at a block end, until a person says resume or cancel
  stopped_held,     // ... and the control sent DC3 meanwhile
  reset_suspected,  // ... and the control asked again, as it does after a RESET: only cancel is left
  cancelling,       // a person said cancel: the block is sent to its EOB and clocked
  cancelling_held,  // ... but DC3 holds it inside the block
  trailer,          // the final '%' is handed; EOBs and NULs after it go out
  trailer_held,     // ... held by a DC3 that is no end sign
  draining,         // all is handed, its line time not yet passed
  wait_end,         // all is clocked; waiting for the end sign
  ending,           // the end sign came, line time not yet passed
  next_round,       // one of several rounds is over; waiting for the control's own start of the next
  done,             // transferred; says nothing about execution
  failed,           // broken off between two blocks
  torn,             // broken off inside a block: nothing goes out until a person confirms that the control was reset
  cancelled,        // at a block end, by a person
  disarmed,         // armed, but nothing was sent: by a person, expiry, a lost line or unexpected input
};
inline constexpr std::size_t kStates = 22;

enum class Input : std::uint8_t {
  dc1,         // from the control: start, go on
  dc3,         // from the control: hold, or the end
  punch_code,  // DC2 or DC4: tolerated
  eot,         // the profile's end-of-transmission character
  broken,      // SYN, NAK, unexpected input, link or DSR lost, text lost, abort by a person: the feed is over
  line_off,    // CTS where it is watched, or a flow line
  arm,         // commands of a person
  disarm,
  stop,
  resume,  // takes back stop
  cancel,
  abort,          // at once, wherever the block stands
  resume_as_dc1,  // a person stands in for a lost DC1
  confirm_reset,  // a person says that the control was reset
};
inline constexpr std::size_t kInputs = 14;

// What a row depends on besides state and input. A pair of guards splits one (state, input) into two rows.
enum class Guard : std::uint8_t {
  always,
  in_block,         // an unfinished block may have reached the control
  between_blocks,   // what left us ends with a whole block for certain
  dc3_ends,         // the profile takes DC3 as end sign
  dc3_holds,        // it does not
  dc1_starts,       // the profile takes DC1 as the start
  dc1_is_no_start,  // it waits for a trigger text
};

enum class Action : std::uint8_t {
  none,      // nothing to do; a known no-op
  note,      // an event reports what came
  refuse,    // the command has no effect here; its caller and an event get that
  unarmed,   // DC1 that starts nothing: an event says so
  remember,  // DC3 at rest: an event, and a start at once begins held
  arm,       // take the job
  start,     // begin sending
  hold,      // stop handing, count the hold
  release,   // go on handing
  stand_in,  // go on handing, on a person's word
  change,    // the state changes, nothing else
  end,       // the job is over, cleanly
  again,     // the same text once more, from its start
  fail,      // the job is over with a named cause, positions frozen
  clear,     // forget the torn block
};

struct Reaction {
  State from = State::idle;
  Input input = Input::dc1;
  Guard guard = Guard::always;
  Action action = Action::none;
  State to = State::idle;
};

// Conditions that become true by handing bytes or by time.
enum class Condition : std::uint8_t {
  starts_open,     // started at once (the flow lines allow it) or by the trigger text, the control does not hold
  starts_held,     // the same, but the control sent DC3 last
  expired,         // the arming's time is over
  program_handed,  // the final '%' is handed
  all_handed,      // the trailer too
  block_clocked,   // what is handed ends with a whole block, and its line time and latency passed
  line_drained,    // line time and latency of everything handed passed
  quiet,           // nothing came in for the profile's quiet time
  shut,            // the program left, and a flow line has been off for the profile's quiet time
  round_left,      // the arming said that the program is to be sent again
};

struct Progress {
  State from = State::idle;
  Condition condition = Condition::expired;
  Action action = Action::change;
  State to = State::idle;
};

std::span<const Reaction> reactions();
std::span<const Progress> progress();

std::string_view name(State state);
std::string_view name(Input input);
std::string_view name(Guard guard);
std::string_view name(Condition condition);

}  // namespace dripfeed::feed
