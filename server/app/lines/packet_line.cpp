// Everything but report() runs on the links' thread; others post. After each input: pump what may go out, drain the
// events, publish the report. The sender decides what may be written; this file never makes a byte.
#include "server/app/lines/packet_line.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "protocol/packet/packet.h"
#include "server/app/lines/kept_link.h"
#include "server/app/ports/line_mutex.h"
#include "server/machine/line_protocol.h"
#include "server/machine/receive_settings.h"

namespace dripfeed::app {

namespace {

constexpr std::size_t kInputBytes = 256;
constexpr std::size_t kMaxReceptions = 16;
constexpr feed::Time kHoldShown = std::chrono::seconds(1);

struct StateRow {
  packet::State packet;
  LineState line;
  JobEnd end;
};
// One row a state of the sender, in its order.
constexpr std::array<StateRow, packet::kStates> kStateRows = {{
    {packet::State::idle, LineState::idle, JobEnd::none},
    {packet::State::armed, LineState::armed, JobEnd::none},
    {packet::State::calling, LineState::feeding, JobEnd::none},
    {packet::State::receiving, LineState::feeding, JobEnd::none},
    {packet::State::sending, LineState::feeding, JobEnd::none},
    {packet::State::waiting, LineState::feeding, JobEnd::none},
    {packet::State::ready, LineState::feeding, JobEnd::none},
    {packet::State::closing, LineState::draining, JobEnd::none},
    {packet::State::done, LineState::idle, JobEnd::done},
    {packet::State::failed, LineState::idle, JobEnd::failed},
    {packet::State::torn, LineState::torn, JobEnd::failed},
    {packet::State::cancelled, LineState::idle, JobEnd::cancelled},
    {packet::State::disarmed, LineState::idle, JobEnd::disarmed},
}};

constexpr bool rows_in_order() {
  for (std::size_t i = 0; i < kStateRows.size(); ++i) {
    if (static_cast<std::size_t>(kStateRows[i].packet) != i) return false;
  }
  return true;
}
static_assert(rows_in_order());

// A receiver that is late with its answer holds the feed, as a DC3 does.
bool holds(packet::Stall stall) {
  return stall == packet::Stall::waiting_for_ack || stall == packet::Stall::waiting_for_receiver ||
         stall == packet::Stall::stopped_by_person || stall == packet::Stall::partner_sends;
}

double to_seconds(feed::Time time) { return static_cast<double>(time.count()) / 1e9; }

class PacketLine final : public Line, private LinkListener, private Ticker {
 public:
  PacketLine(packet::Sender sender, const machine::LineSettings& settings, LinkThread& thread, LineChanged changed)
      : sender_(std::move(sender)), thread_(thread), changed_(std::move(changed)), link_(settings, thread, *this) {
    thread_.run([this] {
      thread_.add(*this);
      link_.open();
      publish();
    });
  }

  ~PacketLine() override {
    thread_.run([this] {
      thread_.remove(*this);
      link_.close();
    });
  }

  std::expected<void, std::string> arm(LineOrder order) override {
    if (order.rounds != 1) return std::unexpected(std::string("a transfer in packets sends its program once"));
    std::expected<void, std::string> result;
    thread_.run([&] { result = arm_here(std::move(order)); });
    return result;
  }

  std::expected<void, std::string> command(feed::Command command) override {
    std::expected<void, std::string> result;
    thread_.run([&] {
      if (const auto done = sender_.command(command, now()); !done) {
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
      sender_.extend_reserve(wire_offset, now());
      pump_and_publish();
    });
  }

  std::vector<Reception> take_receptions() override {
    const std::lock_guard lock(report_mutex_);
    return std::exchange(receptions_, {});
  }

  [[nodiscard]] LineReport report() const override {
    const std::lock_guard lock(report_mutex_);
    return report_;
  }

  [[nodiscard]] std::shared_ptr<WireTap> tap() const override { return link_.tap(); }

 private:
  [[nodiscard]] feed::Time now() const { return thread_.clock().now(); }

  // What came before the arming is heard before it: a start that the control gave then must not start this. Whoever
  // sends faster than it can be heard is not armed.
  std::expected<void, std::string> hear_first() {
    if (link_.get() == nullptr) return {};
    take_input();
    pump_and_publish();
    return link_.all_heard();
  }

  std::expected<void, std::string> arm_here(LineOrder order) {
    if (auto heard = hear_first(); !heard) return heard;
    const feed::Job job{.facts = order.facts,
                        .source = order.source.get(),
                        .expires_after = order.expires_after,
                        .reserve = order.reserve};
    if (const auto armed = sender_.arm(job, now(), order.file_name); !armed) {
      const std::string_view state = packet::name(sender_.state());
      pump_and_publish();
      return std::unexpected(fmt::format("{} (the line is {})", feed::message(armed.error()), state));
    }
    // The sender reads the source until the job is over, so the source lives until the next order.
    source_ = std::move(order.source);
    order_job_ = order.job;
    session_ = order.session;
    reserve_ = order.reserve;
    pump_and_publish();
    return {};
  }

  void on_up() override {
    link_.came_up();
    sender_.link(true, now());
    pump_and_publish();
  }
  void on_receive(std::span<const std::byte> bytes) override {
    link_.heard(bytes);
    sender_.receive(bytes, now());
    pump_and_publish();
  }
  void on_writable() override { pump_and_publish(); }
  // A packet that CTS holds back is answered late, which is a stall with a name.
  void on_cts(bool on) override { link_.signal(on ? WireKind::cts_on : WireKind::cts_off); }
  void on_dsr(bool on) override {
    link_.signal(on ? WireKind::dsr_on : WireKind::dsr_off);
    if (link_.settings().watch_dsr) sender_.link(on, now());
    pump_and_publish();
  }
  void on_lost(std::string_view reason) override {
    link_.was_lost(reason);
    sender_.link(false, now());
    pump_and_publish();
  }

  void tick(feed::Time time) override {
    ticked_at_ = time;
    link_.tick(time);
    sender_.tick(time);
    pump_and_publish();
  }

  [[nodiscard]] std::optional<feed::Time> deadline() const override {
    std::optional<feed::Time> due = sender_.deadline();
    if (const auto reopen = link_.deadline()) due = due ? std::min(*due, *reopen) : *reopen;
    if (holds(sender_.stall())) due = due ? std::min(*due, ticked_at_ + kHoldShown) : ticked_at_ + kHoldShown;
    return due;
  }

  void pump_and_publish() {
    pump();
    while (const auto event = sender_.next_event()) {
      if (event->kind == packet::EventKind::start_unarmed) ++unarmed_starts_;
    }
    keep_telegram();
    publish();
  }

  // What the partner of 3964 sent in between is received as a punch would be, for whoever judges and keeps that.
  void keep_telegram() {
    const auto telegram = sender_.telegram();
    if (telegram.empty()) return;
    const std::lock_guard lock(report_mutex_);
    if (receptions_.size() == kMaxReceptions) return;  // the partner's next call is refused until a person looks
    const receive::Ending ending{
        .by = receive::EndedBy::end_code, .bytes = telegram.size(), .began_at = now(), .at = now()};
    receptions_.push_back({.raw = {telegram.begin(), telegram.end()},
                           .ending = ending,
                           .settings = machine::receive_settings_of(link_.settings())});
    ++received_;
    sender_.take_telegram();
  }

  // One look: a peer that never stops sending must not keep this thread.
  void take_input() {
    std::array<std::byte, kInputBytes> buffer;
    const std::size_t count = link_.read(buffer);
    if (count > 0) sender_.receive(std::span(buffer).first(count), now());
  }

  // Reads before it writes: a receiver that took leave must stop what would go out now.
  void pump() {
    while (link_.get() != nullptr && !sender_.pending_out().empty()) {
      take_input();
      const std::span<const std::byte> out = sender_.pending_out();
      if (out.empty()) return;
      const std::size_t size = out.size();
      const std::size_t taken = link_.write(out);
      sender_.mark_sent(taken, now());
      if (taken < size) return;  // on_writable or the next tick goes on
    }
  }

  [[nodiscard]] LineState line_state() const {
    const LineState state = kStateRows[static_cast<std::size_t>(sender_.state())].line;
    if (state == LineState::feeding && holds(sender_.stall())) return LineState::held;
    return state == LineState::idle && !link_.is_up() ? LineState::disconnected : state;
  }

  void publish() {
    const JobEnd end = kStateRows[static_cast<std::size_t>(sender_.state())].end;
    const packet::Counters counters = sender_.counters();
    const LineState state = line_state();
    const std::string_view stall = packet::name(sender_.stall());
    const std::lock_guard lock(report_mutex_);
    const bool changed = state != report_.state || end != report_.end || stall != report_.stall ||
                         order_job_ != report_.job || session_ != report_.session || received_ != report_.received;
    report_.received = received_;
    report_.job = order_job_;
    report_.session = session_;
    report_.state = state;
    report_.end = end;
    report_.stall = stall;
    report_.stop_wanted = sender_.stop_wanted();
    const packet::Cause cause = sender_.end_cause();
    report_.cause = cause == packet::Cause::none ? std::string_view() : packet::name(cause);
    link_.report(report_);
    report_.total = sender_.total_bytes();
    report_.handed = counters.handed;
    report_.clocked = counters.clocked;
    report_.confirmed = counters.confirmed;
    report_.confirms = true;
    report_.reserve = reserve_;
    report_.known = known();
    report_.holds = counters.holds;
    report_.hold_s = to_seconds(counters.stalled_for);
    report_.line_use = line_use(counters);
    report_.unarmed_starts = unarmed_starts_;
    if (!changed) return;
    ++report_.changes;
    changed_();
  }

  [[nodiscard]] double line_use(const packet::Counters& counters) const {
    if (counters.started_at == feed::Time{}) return 0.0;
    const feed::Time until = counters.ended_at == feed::Time{} ? now() : counters.ended_at;
    const double free_s = to_seconds(until - counters.started_at - counters.stalled_for);
    return free_s > 0.0 ? std::min(1.0, to_seconds(counters.line_time) / free_s) : 0.0;
  }

  [[nodiscard]] KnownInterval known() const {
    const feed::Interval interval = sender_.interval();
    return {.from = interval.from,
            .to = interval.to,
            .from_line = interval.from_position ? interval.from_position->line : 0,
            .to_line = interval.to_position ? interval.to_position->line : 0,
            .to_text = interval.to_position ? interval.to_position->text_offset : 0};
  }

  packet::Sender sender_;
  LinkThread& thread_;
  LineChanged changed_;
  KeptLink link_;
  feed::Time ticked_at_{};
  std::shared_ptr<tape_code::TextSource> source_;
  std::uint64_t order_job_ = 0;
  std::uint64_t session_ = 0;
  std::uint64_t reserve_ = 0;
  std::uint64_t unarmed_starts_ = 0;
  std::uint64_t received_ = 0;
  mutable LineMutex report_mutex_{"a line's report"};
  LineReport report_;
  std::vector<Reception> receptions_;  // guarded by report_mutex_
};

}  // namespace

std::expected<std::unique_ptr<Line>, std::string> make_packet_line(const machine::LineSettings& settings,
                                                                   LinkThread& thread, LineChanged changed,
                                                                   feed::LeftAs left) {
  const auto effective = machine::effective_line(settings);
  if (!effective) return std::unexpected(effective.error());
  const auto packet_settings = machine::packet_settings_of(*effective);
  if (!packet_settings) return std::unexpected(packet_settings.error());
  auto sender = packet::Sender::make(*packet_settings, left);
  if (!sender) return std::unexpected(std::string(packet::message(sender.error())));
  return std::make_unique<PacketLine>(std::move(*sender), *effective, thread, std::move(changed));
}

}  // namespace dripfeed::app
