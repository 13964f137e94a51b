// The receiver: what is common to all packet protocols. State changes happen in react() alone, by the table.
#include "protocol/packet/receiver.h"

#include <algorithm>
#include <utility>

namespace dripfeed::packet {
namespace {

// A sender that babbles never lets a purge end; this long is enough.
constexpr Time kLongestPurge = std::chrono::seconds(60);

bool is_resting(ReceiveState state) {
  return state == ReceiveState::idle || state == ReceiveState::done || state == ReceiveState::failed;
}

}  // namespace

std::expected<Receiver, SettingsFault> Receiver::make(const Settings& settings, Sink& sink) {
  if (const auto valid = validate(settings); !valid) return std::unexpected(valid.error());
  return Receiver(settings, sink);
}

Receiver::Receiver(const Settings& settings, Sink& sink) : rules_(make_receive_rules(settings)), sink_(&sink) {}

void Receiver::step_to(Time now) { now_ = std::max(now_, now); }

std::expected<void, feed::Refusal> Receiver::start(Time now) {
  step_to(now);
  const auto taken = react(ReceiveInput::start);
  update();
  return taken;
}

std::expected<void, feed::Refusal> Receiver::stop(Time now) {
  step_to(now);
  const auto taken = react(ReceiveInput::stop, Cause::person);
  update();
  return taken;
}

std::expected<void, feed::Refusal> Receiver::conclude(Time now) {
  step_to(now);
  if (state_ != ReceiveState::waiting) return std::unexpected(feed::Refusal::not_in_this_state);
  return react(ReceiveInput::end);
}

void Receiver::link(bool up, Time now) {
  step_to(now);
  if (!up) {
    static_cast<void>(react(ReceiveInput::lost, Cause::link_lost));
    out_begin_ = out_end_ = 0;
  }
  update();
}

void Receiver::receive(std::span<const std::byte> bytes, Time now) {
  step_to(now);
  update();  // what was over before these bytes came
  for (const std::byte byte : bytes) {
    const Received received = rules_->hear(static_cast<std::uint8_t>(byte), state_);
    if (state_ == ReceiveState::framing || state_ == ReceiveState::purging) quiet_since_ = now_;
    if (received.input) static_cast<void>(react(*received.input, received.cause));
    answer(rules_->reply(out_));
  }
  update();
}

void Receiver::tick(Time now) {
  step_to(now);
  update();
}

void Receiver::mark_sent(std::size_t n, Time now) {
  step_to(now);
  out_begin_ += std::min(n, out_end_ - out_begin_);
  update();
}

void Receiver::update() {
  if (is_resting(state_)) return;
  if (state_ == ReceiveState::full) {
    if (has_room()) static_cast<void>(react(ReceiveInput::room));
    return;
  }
  listen();
  if (!uninvited_ || !has_room()) return;
  uninvited_ = false;
  quiet_since_ = now_;
  answer(rules_->invite(out_));
}

// What came of nothing having come.
void Receiver::listen() {
  if (uninvited_) return;
  if (state_ == ReceiveState::purging && now_ >= purge_until_)
    return static_cast<void>(react(ReceiveInput::gave_up, Cause::no_answer));
  const auto silence = rules_->silence(state_);
  if (!silence || now_ < quiet_since_ + *silence) return;
  const std::uint32_t most = rules_->attempts(state_);
  if (most != 0 && ++silences_ >= most) {
    if (rules_->is_whole()) return static_cast<void>(react(ReceiveInput::end));
    return static_cast<void>(react(ReceiveInput::gave_up, Cause::no_answer));
  }
  static_cast<void>(react(ReceiveInput::silent));
}

std::expected<void, feed::Refusal> Receiver::react(ReceiveInput input, Cause cause) {
  ReceiveCell taken = cell(state_, input);
  if (cell_taken_ != nullptr) cell_taken_(cell_context_, state_, input);
  if (taken.action == ReceiveAction::refuse) {
    emit({.kind = ReceiveEventKind::command_refused});
    return std::unexpected(feed::Refusal::not_in_this_state);
  }
  perform(taken.action, cause);
  if (taken.action == ReceiveAction::keep && !has_room()) taken.to = ReceiveState::full;
  const ReceiveState from = std::exchange(state_, taken.to);
  const bool over = !is_resting(from) && is_resting(state_);
  if (from == state_) return {};
  if (over || state_ == ReceiveState::inviting)
    emit({.kind = ReceiveEventKind::state_changed, .from = from, .to = state_, .cause = cause});
  return {};
}

void Receiver::perform(ReceiveAction action, Cause cause) {
  switch (action) {
    case ReceiveAction::never:
    case ReceiveAction::none:
    case ReceiveAction::refuse: return;
    case ReceiveAction::begin:
      counters_ = {};
      end_cause_ = Cause::none;
      silences_ = 0;
      out_begin_ = out_end_ = 0;
      rules_->begin();
      quiet_since_ = now_;
      uninvited_ = true;
      return;
    case ReceiveAction::invite: uninvited_ = true; return;
    case ReceiveAction::listen: quiet_since_ = now_; return;
    case ReceiveAction::take: quiet_since_ = now_; return answer(rules_->begin_frame(out_));
    case ReceiveAction::keep: {
      const auto payload = rules_->payload();
      sink_->append(payload);
      counters_.bytes += payload.size();
      ++counters_.frames;
      emit({.kind = ReceiveEventKind::frame, .count = static_cast<std::uint32_t>(payload.size())});
      silences_ = 0;
      quiet_since_ = now_;
      if (has_room() || rules_->acknowledges_at_once()) answer(rules_->acknowledge(out_));
      return;
    }
    case ReceiveAction::acknowledge:
      if (state_ == ReceiveState::framing) {
        ++counters_.repeated;
        emit({.kind = ReceiveEventKind::repeated_frame});
      }
      silences_ = 0;
      quiet_since_ = now_;
      if (state_ == ReceiveState::full && rules_->acknowledges_at_once()) return;
      return answer(rules_->acknowledge(out_));
    case ReceiveAction::note:
      silences_ = 0;
      quiet_since_ = now_;
      return answer(rules_->acknowledge(out_));
    case ReceiveAction::purge:
      ++counters_.bad;
      emit({.kind = ReceiveEventKind::bad_frame});
      quiet_since_ = now_;
      purge_until_ = now_ + kLongestPurge;
      return;
    case ReceiveAction::ask_again: quiet_since_ = now_; return answer(rules_->refuse(out_));
    case ReceiveAction::finish: return answer(rules_->finish(out_));
    case ReceiveAction::fail: end_cause_ = cause; return;
    case ReceiveAction::cancel: end_cause_ = cause; return answer(rules_->cancel(out_));
  }
}

void Receiver::answer(std::size_t size) {
  if (size == 0) return;
  out_begin_ = 0;
  out_end_ = size;
}

std::optional<Time> Receiver::deadline() const {
  if (is_resting(state_) || state_ == ReceiveState::full || uninvited_) return std::nullopt;
  const auto silence = rules_->silence(state_);
  return silence ? std::optional(quiet_since_ + *silence) : std::nullopt;
}

std::optional<ReceiveEvent> Receiver::next_event() {
  if (event_count_ == 0) return std::nullopt;
  const ReceiveEvent event = events_[first_event_];
  first_event_ = (first_event_ + 1) % kMaxEvents;
  --event_count_;
  return event;
}

void Receiver::emit(ReceiveEvent event) {
  event.at = now_;
  if (event_count_ == kMaxEvents) {
    first_event_ = (first_event_ + 1) % kMaxEvents;
    --event_count_;
  }
  events_[(first_event_ + event_count_) % kMaxEvents] = event;
  ++event_count_;
}

}  // namespace dripfeed::packet
