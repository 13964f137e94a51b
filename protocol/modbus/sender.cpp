// The sending side: requests, commands and the transitions. What a status image means is in sender_judgement.cpp, the
// text in sender_text.cpp.
#include "protocol/modbus/sender.h"

#include <algorithm>
#include <utility>

namespace dripfeed::modbus {
namespace {

constexpr std::array<std::pair<SenderRefusal, std::string_view>, 5> kRefusals{{
    {SenderRefusal::not_in_this_state, "the command has no effect in this state"},
    {SenderRefusal::no_source, "the job has no text"},
    {SenderRefusal::no_session, "the session number must not be 0"},
    {SenderRefusal::text_too_long, "the text is longer than 4 GiB"},
    {SenderRefusal::no_text, "the text is empty"},
}};

constexpr std::array<std::pair<SenderCommand, SenderInput>, 4> kCommands{{
    {SenderCommand::hold, SenderInput::hold},
    {SenderCommand::release, SenderInput::release},
    {SenderCommand::abort, SenderInput::abort},
    {SenderCommand::proceed, SenderInput::proceed},
}};

std::optional<SenderRefusal> fault_of(const SenderJob& job) {
  if (job.source == nullptr) return SenderRefusal::no_source;
  if (job.session == 0) return SenderRefusal::no_session;
  if (job.text_bytes == 0) return SenderRefusal::no_text;
  if (job.text_bytes > UINT32_MAX) return SenderRefusal::text_too_long;
  return std::nullopt;
}

bool is_block(MailboxCommand command) { return command == MailboxCommand::data || command == MailboxCommand::eof; }

}  // namespace

std::string_view message(SenderRefusal refusal) {
  for (const auto& [key, text] : kRefusals) {
    if (key == refusal) return text;
  }
  return {};
}

Sender::Sender(const SenderSettings& settings) : settings_(settings) {
  settings_.max_payload = std::clamp<std::uint32_t>(settings_.max_payload, 1, kMaxPayload);
}

std::expected<void, SenderRefusal> Sender::start(const SenderJob& job, Time now) {
  return begin(job, SenderInput::start, now);
}

std::expected<void, SenderRefusal> Sender::resume(const SenderJob& job, std::uint16_t boot_counter, Time now) {
  const auto begun = begin(job, SenderInput::resume, now);
  if (begun) {
    opened_ = true;
    boot_ = boot_counter;
  }
  return begun;
}

std::expected<void, SenderRefusal> Sender::begin(const SenderJob& job, SenderInput input, Time now) {
  if (const auto fault = fault_of(job)) return std::unexpected(*fault);
  now_ = std::max(now_, now);
  if (cell(state_, input).action == SenderAction::begin) {
    job_ = job;
    counters_ = {};
    before_ = {};
    after_ = {};
    boot_.reset();
    opened_ = hold_wanted_ = false;
    take_over_ = job.take_over && input == SenderInput::start;
    at_block_end_ = true;
    piece_ = {};
    piece_used_ = 0;
    taken_ = 0;
    payload_size_ = payload_cut_ = 0;
    text_not_ready_ = text_lost_ = false;
    must_write_ = write_uncertain_ = false;
    flight_is_stale_ = in_flight_;
  }
  const auto begun = react(input);
  refresh_stall();
  return begun;
}

std::expected<void, SenderRefusal> Sender::command(SenderCommand command, Time now) {
  update(now);
  for (const auto& [key, input] : kCommands) {
    if (key != command) continue;
    const auto taken = react(input);
    update(now);
    return taken;
  }
  return std::unexpected(SenderRefusal::not_in_this_state);
}

void Sender::extend_reserve(std::uint64_t text_offset, Time now) {
  job_.reserve = std::max(job_.reserve, text_offset);
  update(now);
}

std::optional<Request> Sender::next_request(Time now) {
  update(now);
  if (in_flight_ || !polls(state_)) return std::nullopt;
  if (must_write_ && now_ < write_at_) return std::nullopt;
  if (must_write_) {
    must_write_ = false;
    in_flight_ = true;
    flight_kind_ = Request::Kind::write_mailbox;
    written_at_ = now_;
    counters_.handed = std::max(counters_.handed, mailbox_text_end_);
    return Request{.kind = flight_kind_, .registers = std::span(mailbox_).first(mailbox_used_)};
  }
  if (now_ < next_poll_) return std::nullopt;
  in_flight_ = true;
  flight_kind_ = Request::Kind::read_status;
  return Request{.kind = flight_kind_};
}

// The answer to a write says nothing about the block: the status is read at once.
void Sender::written(Time now) {
  const bool ours = in_flight_ && !flight_is_stale_;
  in_flight_ = flight_is_stale_ = false;
  if (ours) {
    write_uncertain_ = false;
    next_poll_ = std::max(now_, now);
  }
  update(now);
}

void Sender::request_failed(Time now) {
  now_ = std::max(now_, now);
  const bool ours = in_flight_ && !flight_is_stale_;
  if (ours && flight_kind_ == Request::Kind::write_mailbox) write_uncertain_ = true;
  in_flight_ = flight_is_stale_ = false;
  if (ours && polls(state_)) {
    ++counters_.failed_requests;
    peer_silent_ = true;
    static_cast<void>(react(SenderInput::failed));
  }
  update(now);
}

void Sender::status_read(std::span<const std::uint16_t> registers, Time now) {
  now_ = std::max(now_, now);
  const bool ours = in_flight_ && !flight_is_stale_;
  in_flight_ = flight_is_stale_ = false;
  if (ours && polls(state_)) {
    const auto status = decode_status(registers);
    if (status) {
      answered_at_ = now_;
      peer_silent_ = false;
      last_ = *status;
      const SenderInput input = judge(*status);
      static_cast<void>(react(input));
    } else if (status.error() == StatusFault::garbled) {
      static_cast<void>(react(SenderInput::failed));
    } else {
      static_cast<void>(react(contradict(StopReason::foreign_registers)));
    }
  }
  update(now);
}

void Sender::exchanged(std::span<const std::uint16_t> registers, Time now) {
  const bool ours = in_flight_ && !flight_is_stale_;
  written(now);
  if (!ours || !polls(state_)) return;
  in_flight_ = true;
  flight_kind_ = Request::Kind::read_status;
  status_read(registers, now);
}

void Sender::tick(Time now) { update(now); }

void Sender::update(Time now) {
  now_ = std::max(now_, now);
  if (polls(state_) && now_ - answered_at_ >= settings_.gone_after) {
    reason_ = StopReason::peer_gone;
    static_cast<void>(react(SenderInput::gone));
  }
  if (state_ == SenderState::ready) look_for_work();
  refresh_stall();
}

std::optional<Time> Sender::deadline() const {
  if (!polls(state_)) return std::nullopt;
  const Time gone = answered_at_ + settings_.gone_after;
  if (in_flight_) return gone;
  return std::min(must_write_ ? write_at_ : next_poll_, gone);
}

std::expected<void, SenderRefusal> Sender::react(SenderInput input) {
  const SenderCell next = cell(state_, input);
  if (cell_taken_ != nullptr) cell_taken_(cell_context_, state_, input);
  if (next.action == SenderAction::refuse) {
    emit({.kind = SenderEventKind::command_refused});
    return std::unexpected(SenderRefusal::not_in_this_state);
  }
  if (next.action == SenderAction::never) {
    reason_ = StopReason::out_of_step;
    enter(SenderState::stopped);
    return {};
  }
  perform(next.action);
  if (state_ != next.to) enter(next.to);
  return {};
}

void Sender::perform(SenderAction action) {
  switch (action) {
    case SenderAction::never:
    case SenderAction::none:
    case SenderAction::refuse:
    case SenderAction::change: break;
    case SenderAction::again: read_again(); break;
    case SenderAction::rewrite:
      write_again();
      if (last_.nak == Nak::full) write_at_ = now_ + settings_.poll;
      break;
    case SenderAction::open: compose(MailboxCommand::open); break;
    case SenderAction::opened: accept_session(); break;
    case SenderAction::deliver: compose(MailboxCommand::data); break;
    case SenderAction::confirm: confirm(); break;
    case SenderAction::close: compose(MailboxCommand::eof); break;
    case SenderAction::want_hold: hold_wanted_ = true; break;
    case SenderAction::unwant_hold: hold_wanted_ = false; break;
    case SenderAction::hold: compose(MailboxCommand::hold); break;
    case SenderAction::release:
      hold_wanted_ = false;
      compose(MailboxCommand::idle);
      break;
    case SenderAction::abort: compose(MailboxCommand::abort); break;
    case SenderAction::look_again:
      take_over_ = true;
      boot_.reset();
      [[fallthrough]];
    case SenderAction::begin:
      reason_ = StopReason::none;
      nak_ = Nak::none;
      must_write_ = false;
      peer_silent_ = false;
      answered_at_ = next_poll_ = now_;
      break;
    case SenderAction::stop: must_write_ = false; break;
  }
}

// Nothing new is known. The same message is written again where its write may have been lost, or after a while.
void Sender::read_again() {
  next_poll_ = now_ + settings_.poll;
  const bool outstanding = state_ != SenderState::looking && state_ != SenderState::ready &&
                           state_ != SenderState::held && state_ != SenderState::finishing;
  if (!outstanding || must_write_ || peer_silent_) return;
  if (write_uncertain_ || now_ - written_at_ >= settings_.rewrite_after) write_again();
}

void Sender::write_again() {
  must_write_ = true;
  write_at_ = now_;
  write_uncertain_ = false;
  ++counters_.rewrites;
  emit({.kind = SenderEventKind::rewritten});
}

void Sender::accept_session() {
  before_ = {.seq = last_.ack_seq, .appended = last_.appended, .text_crc = last_.text_crc};
  boot_ = last_.boot_counter;
  opened_ = true;
  take_over_ = false;
  must_write_ = false;
  hold_wanted_ = hold_wanted_ || last_.state == ReceiverState::held;
  counters_.confirmed = counters_.clocked = before_.appended;
  counters_.consumed = last_.consumed;
  counters_.handed = std::max(counters_.handed, counters_.confirmed);
  emit({.kind = SenderEventKind::opened});
}

void Sender::confirm() {
  before_ = after_;
  must_write_ = write_uncertain_ = false;
  if (state_ == SenderState::delivering) drop_payload(payload_cut_);
  counters_.confirmed = counters_.clocked = before_.appended;
  counters_.consumed = last_.consumed;
  next_poll_ = now_ + settings_.poll;
  emit({.kind = SenderEventKind::confirmed});
}

void Sender::compose(MailboxCommand command) {
  const std::size_t length = command == MailboxCommand::data ? payload_cut_ : 0;
  const auto payload = std::span<const std::byte>(payload_).first(length);
  const std::uint16_t last = before_.seq == 0 ? std::uint16_t{1} : before_.seq;
  const Message message{.session = job_.session,
                        .command = command,
                        .seq = is_block(command) ? successor(before_.seq) : last,
                        .offset = before_.appended,
                        .payload = payload};
  mailbox_used_ = encode(message, mailbox_);
  mailbox_text_end_ = before_.appended + length;
  must_write_ = true;
  write_at_ = composed_at_ = now_;
  write_uncertain_ = false;
  after_ = {.seq = is_block(command) ? message.seq : before_.seq,
            .appended = before_.appended + static_cast<std::uint32_t>(length),
            .text_crc = crc32(before_.text_crc, payload)};
}

void Sender::enter(SenderState to) {
  const SenderState from = std::exchange(state_, to);
  const bool per_block = (from == SenderState::ready && to == SenderState::delivering) ||
                         (from == SenderState::delivering && to == SenderState::ready);
  if (!per_block)
    emit({.kind = SenderEventKind::state_changed, .from = from, .to = to, .reason = reason_, .nak = nak_});
}

void Sender::emit(SenderEvent event) {
  event.at = now_;
  event.seq = event.kind == SenderEventKind::rewritten ? after_.seq : before_.seq;
  event.confirmed = counters_.confirmed;
  event.boot_counter = boot_.value_or(0);
  if (event_count_ == kMaxEvents) {
    first_event_ = (first_event_ + 1) % kMaxEvents;
    --event_count_;
    ++events_dropped_;
  }
  events_[(first_event_ + event_count_) % kMaxEvents] = event;
  ++event_count_;
}

std::optional<SenderEvent> Sender::next_event() {
  if (event_count_ == 0) return std::nullopt;
  const SenderEvent event = events_[first_event_];
  first_event_ = (first_event_ + 1) % kMaxEvents;
  --event_count_;
  return event;
}

}  // namespace dripfeed::modbus
