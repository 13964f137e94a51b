// The sender: what is common to all packet protocols. State changes happen in react() alone, by the table.
#include "protocol/packet/sender.h"

#include <algorithm>
#include <utility>

namespace dripfeed::packet {
namespace {

constexpr Time kSourceRetry = feed::kSourceRetry;

constexpr std::array<std::pair<feed::Command, Input>, 6> kCommands{{
    {feed::Command::disarm, Input::disarm},
    {feed::Command::stop, Input::stop},
    {feed::Command::resume, Input::resume},
    {feed::Command::cancel, Input::cancel},
    {feed::Command::abort, Input::abort},
    {feed::Command::confirm_reset, Input::confirm_reset},
}};

bool is_stalled(Stall stall) {
  return stall != Stall::none && stall != Stall::waiting_for_start && stall != Stall::stopped_by_person;
}

}  // namespace

std::expected<Sender, SettingsFault> Sender::make(const Settings& settings, feed::LeftAs left) {
  if (const auto valid = validate(settings); !valid) return std::unexpected(valid.error());
  Sender sender(settings);
  if (left == feed::LeftAs::torn) sender.state_ = State::torn;
  return sender;
}

Sender::Sender(const Settings& settings)
    : settings_(settings), rules_(make_send_rules(settings)), clock_(settings.char_time, kUnsent, 0) {}

std::expected<void, feed::Refusal> Sender::arm(const feed::Job& job, Time now, std::string_view name) {
  step_to(now);
  if (cell(state_, Input::arm).action == Action::take) {
    if (!link_up_) return std::unexpected(feed::Refusal::link_is_down);
    if (job.source == nullptr) return std::unexpected(feed::Refusal::no_source);
    job_ = job;
    arming_name_ = name;
  }
  const auto taken = react(Input::arm, Cause::person);
  update();
  return taken;
}

std::expected<void, feed::Refusal> Sender::command(feed::Command command, Time now) {
  step_to(now);
  const auto known = std::ranges::find(kCommands, command, &std::pair<feed::Command, Input>::first);
  if (known == kCommands.end()) return std::unexpected(feed::Refusal::not_in_this_state);
  const auto taken = react(known->second, Cause::person);
  update();
  return taken;
}

void Sender::extend_reserve(std::uint64_t offset, Time now) {
  step_to(now);
  reserve_ = std::max(reserve_, offset);
  update();
}

void Sender::receive(std::span<const std::byte> bytes, Time now) {
  step_to(now);
  for (const std::byte byte : bytes) {
    const auto value = static_cast<std::uint8_t>(byte);
    heard(rules_->hear(value, state_), value);
    update();
    if (out_begin_ == out_end_ && link_up_) put_small(rules_->reply(small_), false);
  }
}

void Sender::heard(Heard heard, std::uint8_t byte) {
  switch (heard.signal) {
    case Signal::none: return;
    case Signal::noise: return emit({.kind = EventKind::noticed, .byte = byte});
    case Signal::later: return await_answer();
    case Signal::asked: return static_cast<void>(react(Input::asked, Cause::start));
    case Signal::granted: return static_cast<void>(react(Input::granted));
    case Signal::accepted: return static_cast<void>(react(Input::accepted));
    case Signal::yielded: return static_cast<void>(react(Input::yielded));
    case Signal::telegram: return hear_telegram();
    case Signal::broken: return static_cast<void>(react(Input::broken, heard.cause));
    case Signal::again:
      if (heard.counts && !may_repeat()) {
        const Cause cause = heard.cause == Cause::none ? Cause::too_many_repeats : heard.cause;
        return static_cast<void>(react(Input::broken, cause));
      }
      return static_cast<void>(react(Input::again, heard.cause));
  }
}

// It is whole, and this side's own call is due again.
void Sender::hear_telegram() {
  emit({.kind = EventKind::telegram, .count = static_cast<std::uint32_t>(rules_->telegram().size())});
  static_cast<void>(react(Input::again));
}

// Counts one more attempt; false when there is none left.
bool Sender::may_repeat() {
  if (state_ == State::ready) return true;
  const bool calls = state_ == State::calling || state_ == State::receiving;
  std::uint32_t& count = calls ? calls_ : attempts_;
  return ++count < rules_->patience(state_).attempts;
}

void Sender::link(bool up, Time now) {
  step_to(now);
  if (link_up_ == up) return;
  link_up_ = up;
  if (up) {
    rules_->link_up();
  } else {
    static_cast<void>(react(Input::broken, Cause::link_lost));
    out_begin_ = out_end_ = 0;
  }
  update();
}

void Sender::tick(Time now) {
  step_to(now);
  if (const auto late = late_at(); late && now_ >= *late) {
    waits_since_.reset();
    heard(rules_->late(state_), 0);
    if (out_begin_ == out_end_ && link_up_) put_small(rules_->reply(small_), false);
  }
  update();
}

void Sender::step_to(Time now) {
  if (now <= now_) return;
  if (is_stalled(stall_)) counters_.stalled_for += now - now_;
  now_ = now;
  if (is_on_the_line(state_) && clock_.is_drained(now_)) counters_.clocked = counters_.handed;
}

std::span<const std::byte> Sender::pending_out() const {
  if (!link_up_) return {};
  const std::size_t count = std::min<std::size_t>(out_end_ - out_begin_, credit_);
  const std::span<const std::byte> whole = out_is_frame_ ? std::span<const std::byte>(frame_) : small_;
  return whole.subspan(out_begin_, count);
}

void Sender::mark_sent(std::size_t n, Time now) {
  step_to(now);
  n = std::min(n, out_end_ - out_begin_);
  out_begin_ += n;
  clock_.handed(n, now_);
  if (n > 0 && is_on_the_line(state_)) counters_.line_time += settings_.char_time * static_cast<std::int64_t>(n);
  if (n > 0 && out_begin_ == out_end_ && std::exchange(out_awaited_, false)) static_cast<void>(react(Input::frame_out));
  update();
}

void Sender::put_frame() {
  out_is_frame_ = true;
  out_begin_ = 0;
  out_end_ = frame_size_;
  out_awaited_ = true;
}

void Sender::put_small(std::size_t size, bool awaited) {
  if (size == 0) return;
  out_is_frame_ = false;
  out_begin_ = 0;
  out_end_ = size;
  out_awaited_ = awaited;
  credit_ = clock_.credit(now_);
}

void Sender::await_answer() { waits_since_ = std::max(now_, clock_.drained_at()); }

std::expected<void, feed::Refusal> Sender::react(Input input, Cause cause) {
  const Cell taken = cell(state_, input);
  if (cell_taken_ != nullptr) cell_taken_(cell_context_, state_, input);
  if (taken.action == Action::refuse) {
    emit({.kind = EventKind::command_refused, .input = input});
    return std::unexpected(feed::Refusal::not_in_this_state);
  }
  const bool torn = taken.action == Action::fail && in_block();
  perform(taken.action, input, cause);
  enter(torn ? State::torn : taken.to, cause);
  // A call that the protocol does not make is granted as it is made, an end that it does not state is accepted so.
  if (taken.action == Action::call && out_begin_ == out_end_) return react(Input::granted);
  if (taken.action == Action::close && out_begin_ == out_end_) return react(Input::accepted);
  return {};
}

void Sender::enter(State to, Cause cause) {
  if (state_ == to) return;
  const State from = std::exchange(state_, to);
  emit({.kind = EventKind::state_changed, .from = from, .to = to, .cause = cause});
}

void Sender::perform(Action action, Input input, Cause cause) {
  switch (action) {
    case Action::never:
    case Action::none:
    case Action::refuse:
    case Action::clear: return;
    case Action::unarmed: return emit({.kind = EventKind::start_unarmed});
    case Action::take:
      outbox_.begin(settings_.wire, *job_->source, job_->facts.text_bytes());
      total_ = tape_code::wire_length(settings_.wire, job_->facts.text_bytes(), job_->facts.eobs(),
                                      job_->facts.odd_blocks());
      reserve_ = job_->reserve;
      expires_at_ = now_ + job_->expires_after;
      counters_ = {};
      end_cause_ = Cause::none;
      stop_wanted_ = cancel_wanted_ = asked_ = false;
      frame_size_ = 0;
      return rules_->begin({.name = std::exchange(arming_name_, {}), .bytes = total_});
    case Action::start:
      asked_ = true;
      counters_.started_at = now_;
      return;
    case Action::want_stop: stop_wanted_ = true; return;
    case Action::unwant_stop: stop_wanted_ = false; return;
    case Action::want_cancel: cancel_wanted_ = true; return;
    case Action::call:
      waits_since_.reset();
      if (input == Input::again) {
        ++counters_.repeats;
        emit({.kind = EventKind::repeated, .cause = cause, .count = attempts_ + calls_});
      }
      out_begin_ = out_end_ = 0;
      return put_small(rules_->call(small_), true);
    case Action::give_way:
      out_begin_ = out_end_ = 0;
      out_awaited_ = false;
      return await_answer();
    case Action::send:
    case Action::repeat:
      calls_ = 0;
      waits_since_.reset();
      return put_frame();
    case Action::sent:
      counters_.handed = std::max(counters_.handed, outbox_.frame_end());
      rules_->sent();
      return await_answer();
    case Action::wait: rules_->sent(); return await_answer();
    case Action::accept:
    case Action::accept_asked:
      // The answer to a frame that was repeated for a receiver that only stayed alive accepts nothing new.
      if (!outbox_.framed().empty()) {
        rules_->accepted();
        outbox_.accept();
        ++counters_.frames;
        counters_.confirmed = outbox_.accepted();
        counters_.clocked = counters_.handed;
      }
      asked_ = action == Action::accept_asked;
      attempts_ = 0;
      waits_since_.reset();
      return;
    case Action::note_asked: asked_ = true; return;
    case Action::close:
      waits_since_.reset();
      asked_ = false;
      return put_small(rules_->close(small_), true);
    case Action::part:
    case Action::end:
    case Action::fail: return end_job(action, cause);
  }
}

void Sender::end_job(Action action, Cause cause) {
  end_interval_ = interval();
  const bool inside = action == Action::fail && in_block();
  const bool frame_begun = out_begin_ > 0 && out_begin_ < out_end_;  // what follows would be taken for its rest
  const bool receiver_waits = action == Action::part ||
                              (action == Action::fail && !inside && !frame_begun &&
                               (cause == Cause::person || cause == Cause::text_lost || cause == Cause::bad_character));
  counters_.ended_at = now_;
  end_cause_ = cause;
  waits_since_.reset();
  attempts_ = calls_ = 0;
  out_begin_ = out_end_ = 0;
  out_awaited_ = false;
  job_.reset();
  // A pulled receiver is informed when it asks, and only then.
  if (receiver_waits && link_up_ && (!rules_->is_pulled() || asked_)) put_small(rules_->part(small_), false);
  if (inside && cause == Cause::person && !frame_begun && link_up_) put_small(rules_->abort(small_), false);
  asked_ = false;
}

bool Sender::in_block() const {
  if (!outbox_.block_ends_before()) return true;
  return counters_.handed > outbox_.accepted() && !outbox_.block_ended_before();
}

feed::Interval Sender::interval() const {
  if (!job_) return end_interval_;
  feed::Interval known{.from = outbox_.accepted(), .to = std::max(counters_.handed, outbox_.accepted())};
  known.from_position = outbox_.locate(known.from);
  known.to_position = outbox_.locate(known.to);
  return known;
}

void Sender::update() {
  while (advance()) {
  }
  credit_ = clock_.credit(now_);
  const Stall present = present_stall();
  if (present == stall_) return;
  stall_ = present;
  if (stall_ == Stall::waiting_for_ack || stall_ == Stall::waiting_for_receiver) ++counters_.holds;
  emit({.kind = EventKind::stall_changed, .stall = stall_});
}

// One step that needs no byte from outside; false when there is none.
bool Sender::advance() {
  if (state_ == State::armed) {
    if (now_ >= expires_at_) return static_cast<void>(react(Input::expired, Cause::expired)), true;
    if (rules_->starts_itself() && link_up_) return static_cast<void>(react(Input::asked, Cause::start)), true;
  }
  if (state_ != State::ready || out_begin_ != out_end_) return false;
  if (rules_->is_pulled() && !asked_) return false;
  text_missing_ = ledger_missing_ = false;
  if (advance_ready()) return true;
  if (state_ == State::ready && rules_->is_pulled() && std::exchange(asked_, false))
    put_small(rules_->nothing_now(small_), false);
  return false;
}

bool Sender::advance_ready() {
  const tape_code::FillStatus status = outbox_.fill();
  if (status == tape_code::FillStatus::source_failed || status == tape_code::FillStatus::text_short)
    return static_cast<void>(react(Input::broken, Cause::text_lost)), true;
  if (status == tape_code::FillStatus::no_code)
    return static_cast<void>(react(Input::broken, Cause::bad_character)), true;
  if (cancel_wanted_ && outbox_.block_ends_before()) return static_cast<void>(react(Input::cut, Cause::person)), true;
  if (stop_wanted_ && !cancel_wanted_) return false;
  if (outbox_.complete() && outbox_.available() == 0) return static_cast<void>(react(Input::finished)), true;
  const std::size_t size = rules_->frame_size(outbox_.available(), outbox_.complete());
  if (size == 0) {
    text_missing_ = true;
    source_retry_at_ = now_ + kSourceRetry;
    return false;
  }
  outbox_.frame(size, cancel_wanted_);
  if (outbox_.frame_end() > reserve_) {
    outbox_.frame(0, false);
    ledger_missing_ = true;
    return false;
  }
  frame_size_ = rules_->compose(outbox_.framed(), frame_);
  static_cast<void>(react(Input::frame_ready));
  return true;
}

Stall Sender::present_stall() const {
  const bool shown = waits_since_ && now_ >= *waits_since_ + kShownAfter;
  switch (state_) {
    case State::idle:
    case State::done:
    case State::failed:
    case State::torn:
    case State::cancelled:
    case State::disarmed:
    case State::sending: return Stall::none;
    case State::armed: return Stall::waiting_for_start;
    case State::receiving: return Stall::partner_sends;
    case State::calling: return shown ? Stall::waiting_for_receiver : Stall::none;
    case State::waiting: return shown ? Stall::waiting_for_ack : Stall::none;
    case State::closing: return shown ? Stall::waiting_for_end : Stall::none;
    case State::ready: break;
  }
  if (stop_wanted_ && !cancel_wanted_) return Stall::stopped_by_person;
  if (text_missing_) return Stall::waiting_for_text;
  if (ledger_missing_) return Stall::waiting_for_ledger;
  return rules_->is_pulled() ? Stall::waiting_for_receiver : Stall::none;
}

std::optional<Time> Sender::late_at() const {
  if (!waits_since_) return std::nullopt;
  const auto limit = rules_->patience(state_).limit;
  return limit ? std::optional(*waits_since_ + *limit) : std::nullopt;
}

std::optional<Time> Sender::deadline() const {
  std::optional<Time> due = late_at();
  const auto at = [&](Time instant) { due = due ? std::min(*due, instant) : instant; };
  if (state_ == State::armed) at(expires_at_);
  if (waits_since_ && stall_ == Stall::none) at(*waits_since_ + kShownAfter);
  if (out_begin_ != out_end_ && credit_ == 0 && link_up_) at(clock_.refill_at());
  if (state_ == State::ready && text_missing_ && !rules_->is_pulled()) at(source_retry_at_);
  return due;
}

std::optional<Event> Sender::next_event() {
  if (event_count_ == 0) return std::nullopt;
  const Event event = events_[first_event_];
  first_event_ = (first_event_ + 1) % kMaxEvents;
  --event_count_;
  return event;
}

void Sender::emit(Event event) {
  event.at = now_;
  if (event_count_ == kMaxEvents) {
    first_event_ = (first_event_ + 1) % kMaxEvents;
    --event_count_;
    ++events_dropped_;
  }
  events_[(first_event_ + event_count_) % kMaxEvents] = event;
  ++event_count_;
}

}  // namespace dripfeed::packet
