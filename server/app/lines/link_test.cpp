// One listener with a small state machine: open, round trips one after the other, then streams that are held one after
// the other. Everything happens on the links' thread; test_link() waits for the end.
#include "server/app/lines/link_test.h"

#include <algorithm>
#include <future>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "protocol/feed/line_clock.h"
#include "protocol/tape_code/parity.h"

namespace dripfeed::app {

namespace {

constexpr feed::Time kTick = std::chrono::milliseconds(1);
constexpr feed::Time kPause = std::chrono::milliseconds(5);    // between two round trips
constexpr feed::Time kAfter = std::chrono::milliseconds(100);  // silence that ends the count after a DC3
constexpr std::uint64_t kBeforeDc3 = 20;                       // characters of a stream until its DC3
constexpr std::uint64_t kLongestStream = 4096;                 // a host that does not hear its DC3 stops here
constexpr std::uint8_t kDc3 = 0x13;
constexpr std::uint8_t kProbe = 'U';  // 55h: every bit changes
// What shows that the line is bridged: no control takes one of them as a part of a program, in ISO or EIA.
constexpr std::array<std::uint8_t, 6> kProof = {0x00, 0x7F, 0x00, 0x00, 0x7F, 0x7F};

class Test final : private LinkListener, private Ticker {
 public:
  using Done = std::expected<LinkTestResult, LinkTestFault>;

  Test(const machine::LineSettings& line, const feed::Settings& settings, LinkThread& thread, const LinkTestPlan& plan)
      : line_(line),
        settings_(settings),
        thread_(thread),
        plan_(plan),
        char_time_(feed::Time(std::chrono::seconds(1)) * settings.framing.bits_per_char() / settings.baud),
        clock_(char_time_, settings.unsent, settings.latency_chars) {
    result_.char_time = char_time_;
  }

  Done run() {
    auto ended = done_.get_future();
    thread_.run([this] {
      thread_.add(*this);
      deadline_ = now() + plan_.patience;
      auto opened = thread_.open(line_, *this);
      if (!opened) return end(fault("not_open", opened.error()));
      link_ = std::move(*opened);
    });
    Done done = ended.get();
    thread_.run([this] {
      thread_.remove(*this);
      link_.reset();
    });
    return done;
  }

 private:
  enum class Step : std::uint8_t { opening, proving, pausing, round_trip, streaming, counting, over };

  static Done fault(std::string_view id, std::string text) {
    return std::unexpected(LinkTestFault{.id = id, .text = std::move(text)});
  }

  [[nodiscard]] feed::Time now() const { return thread_.clock().now(); }
  [[nodiscard]] std::byte wire(std::uint8_t character) const {
    return static_cast<std::byte>(tape_code::with_parity(character, settings_.wire.eighth_bit));
  }

  void on_up() override { pause(); }  // perhaps from inside open(): nothing is written here
  void on_writable() override {}
  void on_cts(bool) override {}
  void on_dsr(bool) override {}
  void on_lost(std::string_view reason) override { end(fault("lost", std::string(reason))); }

  void on_receive(std::span<const std::byte> bytes) override {
    const feed::Time at = now();
    for (const std::byte byte : bytes) take(byte, at);
  }

  void take(std::byte byte, feed::Time at) {
    if (step_ == Step::proving) return take_proof(byte);
    if (step_ == Step::round_trip) return end_round_trip(byte, at);
    if (step_ != Step::streaming && step_ != Step::counting) {
      ++result_.wrong;  // no one sent it
      return;
    }
    const std::uint64_t place = received_++;
    if (byte != character(place)) ++result_.wrong;
    heard_at_ = at;
    if (step_ == Step::counting) ++after_dc3_;
    if (place == kBeforeDc3 && step_ == Step::streaming) {
      step_ = Step::counting;  // from here on nothing is written: what still comes was below us
      after_dc3_ = 0;
    }
  }

  // --- is it bridged?
  // -------------------------------------------------------------------------------------------------------------
  void prove() {
    step_ = Step::proving;
    deadline_ = now() + plan_.patience;
    write(wire(kProof.at(proved_)));
  }

  void take_proof(std::byte byte) {
    if (byte != wire(kProof.at(proved_))) return end(other_came(byte));
    if (++proved_ < kProof.size()) return prove();
    pause();
  }

  // --- round trips
  // -----------------------------------------------------------------------------------------------------
  void pause() {
    step_ = Step::pausing;
    deadline_ = now() + kPause;
  }

  void begin_round_trip() {
    step_ = Step::round_trip;
    sent_at_ = now();
    deadline_ = sent_at_ + plan_.patience;
    write(wire(kProbe));
  }

  void end_round_trip(std::byte byte, feed::Time at) {
    if (byte != wire(kProbe)) ++result_.wrong;
    result_.latencies.push_back(std::max(feed::Time::zero(), at - sent_at_ - char_time_));
    if (result_.latencies.size() < plan_.round_trips) return pause();
    begin_stream();
  }

  // --- streams
  // ---------------------------------------------------------------------------------------------------------
  void begin_stream() {
    step_ = Step::streaming;
    clock_.restart();
    written_ = 0;
    received_ = 0;
    heard_at_ = now();
    deadline_ = now();
  }

  [[nodiscard]] std::byte character(std::uint64_t place) const {
    constexpr std::uint8_t kLetters = 26;
    return wire(place == kBeforeDc3 ? kDc3 : static_cast<std::uint8_t>('A' + place % kLetters));
  }

  void stream(feed::Time at) {
    deadline_ = at + kTick;
    if (at - heard_at_ > plan_.patience || written_ >= kLongestStream) return end(nothing_came());
    if (const auto unsent = link_->unsent()) clock_.queue_reported(*unsent, at);
    for (std::uint32_t credit = clock_.credit(at); credit > 0 && step_ == Step::streaming; --credit) {
      if (!look()) return;
      if (!write(character(written_))) return;
      ++written_;
      clock_.handed(1, at);
    }
  }

  // Reads before it writes, as a feed does. False: the DC3 is here.
  bool look() {
    std::array<std::byte, 64> buffer{};
    while (const std::size_t count = link_->read(buffer)) on_receive(std::span(buffer).first(count));
    return step_ == Step::streaming;
  }

  void count(feed::Time at) {
    deadline_ = at + kTick;
    if (received_ < written_ && at - heard_at_ > plan_.patience) return end(nothing_came());
    if (received_ < written_ || at - heard_at_ < kAfter) return;
    result_.after_dc3.push_back(after_dc3_);
    if (result_.after_dc3.size() < plan_.holds) return begin_stream();
    finish();
  }

  // --- the rest
  // --------------------------------------------------------------------------------------------------------
  bool write(std::byte byte) {
    const std::size_t taken = link_->write(std::span(&byte, 1));
    result_.characters += taken;
    return taken == 1;
  }

  [[nodiscard]] Done nothing_came() const {
    return fault("nothing_came", fmt::format("{} of {} characters came back: bridge the data wires at the other end of "
                                             "the line (2-3 on a 9-pin plug), and RTS with CTS where the flow is by "
                                             "lines",
                                             proved_ + result_.latencies.size() + received_, result_.characters));
  }
  [[nodiscard]] Done other_came(std::byte byte) const {
    return fault(
        "other_came",
        fmt::format("0x{:02X} was sent and 0x{:02X} came: a control may be at the other end, or the plug's side "
                    "has another speed or framing; only NUL and DEL were sent",
                    std::to_integer<int>(wire(kProof.at(proved_))), std::to_integer<int>(byte)));
  }

  void tick(feed::Time at) override {
    if (plan_.stop.stop_requested()) return end(fault("ended", "the server ends"));
    switch (step_) {
      case Step::opening: return end(fault("not_open", "the link does not come up"));
      case Step::proving: return end(nothing_came());
      case Step::pausing: return proved_ < kProof.size() ? prove() : begin_round_trip();
      case Step::round_trip: return end(nothing_came());
      case Step::streaming: return stream(at);
      case Step::counting: return count(at);
      case Step::over: return;
    }
  }
  [[nodiscard]] std::optional<feed::Time> deadline() const override {
    return step_ == Step::over ? std::nullopt : std::optional(deadline_);
  }

  void finish() {
    result_.errors = link_->errors();
    std::ranges::sort(result_.latencies);
    std::ranges::sort(result_.after_dc3);
    const auto chars = (result_.latencies.back() + char_time_ - feed::Time(1)) / char_time_;
    result_.latency_chars = static_cast<std::uint32_t>(chars);
    end(std::move(result_));
  }
  void end(Done done) {
    if (step_ == Step::over) return;
    step_ = Step::over;
    done_.set_value(std::move(done));
  }

  machine::LineSettings line_;
  feed::Settings settings_;
  LinkThread& thread_;
  LinkTestPlan plan_;
  feed::Time char_time_;
  feed::LineClock clock_;
  std::unique_ptr<Link> link_;
  Step step_ = Step::opening;
  std::size_t proved_ = 0;  // characters of kProof that came back
  feed::Time deadline_{};
  feed::Time sent_at_{};
  feed::Time heard_at_{};
  std::uint64_t written_ = 0;
  std::uint64_t received_ = 0;
  std::uint64_t after_dc3_ = 0;
  LinkTestResult result_;
  std::promise<Done> done_;
};

}  // namespace

bool keeps_budget(const LinkTestResult& result, const machine::LineSettings& line) {
  return result.wrong == 0 && result.after_dc3.back() <= line.overrun_budget;
}

std::expected<LinkTestResult, LinkTestFault> test_link(const machine::LineSettings& line, LinkThread& thread,
                                                       const LinkTestPlan& plan) {
  const auto fault = [](std::string_view id, std::string text) {
    return std::unexpected(LinkTestFault{.id = id, .text = std::move(text)});
  };
  if (!machine::feeds_characters(line.link.kind))
    return fault("no_characters", fmt::format("{} carries no single characters", line.link.text));
  const auto effective = machine::effective_line(line);
  if (!effective) return fault("settings", effective.error());
  const auto settings = machine::feed_settings_of(*effective);
  if (!settings) return fault("settings", settings.error());
  return Test(*effective, *settings, thread, plan).run();
}

}  // namespace dripfeed::app
