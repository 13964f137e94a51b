// The machine: inputs, commands and time, each taken to a row of the table. What goes out is in feed_output.cpp.
#include "protocol/feed/feed.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "protocol/feed/state_groups.h"
#include "protocol/tape_code/parity.h"

namespace dripfeed::feed {
namespace {

constexpr std::array<std::pair<Refusal, std::string_view>, 5> kRefusals{{
    {Refusal::not_in_this_state, "the command has no effect in this state"},
    {Refusal::link_is_down, "the link is down"},
    {Refusal::no_source, "the job has no text"},
    {Refusal::rounds, "a program is sent 1 to 1000000 times"},
    {Refusal::reset_suspected,
     "the control asked for a program (DC1) while the feed was stopped: it may have been reset. Cancel the job; a "
     "restart "
     "is a new job"},
}};

constexpr std::array<std::pair<Command, Input>, 7> kCommands{{
    {Command::disarm, Input::disarm},
    {Command::stop, Input::stop},
    {Command::resume, Input::resume},
    {Command::cancel, Input::cancel},
    {Command::abort, Input::abort},
    {Command::resume_as_if_dc1, Input::resume_as_dc1},
    {Command::confirm_reset, Input::confirm_reset},
}};

struct SignalRow {
  Signal signal;
  Input input;
  Cause cause;
};
constexpr std::array<SignalRow, 8> kSignals{{
    {Signal::dc1, Input::dc1, Cause::dc1},
    {Signal::dc2, Input::punch_code, Cause::none},
    {Signal::dc3, Input::dc3, Cause::dc3},
    {Signal::dc4, Input::punch_code, Cause::none},
    {Signal::eot, Input::eot, Cause::eot},
    {Signal::syn, Input::broken, Cause::syn},
    {Signal::nak, Input::broken, Cause::nak},
    {Signal::unexpected, Input::broken, Cause::unexpected_input},
}};
constexpr bool signals_in_order() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    if (static_cast<std::size_t>(kSignals[i].signal) != i) return false;
  }
  return true;
}
static_assert(signals_in_order());

}  // namespace

std::string_view message(Refusal refusal) {
  for (const auto& [key, text] : kRefusals) {
    if (key == refusal) return text;
  }
  return {};
}

Feed::Feed(const Settings& settings)
    : settings_(settings),
      char_time_(char_time(settings)),
      clock_(char_time_, burst(settings), settings.latency_chars) {
  counters_.estimated = settings.blind;
}

std::expected<Feed, SettingsRefusal> Feed::make(const Settings& settings, LeftAs left) {
  if (const auto valid = validate(settings); !valid) return std::unexpected(valid.error());
  Feed feed(settings);
  if (left == LeftAs::torn) feed.state_ = State::torn;
  feed.stall_ = feed.present_stall();
  return feed;
}

std::expected<void, Refusal> Feed::arm(const Job& job, Time now) {
  step_to(now);
  if (job.source == nullptr) return std::unexpected(Refusal::no_source);
  if (!link_up_) return std::unexpected(Refusal::link_is_down);
  if (job.rounds == 0 || job.rounds > kMaxRounds) return std::unexpected(Refusal::rounds);
  const std::optional<Job> before = std::exchange(job_, job);
  const auto taken = react(Input::arm, {.cause = Cause::person});
  if (!taken) job_ = before;
  advance();
  return taken;
}

std::expected<void, Refusal> Feed::command(Command command, Time now) {
  step_to(now);
  for (const auto& [key, input] : kCommands) {
    if (key != command) continue;
    const auto taken = react(input, {.cause = Cause::person});
    advance();
    return taken;
  }
  return std::unexpected(Refusal::not_in_this_state);
}

void Feed::extend_reserve(std::uint64_t wire_offset, Time now) {
  step_to(now);
  reserve_ = std::max(reserve_, wire_offset);
  advance();
}

void Feed::receive(std::span<const std::byte> bytes, Time now) {
  step_to(now);
  for (const std::byte raw : bytes) {
    const auto byte = std::to_integer<std::uint8_t>(raw);
    const Signal signal = classify(byte, settings_.wire.eighth_bit, settings_.flow_characters, settings_.end.eot);
    const SignalRow& row = kSignals[static_cast<std::size_t>(signal)];
    last_input_ = now_;
    if (!hears_trigger(signal, byte)) static_cast<void>(react(row.input, {.cause = row.cause, .byte = byte}));
    advance();
  }
}

// While a text is waited for, characters are no fault: they are compared. One EOB after it is part of it.
bool Feed::hears_trigger(Signal signal, std::uint8_t byte) {
  if (settings_.start != Start::on_trigger) return false;
  const auto eighth_bit = settings_.wire.eighth_bit;
  const std::uint8_t character = tape_code::without_parity(byte, eighth_bit);
  const bool filler = character == '\n' || character == '\r' || character == 0;
  if (std::exchange(after_trigger_, after_trigger_ && filler) && filler) return true;
  if (!awaits_start(state_) || signal != Signal::unexpected) return false;
  if (!tape_code::parity_holds(byte, eighth_bit) || character > tape_code::kLowSevenBits) return false;
  std::copy(heard_.begin() + 1, heard_.end(), heard_.begin());
  heard_.back() = character;
  const std::string_view text = settings_.trigger;
  triggered_ = std::equal(text.begin(), text.end(), heard_.end() - static_cast<std::ptrdiff_t>(text.size()),
                          [](char c, std::uint8_t heard) { return static_cast<std::uint8_t>(c) == heard; });
  after_trigger_ = triggered_;
  return true;
}

void Feed::line(LineChange change, Time now) {
  step_to(now);
  switch (change) {
    case LineChange::link_up:
    case LineChange::cts_on:
    case LineChange::dsr_on: change_line(change, true); break;
    case LineChange::link_down:
    case LineChange::cts_off:
    case LineChange::dsr_off: change_line(change, false); break;
  }
  advance();
}

void Feed::change_line(LineChange change, bool on) {
  const bool is_link = change == LineChange::link_up || change == LineChange::link_down;
  const bool is_cts = change == LineChange::cts_on || change == LineChange::cts_off;
  bool& level = is_link ? link_up_ : is_cts ? cts_on_ : dsr_on_;
  if (level == on) return;
  level = on;
  emit({.kind = is_link  ? EventKind::link_changed
                : is_cts ? EventKind::cts_changed
                         : EventKind::dsr_changed,
        .up = on});
  if (!flow_stopped()) clock_.go_on(now_);
  if (on) return;
  if (flow_stopped()) {
    clock_.pause(now_);
    flow_off_at_ = now_;
  }
  const Cause cause = is_link ? Cause::link_lost : is_cts ? Cause::cts_off : Cause::dsr_off;
  const bool holds = is_cts ? cts_holds() : !is_link && dsr_is_flow(settings_.flow);
  const bool ends = is_link || (!is_cts && settings_.watch_dsr);
  if (holds) static_cast<void>(react(Input::line_off, {.cause = cause}));
  if (ends) static_cast<void>(react(Input::broken, {.cause = cause}));
}

void Feed::tick(Time now) {
  step_to(now);
  advance();
}

// Time first: what became true by now happened before the input that comes now.
void Feed::step_to(Time now) {
  if (now > now_) {
    const Time passed = now - now_;
    if (is_held(state_)) counters_.held_for += passed;
    if (stall_ != Stall::none && is_on_the_line(state_)) counters_.stalled_for += passed;
    now_ = now;
  }
  if (has_job(state_)) counters_.clocked = certain_by_now();
  update_progress();
}

// After a change: move on where conditions hold, take text, allow what may go out, name the stall.
void Feed::advance() {
  update_progress();
  if (may_hand(state_)) {
    fill();
    update_progress();
  }
  credit_ = clock_.credit(now_);
  const Stall stall = present_stall();
  if (stall == stall_) return;
  stall_ = stall;
  emit({.kind = EventKind::stall_changed, .stall = stall});
}

void Feed::update_progress() {
  const std::span<const Progress> rows = progress();
  for (std::size_t i = 0; i < rows.size();) {
    const Progress& row = rows[i];
    if (row.from != state_ || !holds(row.condition)) {
      ++i;
      continue;
    }
    if (row_taken_ != nullptr) row_taken_(row_context_, reactions().size() + i);
    const bool starts = row.condition == Condition::starts_open || row.condition == Condition::starts_held;
    const Cause cause = row.condition == Condition::expired ? Cause::expired
                        : row.condition == Condition::quiet ? Cause::quiet
                        : starts && triggered_              ? Cause::trigger
                                                            : Cause::none;
    perform(row.action, {.cause = cause}, row.to);
    i = 0;
  }
}

bool Feed::holds(Condition condition) const {
  switch (condition) {
    case Condition::starts_open: return starts_by_itself() && !control_holds_;
    case Condition::starts_held: return starts_by_itself() && control_holds_;
    case Condition::expired: return now_ >= expires_at_;
    case Condition::program_handed: return counters_.handed >= program_end_wire_;
    case Condition::all_handed: return counters_.handed >= round_begin_ + round_length_;
    case Condition::block_clocked: return at_block_end_ && line_is_drained();
    case Condition::line_drained: return line_is_drained();
    case Condition::shut:
      return settings_.end.quiet && is_shut_after_the_end() && now_ >= flow_off_at_ + *settings_.end.quiet;
    case Condition::round_left: return job_ && round_ < job_->rounds;
    case Condition::quiet: return settings_.end.quiet && line_is_drained() && now_ >= quiet_at();
  }
  return false;
}

bool Feed::holds(Guard guard) const {
  switch (guard) {
    case Guard::always: return true;
    case Guard::in_block: return in_block();
    case Guard::between_blocks: return !in_block();
    case Guard::dc3_ends: return settings_.end.dc3;
    case Guard::dc3_holds: return !settings_.end.dc3;
    case Guard::dc1_starts: return settings_.start != Start::on_trigger;
    case Guard::dc1_is_no_start: return settings_.start == Start::on_trigger;
  }
  return false;
}

// An arming that starts by itself still waits, and expires, while a flow line is off.
bool Feed::starts_by_itself() const {
  return settings_.start == Start::at_once ? !flow_stopped() : settings_.start == Start::on_trigger && triggered_;
}

// The control stopped us when, by line time, no more than trailer was left to send; one character is within what the
// clocks and the look at the line may be off. What the driver still has goes out by itself if the control ever asks.
bool Feed::is_shut_after_the_end() const {
  return flow_stopped() && counters_.handed + 1 >= program_end_wire_ + clock_.left_at_pause() &&
         counters_.handed >= program_end_wire_;
}

// May an unfinished block have reached the control? No only if what was handed ends with a whole block and the line has
// brought all of it, or none of it is more than leader, or all that is still in transit is trailer.
bool Feed::in_block() const {
  const std::uint64_t handed = counters_.handed;
  if (handed >= program_end_wire_) return counters_.clocked < program_end_wire_;
  if (handed <= round_begin_ + settings_.wire.leader_chars) return false;
  return !(at_block_end_ && line_is_drained() && counters_.clocked == handed);
}

bool Feed::line_is_drained() const {
  return clock_.is_drained(now_) && network_has_.value_or(counters_.handed) >= counters_.handed;
}

// What left by the line's time, as far as the network has it.
std::uint64_t Feed::left_by_now() {
  const std::uint64_t by_time = clock_.clocked(now_);
  return std::min(by_time, network_has_.value_or(by_time));
}

// What is certain even if the link below is lost at this moment with all that it holds. Never falls.
std::uint64_t Feed::certain_by_now() {
  std::uint64_t certain = left_by_now();
  if (settings_.blind) {
    certain = std::min(certain, clock_.clocked_before(now_ - char_time_ * std::int64_t{kBlindHold}));
  }
  return std::max(counters_.clocked, certain);
}

std::expected<void, Refusal> Feed::react(Input input, Trigger trigger) {
  const std::span<const Reaction> rows = reactions();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Reaction& row = rows[i];
    if (row.from != state_ || row.input != input || !holds(row.guard)) continue;
    if (row_taken_ != nullptr) row_taken_(row_context_, i);
    if (row.action == Action::refuse) {
      emit({.kind = EventKind::command_refused, .input = input});
      const bool resumes = input == Input::resume || input == Input::resume_as_dc1;
      const bool suspected = resumes && state_ == State::reset_suspected;
      return std::unexpected(suspected ? Refusal::reset_suspected : Refusal::not_in_this_state);
    }
    if (input == Input::dc3) control_holds_ = true;
    if (input == Input::dc1 || input == Input::resume_as_dc1) control_holds_ = false;
    perform(row.action, trigger, row.to);
    return {};
  }
  // The table has a row for all; if it ever had not, stopping is the answer that sends nothing.
  perform(Action::fail, trigger, State::torn);
  return {};
}

void Feed::perform(Action action, Trigger trigger, State to) {
  switch (action) {
    case Action::none:
    case Action::refuse:
    case Action::change: break;
    case Action::note: note_input(trigger); break;
    case Action::unarmed: emit({.kind = EventKind::dc1_unarmed, .byte = trigger.byte}); break;
    case Action::remember: emit({.kind = EventKind::dc3_seen, .byte = trigger.byte}); break;
    case Action::arm: take_job(); break;
    case Action::again: take_round(); break;
    case Action::start: counters_.started_at = now_; break;
    case Action::hold: ++counters_.holds; break;
    case Action::release: break;
    case Action::stand_in: emit({.kind = EventKind::resumed_by_person}); break;
    case Action::end:
    case Action::fail: end_job(action, trigger.cause); break;
    case Action::clear:
      job_.reset();
      control_holds_ = false;
      end_cause_ = Cause::none;
      break;
  }
  if (state_ != to) enter(to, trigger.cause);
}

void Feed::take_job() {
  reserve_ = job_->reserve;
  round_ = 0;
  clock_.restart();
  rested_ = Time::zero();
  counters_ = Counters{.estimated = settings_.blind};
  network_has_.reset();
  end_interval_ = {};
  take_round();
}

// The text from its start. Offsets and counters go on over all rounds, so that the ledger needs to know of none.
void Feed::take_round() {
  const ProgramFacts& facts = job_->facts;
  const tape_code::WireFormat& wire = settings_.wire;
  ++round_;
  round_begin_ = counters_.handed;
  round_length_ = tape_code::wire_length(wire, facts.text_bytes(), facts.eobs(), facts.odd_blocks());
  encoder_.emplace(wire, *job_->source, facts.text_bytes());
  wire_bytes_ = round_begin_ + round_length_ * (job_->rounds - round_ + 1);
  program_end_wire_ = round_begin_ +
                      wire_length(wire, facts.program_bytes(), facts.program_eobs(), facts.program_odd_blocks()) -
                      std::uint64_t{wire.trailer_chars};
  expires_at_ = now_ + job_->expires_after;
  out_begin_ = 0;
  out_end_ = 0;
  source_ = tape_code::FillStatus::more;
  at_block_end_ = true;
  heard_ = {};
  triggered_ = false;
  stands_since_.reset();
  last_queue_ = 0;
  counters_.ended_at = Time::zero();
  end_cause_ = Cause::none;
}

// Freezes what is known. A clean end leaves the link as it is: what left arrives. The source is not touched any more,
// so it may go.
void Feed::end_job(Action action, Cause cause) {
  counters_.clocked = action == Action::end ? left_by_now() : certain_by_now();
  counters_.ended_at = now_;
  end_interval_ = interval();
  end_cause_ = cause;
  source_ = tape_code::FillStatus::end;
}

void Feed::enter(State to, Cause cause) {
  const State from = std::exchange(state_, to);
  // The DC3 that ended a reading holds nothing.
  if (to == State::done && settings_.end.dc3) control_holds_ = false;
  emit({.kind = EventKind::state_changed, .from = from, .to = to, .cause = cause});
}

}  // namespace dripfeed::feed
