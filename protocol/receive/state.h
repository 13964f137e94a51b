// The states of a reception, what moves it from one to another, and the table of all of that. As in the feed there is
// no wildcard: every state answers every input, and moving on by time is a row, too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace dripfeed::receive {

enum class State : std::uint8_t {
  idle,       // nothing comes; the line was quiet before
  opened,     // DC2 came, no text yet
  receiving,  // text comes
  closing,    // the second '%' came: the end, if nothing follows for a short while
  spilling,   // what comes is lost already: it is let pass until the line is quiet
};
inline constexpr std::size_t kStates = 5;

enum class Input : std::uint8_t {
  punch_on,    // DC2
  punch_off,   // DC4
  percent,     // '%' of the code in use
  text,        // any other character that a program has, EOBs but for those after the final '%'
  eob,         // LF, CR, or the EOB of EIA
  filler,      // NUL, DEL: leader and trailer
  end_code,    // the profile's end character
  reader_on,   // DC1: the control reads, so it does not punch any more
  reader_off,  // DC3
  reset,       // SYN, NAK: the control was reset or has an alarm
  other,       // a control character that no program has
  link_lost,
};
inline constexpr std::size_t kInputs = 12;

// What a row depends on besides state and input.
enum class Guard : std::uint8_t {
  always,
  first_percent,  // no '%' of this reception came yet
  later_percent,
};

enum class Action : std::uint8_t {
  none,   // not of this reception
  begin,  // a reception begins, the character is its first
  open,   // a reception begins, the character is a sign and not kept
  keep,   // the character belongs to it
  skip,   // the character is a sign of it and not kept
  end,    // it is over
  renew,  // it is over, and the next one begins
  spoil,  // it is over at the limit; the rest is let pass
};

struct Reaction {
  State from = State::idle;
  Input input = Input::text;
  Guard guard = Guard::always;
  Action action = Action::none;
  State to = State::idle;
};

enum class Condition : std::uint8_t {
  quiet,        // nothing came for the profile's quiet time
  short_quiet,  // nothing came for the short time after a final '%'
  too_long,     // more came than the limit
};

struct Progress {
  State from = State::idle;
  Condition condition = Condition::quiet;
  Action action = Action::end;
  State to = State::idle;
};

std::span<const Reaction> reactions();
std::span<const Progress> progress();

std::string_view name(State state);
std::string_view name(Input input);
std::string_view name(Guard guard);
std::string_view name(Condition condition);

}  // namespace dripfeed::receive
