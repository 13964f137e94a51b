// What a status image says about the session and the outstanding message. The decision of a delivery is made here and
// nowhere else.
#include "protocol/modbus/sender.h"

namespace dripfeed::modbus {

SenderInput Sender::judge(const Status& status) {
  counters_.consumed = status.session == job_.session ? status.consumed : counters_.consumed;
  if (state_ == SenderState::looking) return opened_ ? judge_session(status) : judge_vacancy(status);
  if (state_ == SenderState::opening) return judge_opening(status);
  if (state_ == SenderState::aborting) {
    const bool over = status.session != job_.session || status.state == ReceiverState::idle;
    return over ? SenderInput::acknowledged : SenderInput::not_yet;
  }
  if (const auto trouble = session_trouble(status)) return contradict(*trouble);
  return judge_message(status);
}

SenderInput Sender::contradict(StopReason reason) {
  reason_ = reason;
  return SenderInput::contradiction;
}

// A new session may be opened unless another one is on. A person may decide that this one is to go.
SenderInput Sender::judge_vacancy(const Status& status) {
  const bool on = status.state == ReceiverState::ready || status.state == ReceiverState::running ||
                  status.state == ReceiverState::held;
  const bool ours = status.session == job_.session;
  const bool may_take = take_over_ && !(ours && status.ack_seq != 0);
  if ((ours || (on && status.session != 0)) && !may_take) return contradict(StopReason::session_running);
  session_before_ = status.session;
  boot_ = status.boot_counter;
  return SenderInput::vacant;
}

// A session that was open is continued only if the receiver holds the first bytes of this very text.
SenderInput Sender::judge_session(const Status& status) {
  if (const auto trouble = session_trouble(status)) return contradict(*trouble);
  switch (skip_confirmed(status)) {
    case Skip::done: return SenderInput::acknowledged;
    case Skip::pending: return SenderInput::not_yet;
    case Skip::differs: return contradict(StopReason::text_differs);
    case Skip::lost: break;
  }
  reason_ = StopReason::text_lost;
  return SenderInput::text_lost;
}

std::optional<StopReason> Sender::session_trouble(const Status& status) const {
  if (status.session != job_.session) return StopReason::other_session;
  if (boot_ && *boot_ != status.boot_counter) return StopReason::receiver_restarted;
  switch (status.state) {
    case ReceiverState::error: return StopReason::receiver_error;
    case ReceiverState::boot:
    case ReceiverState::idle: return StopReason::session_over;
    case ReceiverState::ready:
    case ReceiverState::running:
    case ReceiverState::held:
    case ReceiverState::done: break;
  }
  return std::nullopt;
}

SenderInput Sender::judge_opening(const Status& status) {
  if (boot_ && *boot_ != status.boot_counter) return contradict(StopReason::receiver_restarted);
  if (status.session == job_.session) {
    const bool blank = status.ack_seq == 0 && status.appended == 0;
    return blank ? SenderInput::acknowledged : contradict(StopReason::out_of_step);
  }
  return status.session == session_before_ ? SenderInput::not_yet : contradict(StopReason::other_session);
}

SenderInput Sender::judge_message(const Status& status) {
  if (state_ == SenderState::delivering || state_ == SenderState::closing) return judge_block(status);
  if (!shows(status, before_)) return contradict(mismatch(status));
  const bool holds = status.state == ReceiverState::held;
  if (state_ == SenderState::holding) return holds ? SenderInput::acknowledged : SenderInput::not_yet;
  if (state_ == SenderState::releasing) return holds ? SenderInput::not_yet : SenderInput::acknowledged;
  const bool ended = state_ == SenderState::finishing && status.state == ReceiverState::done;
  return ended ? SenderInput::ended : SenderInput::not_yet;
}

// The block was appended, or not, or no one can say.
SenderInput Sender::judge_block(const Status& status) {
  if (shows(status, after_)) return SenderInput::acknowledged;
  if (!shows(status, before_)) return contradict(mismatch(status));
  if (status.nak_seq != after_.seq) return SenderInput::not_yet;
  switch (status.nak) {
    case Nak::none: return SenderInput::not_yet;
    case Nak::crc:
    case Nak::full: return SenderInput::refused;
    case Nak::closed:
      // A resumed session whose EOF was taken before: the last block counted was the EOF.
      if (state_ == SenderState::closing) {
        after_ = before_;
        return SenderInput::acknowledged;
      }
      break;
    case Nak::sequence:
    case Nak::length:
    case Nak::offset:
    case Nak::conflict: break;
  }
  nak_ = status.nak;
  return contradict(StopReason::refused);
}

bool Sender::shows(const Status& status, const Account& account) const {
  return status.ack_seq == account.seq && status.appended == account.appended && status.text_crc == account.text_crc;
}

StopReason Sender::mismatch(const Status& status) const {
  const bool in_step = status.ack_seq == before_.seq || status.ack_seq == after_.seq;
  return in_step ? StopReason::text_differs : StopReason::out_of_step;
}

void Sender::refresh_stall() {
  const SenderStall stall = present_stall();
  if (stall == stall_) return;
  stall_ = stall;
  emit({.kind = SenderEventKind::stall_changed, .stall = stall});
}

SenderStall Sender::present_stall() const {
  if (state_ == SenderState::stopped) return SenderStall::stopped;
  if (!polls(state_)) return SenderStall::none;
  if (peer_silent_) return SenderStall::peer_gone;
  if (state_ == SenderState::holding || state_ == SenderState::held) return SenderStall::held_by_person;
  if (state_ == SenderState::finishing) return SenderStall::waiting_for_receiver;
  if (state_ != SenderState::ready) {
    const bool late = state_ != SenderState::looking && now_ - composed_at_ >= settings_.rewrite_after;
    return late ? SenderStall::waiting_for_receiver : SenderStall::none;
  }
  if (payload_cut_ == 0) return text_not_ready_ ? SenderStall::waiting_for_text : SenderStall::none;
  if (before_.appended + payload_cut_ > job_.reserve) return SenderStall::waiting_for_ledger;
  return last_.free_blocks == 0 ? SenderStall::waiting_for_credit : SenderStall::none;
}

}  // namespace dripfeed::modbus
