// Everything but report() and take_receptions() runs on the links' thread. One text, then the line rests; while nothing
// of it has come, a transfer that broke is begun again.
#include "server/app/lines/packet_receive_line.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "protocol/packet/packet.h"
#include "protocol/receive/transfer.h"
#include "protocol/tape_code/parity.h"
#include "server/app/lines/kept_link.h"
#include "server/app/ports/line_mutex.h"
#include "server/machine/line_protocol.h"
#include "server/machine/receive_settings.h"

namespace dripfeed::app {

namespace {

constexpr feed::Time kRestartAfter = std::chrono::seconds(1);
constexpr std::uint8_t kFilling = 0x1A;  // SUB, after the text in XMODEM's last block

class PacketReceiveLine final : public Line, private LinkListener, private Ticker, private packet::Sink {
 public:
  PacketReceiveLine(const packet::Settings& settings, const machine::LineSettings& line, LinkThread& thread,
                    LineChanged changed)
      : protocol_(settings.protocol),
        // make_packet_receive_line() validated them.
        receiver_(*packet::Receiver::make(settings, *this)),
        judged_by_(machine::receive_settings_of(line)),
        thread_(thread),
        changed_(std::move(changed)),
        link_(line, thread, *this) {
    thread_.run([this] {
      thread_.add(*this);
      link_.open();
      publish();
    });
  }

  ~PacketReceiveLine() override {
    thread_.run([this] {
      thread_.remove(*this);
      link_.close();
    });
  }

  std::expected<void, std::string> arm(LineOrder) override {
    return std::unexpected(std::string("this line only receives"));
  }
  std::expected<void, std::string> command(feed::Command command) override {
    if (command != feed::Command::abort) return std::unexpected(std::string("this line only receives"));
    std::expected<void, std::string> result;
    thread_.run([&] {
      if (const auto done = receiver_.stop(now()); !done) result = std::unexpected(std::string(message(done.error())));
      pump_and_publish();
    });
    return result;
  }
  void extend_reserve(std::uint64_t, std::uint64_t) override {}

  [[nodiscard]] LineReport report() const override {
    const std::lock_guard lock(report_mutex_);
    return report_;
  }
  std::vector<Reception> take_receptions() override {
    const std::lock_guard lock(report_mutex_);
    return std::exchange(receptions_, {});
  }

 private:
  [[nodiscard]] feed::Time now() const { return thread_.clock().now(); }

  void begin() {
    raw_.clear();
    begun_at_ = now();
    static_cast<void>(receiver_.start(now()));
  }

  void on_up() override {
    link_.came_up();
    receiver_.link(true, now());
    if (!over_) begin();
    pump_and_publish();
  }
  void on_receive(std::span<const std::byte> bytes) override {
    link_.heard(bytes);
    receiver_.receive(bytes, now());
    pump_and_publish();
  }
  void on_writable() override { pump_and_publish(); }
  void on_cts(bool) override {}
  void on_dsr(bool) override {}
  void on_lost(std::string_view reason) override {
    link_.was_lost(reason);
    receiver_.link(false, now());
    pump_and_publish();
  }

  void tick(feed::Time time) override {
    link_.tick(time);
    receiver_.tick(time);
    if (conclude_at_ && time >= *conclude_at_ && receiver_.conclude(time)) conclude_at_.reset();
    if (restart_at_ && time >= *restart_at_ && link_.is_up()) {
      restart_at_.reset();
      begin();
    }
    pump_and_publish();
  }

  [[nodiscard]] std::optional<feed::Time> deadline() const override {
    std::optional<feed::Time> due;
    for (const auto& one : {link_.deadline(), receiver_.deadline(), conclude_at_, restart_at_}) {
      if (one) due = due ? std::min(*due, *one) : *one;
    }
    return due;
  }

  // --- the text
  [[nodiscard]] std::size_t room() const noexcept override { return packet::kMaxPayload; }
  void append(std::span<const std::byte> bytes) noexcept override {
    raw_.insert(raw_.end(), bytes.begin(), bytes.end());
  }

  void pump_and_publish() {
    pump();
    while (const auto event = receiver_.next_event()) {
      if (event->kind == packet::ReceiveEventKind::frame) took_frame();
    }
    if (raw_.size() > judged_by_.max_bytes) static_cast<void>(receiver_.stop(now()));
    pump();
    if (receiver_.state() == packet::ReceiveState::done || receiver_.state() == packet::ReceiveState::failed) finish();
    publish();
  }

  // 3964 has no end of its own.
  void took_frame() {
    if (!packet::is_3964(protocol_)) return;
    const receive::Ending ending{.by = receive::EndedBy::link_lost, .bytes = raw_.size()};
    const bool may_close =
        std::ranges::any_of(std::span(raw_).last(std::min<std::size_t>(raw_.size(), 64)), [](std::byte b) {
          return (std::to_integer<unsigned>(b) & tape_code::kLowSevenBits) == '%' || b == std::byte{receive::kEiaStop};
        });
    const bool closed = may_close && receive::judge(raw_, ending, judged_by_).fault == receive::Fault::none;
    conclude_at_ = now() + (closed ? judged_by_.short_quiet : judged_by_.quiet);
  }

  void finish() {
    if (over_ || restart_at_) return;
    conclude_at_.reset();
    if (packet::is_xmodem(protocol_)) {
      while (!raw_.empty() && (std::to_integer<unsigned>(raw_.back()) & tape_code::kLowSevenBits) == kFilling)
        raw_.pop_back();
    }
    const packet::Cause cause = receiver_.end_cause();
    cause_ = cause == packet::Cause::none ? std::string_view() : packet::name(cause);
    if (raw_.empty()) {
      restart_at_ = now() + kRestartAfter;
      return;
    }
    over_ = true;
    receive::Ending ending{.by = ended_by(), .bytes = raw_.size(), .began_at = begun_at_, .at = now()};
    const std::lock_guard lock(report_mutex_);
    receptions_.push_back({.raw = std::exchange(raw_, {}), .ending = ending, .settings = judged_by_});
  }

  [[nodiscard]] receive::EndedBy ended_by() const {
    if (raw_.size() > judged_by_.max_bytes) return receive::EndedBy::too_long;
    if (receiver_.state() == packet::ReceiveState::done) return receive::EndedBy::end_code;
    return link_.is_up() ? receive::EndedBy::reset : receive::EndedBy::link_lost;
  }

  void pump() {
    while (link_.get() != nullptr && !receiver_.pending_out().empty()) {
      const std::size_t taken = link_.write(receiver_.pending_out());
      receiver_.mark_sent(taken, now());
      if (taken == 0) return;  // on_writable goes on
    }
  }

  [[nodiscard]] LineState state_now() const {
    if (!link_.is_up()) return LineState::disconnected;
    const bool quiet = over_ || receiver_.state() == packet::ReceiveState::inviting || restart_at_.has_value();
    return quiet ? LineState::idle : LineState::receiving;
  }

  void publish() {
    const std::lock_guard lock(report_mutex_);
    const LineState state = state_now();
    const std::uint64_t received = over_ ? 1 : 0;
    const bool changed = state != report_.state || received != report_.received;
    report_.state = state;
    report_.received = received;
    report_.cause = cause_;
    report_.stall = state == LineState::idle && !over_ ? "waiting for the sender" : "";
    link_.report(report_);
    if (!changed) return;
    ++report_.changes;
    changed_();
  }

  packet::Protocol protocol_;
  packet::Receiver receiver_;
  receive::Settings judged_by_;
  LinkThread& thread_;
  LineChanged changed_;
  KeptLink link_;
  std::vector<std::byte> raw_;
  std::string_view cause_;
  bool over_ = false;
  feed::Time begun_at_{};
  std::optional<feed::Time> conclude_at_;
  std::optional<feed::Time> restart_at_;
  mutable LineMutex report_mutex_{"a line's report"};
  LineReport report_;
  std::vector<Reception> receptions_;
};

}  // namespace

std::expected<std::unique_ptr<Line>, std::string> make_packet_receive_line(const machine::LineSettings& settings,
                                                                           LinkThread& thread, LineChanged changed) {
  const auto effective = machine::effective_line(settings);
  if (!effective) return std::unexpected(effective.error());
  const auto packet_settings = machine::packet_settings_of(*effective);
  if (!packet_settings) return std::unexpected(packet_settings.error());
  return std::make_unique<PacketReceiveLine>(*packet_settings, *effective, thread, std::move(changed));
}

}  // namespace dripfeed::app
