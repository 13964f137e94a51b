// The states of a packet receiver, its inputs, and the table of both: one for all protocols. There is no wildcard.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace dripfeed::packet {

enum class ReceiveState : std::uint8_t {
  idle,
  inviting,  // no frame has come yet; the sender is asked for one where the protocol asks
  waiting,   // for the next frame
  framing,   // a frame has begun
  purging,   // a frame was bad: what is left of it runs out before the sender gets an answer
  full,      // a frame is taken, and its acknowledgement waits until there is room for another
  done,      // the sender sent the end
  failed,    // with a cause; what came so far is no whole program
};
inline constexpr std::size_t kReceiveStates = 8;

enum class ReceiveInput : std::uint8_t {
  start,  // commands
  stop,
  header,       // a frame begins
  good,         // it is whole and the next one
  repeated,     // it is whole and the one before
  bad,          // it is not whole
  out_of_step,  // it is whole and none of these
  first_end,    // the end, for the first time: it is doubted
  end,          // the end, believed
  cancelled,    // by the sender
  silent,       // nothing came for as long as the state allows
  gave_up,      // that happened too often
  room,         // the sink has room for another frame
  lost,         // the link
  nothing,      // a message that brings no text
  aside,        // the same, and it is acknowledged: the header of YMODEM, the end of its file
};
inline constexpr std::size_t kReceiveInputs = 16;

enum class ReceiveAction : std::uint8_t {
  never,
  none,
  refuse,       // the command has no effect here
  begin,        // forget what was, invite
  invite,       // ask for the first frame
  take,         // the frame's time runs
  listen,       // the state's time starts again
  keep,         // append it, acknowledge it where there is room for another (else the state is `full`)
  acknowledge,  // it was appended before
  note,         // acknowledge it, nothing was appended
  purge,
  ask_again,  // refuse what came, or ask for what did not
  finish,     // acknowledge the end
  fail,       // with a named cause; nothing is sent to the sender
  cancel,     // the same, and the protocol's cancel goes out
};

struct ReceiveCell {
  ReceiveAction action = ReceiveAction::never;
  ReceiveState to = ReceiveState::idle;
};
ReceiveCell cell(ReceiveState state, ReceiveInput input);

enum class ReceiveEventKind : std::uint8_t {
  state_changed,
  frame,           // one was taken (count: its bytes)
  repeated_frame,  // one came again and was dropped
  bad_frame,
  command_refused,
};
inline constexpr std::size_t kReceiveEvents = 5;

std::string_view name(ReceiveState state);
std::string_view name(ReceiveInput input);
std::string_view name(ReceiveEventKind kind);

}  // namespace dripfeed::packet
