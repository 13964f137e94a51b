// States, inputs and the transition table of the mailbox sender: one cell for every state and input, none left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace dripfeed::modbus {

enum class SenderState : std::uint8_t {
  idle,        // no job
  looking,     // reading the status before anything is written
  opening,     // OPEN is in the mailbox
  ready,       // nothing outstanding: waiting for credit, ledger or text
  delivering,  // a data block is outstanding
  closing,     // EOF is outstanding
  finishing,   // EOF is appended, the receiver still runs
  done,        // the receiver says done
  holding,     // HOLD is in the mailbox, not seen yet
  held,        // the receiver holds
  releasing,   // the hold is taken back, not seen yet
  aborting,    // ABORT is in the mailbox, not seen yet
  aborted,     // the receiver ended the session
  stopped,     // something does not fit: a person must decide
};
inline constexpr std::size_t kSenderStates = 14;

// What a reading of the status says about the outstanding message, what failed, and what a person wants.
enum class SenderInput : std::uint8_t {
  vacant,         // no session runs there: ours may be opened
  acknowledged,   // the message is seen done
  not_yet,        // all is as before it
  refused,        // as before, and the receiver asks for it again (damaged, or full)
  ended,          // the receiver took all of the text
  contradiction,  // foreign registers, other session, boot counter, sequence or text: stop (the reason says which)
  failed,         // a request was not answered, or the image was garbled: nothing is known, read again
  gone,           // no status for too long
  hold_due,       // a hold is wanted and what is confirmed ends with a whole block
  has_block,      // a data block can be written: text, credit and reserve are there
  has_end,        // the text is over and all of it is confirmed
  text_lost,      // the source failed
  start,          // commands
  resume,
  hold,
  release,
  abort,
  proceed,
};
inline constexpr std::size_t kSenderInputs = 18;

enum class SenderCommand : std::uint8_t { hold, release, abort, proceed };

enum class SenderAction : std::uint8_t {
  never,  // the machine does not ask or say this in this state; if it ever did, it would stop
  none,
  again,      // read again after the poll time; write again when it is due
  rewrite,    // write the same message again
  open,       // compose OPEN
  opened,     // the session is open (or continued): count from what the status shows
  deliver,    // compose DATA from the gathered payload
  confirm,    // the block is appended
  close,      // compose EOF
  change,     // the state changes, nothing is written
  want_hold,  // hold at the next block end
  unwant_hold,
  hold,        // compose HOLD
  release,     // compose idle
  abort,       // compose ABORT
  begin,       // take the job, read the status
  look_again,  // forget the boot counter, read the status
  stop,        // end with the named reason
  refuse,      // the command has no effect here
};

struct SenderCell {
  SenderAction action = SenderAction::never;
  SenderState to = SenderState::idle;
};
SenderCell cell(SenderState state, SenderInput input);

// Does the machine read the status in this state?
constexpr bool polls(SenderState state) {
  return state != SenderState::idle && state != SenderState::done && state != SenderState::aborted &&
         state != SenderState::stopped;
}

enum class SenderStall : std::uint8_t {
  none,
  waiting_for_credit,
  waiting_for_ledger,
  waiting_for_text,
  waiting_for_receiver,  // the outstanding message is not seen yet
  peer_gone,             // the last request was not answered
  held_by_person,
  stopped,
};

enum class StopReason : std::uint8_t {
  none,
  foreign_registers,   // no mailbox of this version there
  session_over,        // the session was ended there
  session_running,     // start: another session is running there
  other_session,       // the receiver has another session than ours
  receiver_restarted,  // its boot counter changed
  out_of_step,         // its sequence number is neither that before nor that after the block
  text_differs,        // it holds other bytes than ours
  refused,             // a nak that writing again cannot mend (SenderEvent::nak)
  receiver_error,      // its own error
  peer_gone,           // no status for too long
  text_lost,           // our own source failed
};

enum class SenderEventKind : std::uint8_t {
  state_changed,
  stall_changed,
  opened,
  confirmed,
  rewritten,
  command_refused
};

std::string_view name(SenderState state);
std::string_view name(SenderInput input);
std::string_view name(SenderStall stall);
std::string_view name(StopReason reason);
std::string_view name(SenderEventKind kind);

}  // namespace dripfeed::modbus
