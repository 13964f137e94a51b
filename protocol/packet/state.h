// The states of a packet sender, what moves it from one to another, and the table of all of that: one table for all
// protocols. What a byte means and what goes out is each protocol's own (send_rules.h). There is no wildcard.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace dripfeed::packet {

enum class State : std::uint8_t {
  idle,
  armed,      // a person armed a job; waiting for the receiver's start
  calling,    // 3964: STX is out, waiting for DLE; YMODEM: so with the header; the others pass through
  receiving,  // 3964: both called, and this side yielded: the partner's telegram comes first
  sending,    // a frame goes out
  waiting,    // all of it is out; waiting for its answer
  ready,      // no frame is in transit; the next waits for text, ledger, a person, or the receiver's request
  closing,    // every frame is answered; the end is sent, waiting for its answer
  done,       // transferred; says nothing about execution
  failed,     // broken off between two blocks of the program
  torn,       // broken off inside a block: nothing goes out until a person confirms that the control was reset
  cancelled,  // at a block end, by a person
  disarmed,   // armed, but nothing was sent
};
inline constexpr std::size_t kStates = 13;

enum class Input : std::uint8_t {
  arm,  // commands of a person
  disarm,
  stop,
  resume,
  cancel,
  abort,
  confirm_reset,
  asked,        // the receiver wants the first frame, or the next (remote buffer)
  granted,      // the call is answered: the frame may go out
  accepted,     // the receiver has the frame
  again,        // it does not, or did not say so in time
  broken,       // link lost, cancelled by the receiver, no answer, text lost
  frame_out,    // the last byte of what goes out is handed
  frame_ready,  // the next frame can go out
  finished,     // all of the text is accepted
  cut,          // a cancel is wanted, and what was accepted ends with a block
  expired,      // the arming's time is over
  yielded,      // both called, and this side yields
};
inline constexpr std::size_t kInputs = 18;

enum class Action : std::uint8_t {
  never,  // cannot be
  none,
  refuse,
  unarmed,  // the receiver asks and nothing is armed: an event says so
  take,     // take the job
  start,
  want_stop,
  unwant_stop,
  want_cancel,
  call,      // call for the frame, the present one where it is not accepted
  give_way,  // the call is taken back, the partner may send
  send,
  sent,  // the answer is awaited from now
  wait,  // as sent, for a call or an end
  accept,
  accept_asked,  // accepted, and the next one is wanted
  note_asked,
  repeat,  // the last accepted frame once more: the receiver asks for it to stay alive
  close,
  part,  // take leave, the job is over
  end,
  fail,  // the job is over with a named cause; inside a block of the program the state is `torn` instead of `failed`
  clear,
};

struct Cell {
  Action action = Action::never;
  State to = State::idle;
};
Cell cell(State state, Input input);

// A frame or an end is between us and the receiver, or the next is due.
constexpr bool is_on_the_line(State state) {
  return state == State::calling || state == State::receiving || state == State::sending || state == State::waiting ||
         state == State::ready || state == State::closing;
}

std::string_view name(State state);
std::string_view name(Input input);

}  // namespace dripfeed::packet
