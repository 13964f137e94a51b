// Everything but report() runs on the links' thread; others post. After each input: pump what may go out, read the
// events, publish the report. The feed decides what may be written; this file never makes a byte.
#include "server/app/lines/feed_line.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "protocol/feed/state_groups.h"
#include "server/app/lines/feed_line_states.h"
#include "server/app/lines/kept_link.h"
#include "server/app/lines/line_input.h"
#include "server/app/ports/line_mutex.h"

namespace dripfeed::app {

namespace {

constexpr std::size_t kInputBytes = 256;
constexpr feed::Time kTick = std::chrono::milliseconds(1);
constexpr feed::Time kCountersShown =
    std::chrono::milliseconds(20);  // news are reported at once, counters alone so often
constexpr std::string_view kHoldsControl = "holding the control: what it sent before is not taken yet";
constexpr feed::Time kHoldShown = std::chrono::seconds(1);  // a hold has no deadline, but people see how long it lasts

double to_seconds(feed::Time time) { return static_cast<double>(time.count()) / 1e9; }

class FeedLine final : public Line, private LinkListener, private Ticker {
 public:
  FeedLine(feed::Feed feed, const machine::LineSettings& settings, LinkThread& thread, LineChanged changed)
      : feed_(std::move(feed)), thread_(thread), changed_(std::move(changed)), link_(settings, thread, *this) {
    if (settings.receive.enabled) input_.emplace(machine::receive_settings_of(settings));
    thread_.run([this] {
      thread_.add(*this);
      link_.open();
      publish();
    });
  }

  ~FeedLine() override {
    thread_.run([this] {
      thread_.remove(*this);
      link_.close();
    });
  }

  std::expected<void, std::string> arm(LineOrder order) override {
    std::expected<void, std::string> result;
    thread_.run([&] { result = arm_here(std::move(order)); });
    return result;
  }

  std::expected<void, std::string> command(feed::Command command) override {
    std::expected<void, std::string> result;
    thread_.run([&] {
      if (const auto done = feed_.command(command, now()); !done) {
        result = std::unexpected(std::string(feed::message(done.error())));
      }
      pump_and_publish();
    });
    return result;
  }

  void extend_reserve(std::uint64_t job, std::uint64_t wire_offset) override {
    thread_.post([this, job, wire_offset] {
      if (job != order_job_) return;  // a window of a job that is over
      reserve_ = std::max(reserve_, wire_offset);
      feed_.extend_reserve(wire_offset, now());
      pump_and_publish();
    });
  }

  void answer_booked(std::uint64_t serial) override {
    thread_.post([this, serial] {
      if (!of_answer_ || serial != answer_serial_) return;  // of an answer that is over
      feed_.extend_reserve(feed_.wire_bytes(), now());
      pump_and_publish();
    });
  }

  std::vector<Reception> take_receptions() override {
    if (!input_) return {};
    std::vector<Reception> finished = input_->take_finished();
    // A control that was held has room again, and nothing that it sends would say so.
    if (!finished.empty() && link_.settings().receive.hold != receive::Hold::none) {
      thread_.post([this] {
        input_->tick(now());
        pump_and_publish();
      });
    }
    return finished;
  }

  std::expected<void, std::string> answer(Answer answer) override {
    std::expected<void, std::string> result;
    thread_.run([&] { result = answer_here(std::move(answer)); });
    return result;
  }

  [[nodiscard]] LineReport report() const override {
    const std::lock_guard lock(report_mutex_);
    return report_;
  }

  [[nodiscard]] std::shared_ptr<WireTap> tap() const override { return link_.tap(); }

 private:
  [[nodiscard]] feed::Time now() const { return thread_.clock().now(); }

  // A person's job goes before an answer that no one fetched.
  void drop_waiting_answer() {
    if (of_answer_ && feed_.state() == feed::State::armed) {
      static_cast<void>(feed_.command(feed::Command::disarm, now()));
    }
  }

  // What came before the arming is heard before it: a start that the control gave then must not start this. Whoever
  // sends faster than it can be heard is not armed.
  std::expected<void, std::string> hear_first() {
    if (link_.get() == nullptr) return {};
    take_input();
    pump_and_publish();
    return link_.all_heard();
  }

  std::expected<void, std::string> answer_here(Answer answer) {
    if (auto heard = hear_first(); !heard) return heard;
    drop_waiting_answer();
    if (input_ && !input_->idle()) return std::unexpected("the control sends a program");
    const feed::Job job{.facts = answer.facts, .source = answer.source.get(), .expires_after = answer.expires_after};
    if (const auto armed = feed_.arm(job, now()); !armed) {
      const std::string_view state = feed::name(feed_.state());
      pump_and_publish();
      return std::unexpected(fmt::format("{} (the line is {})", feed::message(armed.error()), state));
    }
    source_ = std::move(answer.source);
    of_answer_ = true;
    ++answer_serial_;
    pump_and_publish();
    return {};
  }

  std::expected<void, std::string> arm_here(LineOrder order) {
    if (auto heard = hear_first(); !heard) return heard;
    drop_waiting_answer();
    if (input_ && !input_->idle()) return std::unexpected("the control sends a program");
    const feed::Job job{.facts = order.facts,
                        .source = order.source.get(),
                        .expires_after = order.expires_after,
                        .rounds = order.rounds,
                        .reserve = order.reserve};
    if (const auto armed = feed_.arm(job, now()); !armed) {
      const std::string_view state = feed::name(feed_.state());
      pump_and_publish();
      return std::unexpected(fmt::format("{} (the line is {})", feed::message(armed.error()), state));
    }
    // The feed reads the source until it is over, so the source lives until the next order.
    source_ = std::move(order.source);
    of_answer_ = false;
    order_job_ = order.job;
    session_ = order.session;
    reserve_ = order.reserve;
    pump_and_publish();
    return {};
  }

  // --- link
  // -------------------------------------------------------------------------------------------------------------
  void on_up() override {
    link_.came_up();
    rts_ = true;  // every driver raises it
    // A new link begins with both on and reports what is not; what the lost one last said is worth nothing.
    feed_.line(feed::LineChange::cts_on, now());
    feed_.line(feed::LineChange::dsr_on, now());
    feed_.line(feed::LineChange::link_up, now());
    pump_and_publish();
  }
  void on_receive(std::span<const std::byte> bytes) override {
    link_.heard(bytes);
    take(bytes);
    pump_and_publish();
  }
  void on_writable() override { pump_and_publish(); }
  void on_cts(bool on) override {
    link_.signal(on ? WireKind::cts_on : WireKind::cts_off);
    feed_.line(on ? feed::LineChange::cts_on : feed::LineChange::cts_off, now());
    pump_and_publish();
  }
  void on_dsr(bool on) override {
    link_.signal(on ? WireKind::dsr_on : WireKind::dsr_off);
    feed_.line(on ? feed::LineChange::dsr_on : feed::LineChange::dsr_off, now());
    pump_and_publish();
  }
  void on_lost(std::string_view reason) override {
    link_.was_lost(reason);
    feed_.line(feed::LineChange::link_down, now());
    if (input_) input_->link_lost(now());
    pump_and_publish();
  }

  // --- ticks
  // ------------------------------------------------------------------------------------------------------------
  void tick(feed::Time time) override {
    ticked_at_ = time;
    link_.tick(time);
    if (Link* link = link_.get()) {
      if (const auto unsent = link->unsent()) feed_.report_queue(*unsent, time);
      if (const auto unconfirmed = link->unconfirmed()) feed_.report_unconfirmed(*unconfirmed, time);
    }
    feed_.tick(time);
    if (input_) input_->tick(time);
    pump_and_publish();
  }

  [[nodiscard]] std::optional<feed::Time> deadline() const override {
    const std::optional<feed::Time> feed_deadline = feed_.deadline();
    std::optional<feed::Time> due = feed_deadline ? std::optional(on_grid(*feed_deadline)) : std::nullopt;
    if (const auto reopen = link_.deadline()) due = due ? std::min(*due, *reopen) : *reopen;
    if (const auto quiet = input_ ? input_->deadline() : std::nullopt) {
      due = due ? std::min(*due, on_grid(*quiet)) : on_grid(*quiet);
    }
    const bool held = kFeedStateRows[static_cast<std::size_t>(feed_.state())].line == LineState::held;
    if (held) due = due ? std::min(*due, ticked_at_ + kHoldShown) : ticked_at_ + kHoldShown;
    if (unpublished_) due = due ? std::min(*due, published_at_ + kCountersShown) : published_at_ + kCountersShown;
    return due;
  }

  // Slow lines wake together, once in the half of what they have left when they are refilled: hundreds of wakes become
  // one. Where that is under half a millisecond the exact instant counts.
  [[nodiscard]] feed::Time on_grid(feed::Time instant) const {
    const feed::Time char_time = feed_.paced_char_time();
    const std::uint32_t left = feed::LineClock::left_at_refill(char_time, feed::burst(feed_.settings()));
    for (const feed::Time grid : {kTick, kTick / 2}) {
      if (char_time * std::int64_t{left} >= 2 * grid) return (instant + grid - feed::Time(1)) / grid * grid;
    }
    return instant;
  }

  // --- pump
  // -------------------------------------------------------------------------------------------------------------
  void pump_and_publish() {
    pump();
    // The report says what the events changed; only a start that found nothing armed leaves no other trace.
    while (const auto event = feed_.next_event()) {
      if (event->kind == feed::EventKind::dc1_unarmed) ++unarmed_starts_;
    }
    publish();
  }

  // What came in by now, as far as one look takes: a peer that never stops sending must not keep this thread.
  void take_input() {
    std::array<std::byte, kInputBytes> buffer;
    const std::size_t count = link_.read(buffer);
    if (count > 0) take(std::span(buffer).first(count));
  }

  // While a job is on the line all that comes in is the feed's. At rest the receiver has it, and the feed its signs.
  // What disarmed a job may be the first character of a punch; what broke a feed is not.
  void take(std::span<const std::byte> bytes) {
    if (!input_) return feed_.receive(bytes, now());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const auto byte = bytes.subspan(i, 1);
      const feed::State before = feed_.state();
      const bool at_rest = !feed::has_job(before);
      const bool for_feed = !at_rest || input_->idle();
      if (for_feed) feed_.receive(byte, now());
      const bool disarmed = before == feed::State::armed && !feed::has_job(feed_.state());
      if (!at_rest && !disarmed) continue;
      const auto ended = input_->take(byte.front(), now());
      const bool sign = ended && (*ended == receive::EndedBy::reader_on || *ended == receive::EndedBy::reset);
      if (sign && !for_feed) feed_.receive(byte, now());
    }
  }

  // Reads before it writes: a DC3 that is here already must stop what would go out now.
  void pump() {
    hold_control();
    while (link_.get() != nullptr) {
      if (feed_.pending_out().empty()) return;
      take_input();
      const std::span<const std::byte> out = feed_.pending_out();
      if (out.empty()) return;
      const std::size_t taken = link_.write(out);
      feed_.mark_sent(taken, now());
      if (taken < out.size()) return;  // on_writable or the next tick goes on
    }
  }

  // Our own hold: RTS, or DC3 and DC1. On a torn line nothing goes out, and during a job only the job.
  void hold_control() {
    Link* const link = link_.get();
    if (link == nullptr || !link_.is_up() || !input_) return;
    if (input_->rts() != rts_) {
      rts_ = input_->rts();
      static_cast<void>(link->set_rts(rts_));  // a profile for a link without it is refused
    }
    if (input_->pending_out().empty()) return;
    if (feed::has_job(feed_.state()) || feed_.state() == feed::State::torn) return;
    input_->mark_sent(link_.write(input_->pending_out()));
  }

  [[nodiscard]] LineState state_now(LineState of_feed) const {
    if (of_answer_ && feed::has_job(feed_.state())) return LineState::answering;
    if (of_feed != LineState::idle) return of_feed;
    if (!link_.is_up()) return LineState::disconnected;
    return input_ && !input_->idle() ? LineState::receiving : LineState::idle;
  }

  // What is new is reported at once. Counters alone are reported now and then: they change with every write, and where
  // a byte lies in the text is looked up for each report.
  void publish() {
    const FeedStateRow& row = kFeedStateRows[static_cast<std::size_t>(feed_.state())];
    const LineState state = state_now(row.line);
    const std::uint64_t received = input_ ? input_->count() : 0;
    // What the last job came to stays as it was while an answer is on the line.
    const JobEnd end = of_answer_ ? report_.end : row.end;
    const bool holds = input_ && input_->holding();
    const AnswerReport answer = of_answer_ ? answer_now() : report_.answer;
    const std::string_view of_feed = name_of(feed_.stall());
    const std::string_view stall = of_feed.empty() && holds ? kHoldsControl : of_feed;
    const bool changed = state != report_.state || end != report_.end || stall != report_.stall ||
                         order_job_ != report_.job || session_ != report_.session || received != report_.received ||
                         answer != report_.answer;
    const bool news = changed || unarmed_starts_ != report_.unarmed_starts || link_.error() != report_.link_error;
    const feed::Time time = now();
    unpublished_ = !news && time < published_at_ + kCountersShown;
    if (unpublished_) return;
    published_at_ = time;
    const std::lock_guard lock(report_mutex_);
    report_.job = order_job_;
    report_.session = session_;
    report_.state = state;
    report_.end = end;
    report_.stall = stall;
    report_.received = received;
    report_.receptions_lost = input_ ? input_->lost() : 0;
    report_.answer = answer;
    report_.stop_wanted = std::ranges::find(kFeedStopStates, feed_.state()) != kFeedStopStates.end();
    if (!of_answer_) publish_job(feed_.counters());
    report_.char_s = to_seconds(feed_.paced_char_time());
    report_.unarmed_starts = unarmed_starts_;
    link_.report(report_);
    if (!changed) return;
    ++report_.changes;
    changed_();
  }

  [[nodiscard]] AnswerReport answer_now() const {
    const AnswerStage stage = answer_stage_of(feed_.state());
    const bool over = stage == AnswerStage::torn || stage == AnswerStage::whole;
    return {.serial = answer_serial_,
            .stage = stage,
            .total = feed_.wire_bytes(),
            .cause = over ? feed::name(feed_.end_cause()) : std::string_view()};
  }

  void publish_job(const feed::Counters& counters) {
    report_.cause = feed_.end_cause() == feed::Cause::none ? std::string_view() : feed::name(feed_.end_cause());
    report_.total = feed_.wire_bytes();
    report_.handed = counters.handed;
    report_.clocked = counters.clocked;
    report_.confirmed = counters.confirmed;
    report_.estimated = counters.estimated;
    report_.reserve = reserve_;
    report_.known = known();
    report_.holds = counters.holds;
    report_.hold_s = to_seconds(counters.held_for);
    report_.line_s = static_cast<double>(counters.clocked) * report_.char_s;
    report_.line_use = feed_.line_use();
  }

  [[nodiscard]] KnownInterval known() const {
    const feed::Interval interval = feed_.interval();
    return {.from = interval.from,
            .to = interval.to,
            .from_line = interval.from_position ? interval.from_position->line : 0,
            .to_line = interval.to_position ? interval.to_position->line : 0,
            .to_text = interval.to_position ? interval.to_position->text_offset : 0};
  }

  feed::Feed feed_;
  LinkThread& thread_;
  LineChanged changed_;
  KeptLink link_;
  bool rts_ = true;  // ours, as the link has it
  feed::Time ticked_at_{};
  std::shared_ptr<tape_code::TextSource> source_;
  std::optional<LineInput> input_;
  bool of_answer_ = false;           // what the feed has, or had last, is an answer and no job
  std::uint64_t answer_serial_ = 0;  // of the last answer that was armed
  std::uint64_t order_job_ = 0;
  std::uint64_t session_ = 0;
  std::uint64_t reserve_ = 0;
  std::uint64_t unarmed_starts_ = 0;
  feed::Time published_at_{};
  bool unpublished_ = false;  // counters changed since, and nothing else
  mutable LineMutex report_mutex_{"a line's report"};
  LineReport report_;
};

}  // namespace

std::expected<std::unique_ptr<Line>, std::string> make_feed_line(const machine::LineSettings& settings,
                                                                 LinkThread& thread, LineChanged changed,
                                                                 feed::LeftAs left) {
  const auto effective = machine::effective_line(settings);
  if (!effective) return std::unexpected(effective.error());
  if (const auto receives = machine::can_receive(*effective); !receives) return std::unexpected(receives.error());
  const auto feed_settings = machine::feed_settings_of(*effective);
  if (!feed_settings) return std::unexpected(feed_settings.error());
  auto feed = feed::Feed::make(*feed_settings, left);
  if (!feed) return std::unexpected(feed::message(feed.error()));
  return std::make_unique<FeedLine>(std::move(*feed), *effective, thread, std::move(changed));
}

}  // namespace dripfeed::app
