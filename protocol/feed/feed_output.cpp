// The machine's output side: text taken from the source, what may go out now, deadlines, stalls, counters and events.
#include <algorithm>

#include "protocol/feed/feed.h"
#include "protocol/feed/state_groups.h"

namespace dripfeed::feed {

using tape_code::FillStatus;

// Keeps up to `unsent` wire bytes ready. A text that cannot go on ends the feed.
void Feed::fill() {
  if (source_ == FillStatus::not_ready && now_ < source_retry_at_) return;
  if (source_ != FillStatus::more && source_ != FillStatus::not_ready) return;
  if (out_end_ - out_begin_ >= settings_.unsent) return;
  std::copy(out_.begin() + static_cast<std::ptrdiff_t>(out_begin_),
            out_.begin() + static_cast<std::ptrdiff_t>(out_end_), out_.begin());
  std::copy(out_ends_block_.begin() + static_cast<std::ptrdiff_t>(out_begin_),
            out_ends_block_.begin() + static_cast<std::ptrdiff_t>(out_end_), out_ends_block_.begin());
  out_end_ -= out_begin_;
  out_begin_ = 0;
  const std::size_t room = settings_.unsent - out_end_;
  const auto filled =
      encoder_->fill(std::span(out_).subspan(out_end_, room), std::span(out_ends_block_).subspan(out_end_, room));
  out_end_ += filled.count;
  source_ = filled.status;
  switch (filled.status) {
    case FillStatus::more:
    case FillStatus::end: break;
    case FillStatus::not_ready: source_retry_at_ = now_ + kSourceRetry; break;
    case FillStatus::source_failed:
    case FillStatus::text_short: static_cast<void>(react(Input::broken, {.cause = Cause::text_lost})); break;
    case FillStatus::no_code: static_cast<void>(react(Input::broken, {.cause = Cause::bad_character})); break;
  }
}

std::size_t Feed::allowed() const {
  if (!may_hand(state_)) return 0;  // a lost link is no such state, and a CTS that is off leaves no credit
  if (reserve_ <= counters_.handed) return 0;
  std::uint64_t count = std::min<std::uint64_t>(out_end_ - out_begin_, credit_);
  count = std::min(count, reserve_ - counters_.handed);
  const bool to_block_end = ends_with_block(state_) || settings_.line_delay > Time::zero();
  if (!to_block_end) return count;
  if (ends_with_block(state_) && at_block_end_) return 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (out_ends_block_[out_begin_ + i] != 0) return i + 1;
  }
  return count;
}

std::span<const std::byte> Feed::pending_out() const { return std::span(out_).subspan(out_begin_, allowed()); }

// The bytes are out whatever the state is now, so they are counted before time is looked at. A driver that was not at
// once may even report them when the job is over.
void Feed::mark_sent(std::size_t n, Time now) {
  const std::size_t count = std::min(n, out_end_ - out_begin_);
  if (count > 0) {
    at_block_end_ = out_ends_block_[out_begin_ + count - 1] != 0;
    out_begin_ += count;
    counters_.handed += count;
    clock_.handed(count, std::max(now, now_));
    const bool after_eob =
        counters_.handed > round_begin_ + settings_.wire.leader_chars && counters_.handed <= program_end_wire_;
    if (at_block_end_ && after_eob && settings_.line_delay > Time::zero()) {
      clock_.rest(settings_.line_delay);
      rested_ += settings_.line_delay;
    }
    moved_below();
    if (!has_job(state_)) {
      end_interval_.to = counters_.handed;
      end_interval_.to_position = locate(end_interval_.to);
    }
  }
  step_to(now);
  if (count == 0 && allowed() > 0 && !stands_since_) stands_since_ = now_;
  advance();
}

void Feed::report_queue(std::uint64_t unsent, Time now) {
  step_to(now);
  if (has_job(state_)) {
    clock_.queue_reported(unsent, now_);
    const bool stands = unsent > 0 && unsent >= last_queue_;
    if (!stands) moved_below();
    if (stands && !stands_since_) stands_since_ = now_;
    last_queue_ = unsent;
  }
  advance();
}

// A queue counts as standing from the next report on.
void Feed::moved_below() {
  stands_since_.reset();
  last_queue_ = std::uint64_t{kMaxBudget} + 1;
}

bool Feed::stands_below() const { return stands_since_ && now_ >= *stands_since_ + kStandstill; }

void Feed::report_unconfirmed(std::uint64_t bytes, Time now) {
  if (has_job(state_)) {
    const std::uint64_t confirmed = counters_.handed - std::min(bytes, counters_.handed);
    network_has_ = std::max(network_has_.value_or(0), confirmed);
  }
  step_to(now);
  advance();
}

// A network that has not confirmed by the end of the line time is asked again.
Time Feed::drains_at() const {
  const bool network_is_late = clock_.is_drained(now_) && !line_is_drained();
  return network_is_late ? now_ + kNetworkRetry : clock_.drained_at();
}

Time Feed::quiet_at() const {
  return std::max(clock_.drained_at(), last_input_) + settings_.end.quiet.value_or(Time::zero());
}

std::optional<Time> Feed::deadline() const {
  std::optional<Time> first;
  const auto at = [&](Time time) { first = first ? std::min(*first, time) : time; };
  if (awaits_start(state_)) at(expires_at_);
  const bool wants_more = may_hand(state_) && !(ends_with_block(state_) && at_block_end_);
  if (wants_more && source_ == FillStatus::not_ready) at(source_retry_at_);
  const bool may_be_shut = state_ == State::trailer || state_ == State::draining || state_ == State::ending;
  if (may_be_shut && is_shut_after_the_end() && settings_.end.quiet) at(flow_off_at_ + *settings_.end.quiet);
  if (clock_.paused()) return first;
  if (stands_since_ && !stands_below() && is_on_the_line(state_)) at(*stands_since_ + kStandstill);
  const bool has_more = out_end_ > out_begin_ && reserve_ > counters_.handed;
  if (wants_more && has_more && credit_ == 0) at(clock_.refill_at());
  const bool waits_for_block =
      ends_with_block(state_) || state_ == State::stopping_held || state_ == State::cancelling_held;
  if (waits_for_block && at_block_end_) at(drains_at());
  if (state_ == State::draining || state_ == State::ending) at(drains_at());
  if (settings_.end.quiet && (state_ == State::wait_end || state_ == State::trailer_held)) {
    at(std::max(quiet_at(), drains_at()));
  }
  return first;
}

Stall Feed::present_stall() const {
  if (!link_up_ || (settings_.watch_dsr && !dsr_on_)) return Stall::peer_gone;
  if (awaits_start(state_)) {
    if (settings_.start == Start::at_once) return line_stall();
    return settings_.start == Start::on_dc1 ? Stall::waiting_for_dc1 : Stall::waiting_for_trigger;
  }
  if (state_ == State::stopped || state_ == State::stopped_held) return Stall::stopped_by_person;
  if (state_ == State::reset_suspected) return Stall::reset_suspected;
  if (is_held(state_)) return Stall::held_by_dc3;
  if (state_ == State::wait_end) return Stall::waiting_for_end;
  if (!is_on_the_line(state_)) return Stall::none;
  const bool hands = may_hand(state_) && !(ends_with_block(state_) && at_block_end_);
  if (!hands && line_is_drained()) return Stall::none;
  if (const Stall stall = line_stall(); stall != Stall::none) return stall;
  if (!hands) return Stall::none;
  const bool empty = out_end_ == out_begin_;
  if (empty && source_ == FillStatus::not_ready) return Stall::waiting_for_text;
  if (!empty && reserve_ <= counters_.handed) return Stall::waiting_for_ledger;
  return Stall::none;
}

// What is below us and does not let go what it has.
Stall Feed::line_stall() const {
  if (cts_holds() && !cts_on_) return Stall::cts_off;
  if (dsr_is_flow(settings_.flow) && !dsr_on_) return Stall::dsr_off;
  const bool network_stands = clock_.is_drained(now_ - kStandstill) && !line_is_drained();
  return stands_below() || (is_on_the_line(state_) && network_stands) ? Stall::held_below : Stall::none;
}

Counters Feed::counters() const { return counters_; }

// In the present round; what is older is nowhere.
std::optional<tape_code::WirePosition> Feed::locate(std::uint64_t offset) const {
  if (offset < round_begin_) return std::nullopt;
  auto position = encoder_->locate(offset - round_begin_);
  if (position) position->wire_offset = offset;
  return position;
}

Interval Feed::interval() const {
  if (!has_job(state_)) return end_interval_;
  Interval interval{.from = counters_.clocked, .to = counters_.handed};
  if (encoder_) {
    interval.from_position = locate(interval.from);
    interval.to_position = locate(interval.to);
  }
  return interval;
}

double Feed::line_use() const {
  const Time until = counters_.ended_at > Time::zero() ? counters_.ended_at : now_;
  const Time on_line = until - counters_.started_at - counters_.stalled_for;
  if (counters_.handed == 0 || on_line <= Time::zero()) return 0;
  const double busy = static_cast<double>(counters_.handed) * static_cast<double>(char_time_.count()) +
                      static_cast<double>(rested_.count());
  return std::min(1.0, busy / static_cast<double>(on_line.count()));
}

// An input without effect. Lines have their own event already.
void Feed::note_input(Trigger trigger) {
  if (trigger.cause == Cause::link_lost || trigger.cause == Cause::dsr_off) return;
  const EventKind kind = trigger.cause == Cause::none ? EventKind::punch_code : EventKind::noticed;
  emit({.kind = kind, .cause = trigger.cause, .byte = trigger.byte});
}

void Feed::emit(Event event) {
  event.at = now_;
  event.handed = counters_.handed;
  event.clocked = counters_.clocked;
  if (event_count_ == kMaxEvents) {
    first_event_ = (first_event_ + 1) % kMaxEvents;
    --event_count_;
    ++events_dropped_;
  }
  events_[(first_event_ + event_count_) % kMaxEvents] = event;
  ++event_count_;
}

std::optional<Event> Feed::next_event() {
  if (event_count_ == 0) return std::nullopt;
  const Event event = events_[first_event_];
  first_event_ = (first_event_ + 1) % kMaxEvents;
  --event_count_;
  return event;
}

}  // namespace dripfeed::feed
