// A feed against the simulated control in virtual time, with one fault a run: plain DC codes, the same with the resets
// and alarms of a remote buffer (protocol B), and RTS/CTS. Whatever breaks, the feed ends with a cause, what can be
// noticed is noticed, and no block is completed that was broken off.
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "server/simulator/fault.h"
#include "server/simulator/simulated_control.h"
#include "tests/wire/feed_player.h"
#include "tests/wire/line_cases.h"

namespace dripfeed::wire {
namespace {

using feed::State;
using simulator::ControlState;
using simulator::FaultKind;

enum class Kind { plain, protocol_b, rtscts };

constexpr std::array kPlainFaults = {FaultKind::cut,    FaultKind::half_open, FaultKind::lose,  FaultKind::lose_out,
                                     FaultKind::flip,   FaultKind::parity,    FaultKind::noise, FaultKind::late_xoff,
                                     FaultKind::silent, FaultKind::overrun,   FaultKind::slow,  FaultKind::baud,
                                     FaultKind::dsr};
constexpr std::array kProtocolBFaults = {FaultKind::reset, FaultKind::alarm, FaultKind::cut, FaultKind::parity,
                                         FaultKind::lose_out};
constexpr std::array kLineFaults = {FaultKind::cut,     FaultKind::half_open, FaultKind::lose, FaultKind::flip,
                                    FaultKind::overrun, FaultKind::slow,      FaultKind::dsr};

std::string moving_program(std::mt19937& random) {
  std::string text = "%\nO1\nG21\n";
  const auto blocks = 10 + random() % 60;
  for (unsigned i = 0; i < blocks; ++i) {
    text += "G1X" + std::to_string(random() % 200) + ".5Z" + std::to_string(random() % 90) + ".F3000\n";
  }
  return text + "M30\n%\n";
}

FaultKind choose(Kind kind, std::mt19937& random) {
  if (kind == Kind::plain) return kPlainFaults[random() % kPlainFaults.size()];
  if (kind == Kind::protocol_b) return kProtocolBFaults[random() % kProtocolBFaults.size()];
  return kLineFaults[random() % kLineFaults.size()];
}

std::uint64_t number_for(FaultKind fault, std::size_t characters, std::mt19937& random) {
  switch (fault) {
    case FaultKind::noise: return 200 + random() % 5000;
    case FaultKind::late_xoff: return random() % 30;
    case FaultKind::slow: return 2 + random() % 30;
    case FaultKind::baud: return 4800;
    case FaultKind::lose_out: return 1 + random() % 6;
    default: return 1 + random() % characters;
  }
}

class FaultRun {
 public:
  FaultRun(Kind kind, unsigned seed)
      : where("kind " + std::to_string(static_cast<int>(kind)) + " seed " + std::to_string(seed)),
        random_(seed),
        kind_(kind) {
    model_ = model_of(kLines[0]);
    model_.settings.watch_dsr = true;
    model_.settings.end = {.dc3 = true};
    if (kind == Kind::rtscts) model_ = by_lines(model_);
    text_ = moving_program(random_);
    wire_ = expected_wire(text_, model_.settings);
    fault_.kind = choose(kind, random_);
    fault_.number = number_for(fault_.kind, wire_.size(), random_);
    source_ = std::make_unique<tape_code::SpanSource>(text_);
    feed_.emplace(feed::Feed::make(model_.settings).value());
    control_ = std::make_unique<simulator::SimulatedControl>(control_settings(), [](std::uint8_t) {});
    line_ = std::make_unique<simulator::LineFaults>(simulator::Faults{fault_}, seed);
  }

  void run() {
    feed_->line(feed::LineChange::link_up, now());
    const feed::Job job{.facts = facts_of(text_), .source = source_.get(), .reserve = feed::kNoReserve};
    ASSERT_TRUE(feed_->arm(job, now())) << where;
    control_->start(at_);
    const std::int64_t until = at_ + 360'000'000'000'000;
    while (at_ < until && !over()) {
      step();
      const auto next = next_instant();
      if (!next) break;
      at_ = std::max(*next, at_ + 1);
    }
  }

  [[nodiscard]] bool over() const { return feed_->counters().ended_at > Time::zero(); }

  // What was sent is the beginning of the expected wire, and nothing follows a break.
  void expect_nothing_made_up() const {
    ASSERT_TRUE(wire_.starts_with(sent_)) << where;
    if (feed_->state() == State::torn || feed_->state() == State::failed) {
      EXPECT_NE(feed_->end_cause(), feed::Cause::none) << where;
      EXPECT_TRUE(feed_->pending_out().empty()) << where;
    }
  }

  // A feed that is not over states why it waits.
  void expect_a_name() const {
    if (!over()) {
      EXPECT_NE(feed_->stall(), feed::Stall::none) << where << " " << feed::name(feed_->state());
    }
  }

  // A control that never saw the end, with a link that has an end sign of its own: then the feed is not done.
  void expect_what_can_be_noticed() const {
    const auto report = control_->report();
    const bool whole = sent_.size() >= wire_.rfind(percent()) + 1;
    if (feed_->state() == State::done) {
      EXPECT_TRUE(whole) << where;
    }
    const bool ended = report.state == ControlState::ended;
    if (kind_ != Kind::rtscts && !ended && !whole) {
      EXPECT_NE(feed_->state(), State::done) << where;
    }
    const bool strikes_before_the_end = fault_.number + 2 < wire_.rfind(percent()) && fault_.number < sent_.size();
    const bool garbles = fault_.kind == FaultKind::flip || fault_.kind == FaultKind::parity;
    if (garbles && strikes_before_the_end) {
      EXPECT_EQ(report.alarm, "001 TH PARITY") << where;
    }
    constexpr std::array kBreaks = {FaultKind::cut, FaultKind::reset, FaultKind::alarm};
    if (std::ranges::find(kBreaks, fault_.kind) != kBreaks.end() && strikes_before_the_end) {
      const bool named = feed_->state() == State::torn || feed_->state() == State::failed;
      EXPECT_TRUE(named) << where << " " << feed::name(feed_->state());
    }
    if (fault_.kind == FaultKind::dsr && strikes_before_the_end) {
      EXPECT_EQ(feed_->end_cause(), feed::Cause::dsr_off) << where;
    }
    if (report.unfinished_block) {
      EXPECT_FALSE(ended) << where;
    }
  }

  [[nodiscard]] State state() const { return feed_->state(); }
  [[nodiscard]] bool is_shut_in_the_end() const {
    const bool after_the_end = feed_->state() == State::trailer || feed_->state() == State::draining;
    return after_the_end && feed_->stall() == feed::Stall::cts_off && kind_ == Kind::rtscts;
  }
  [[nodiscard]] FaultKind fault() const { return fault_.kind; }
  [[nodiscard]] simulator::ControlReport report() const { return control_->report(); }
  std::string where;

 private:
  [[nodiscard]] Time now() const { return Time(at_); }
  [[nodiscard]] char percent() const {
    return static_cast<char>(tape_code::with_parity('%', model_.settings.wire.eighth_bit));
  }

  simulator::ControlSettings control_settings() {
    simulator::ControlSettings settings;
    settings.framing = model_.settings.framing;
    settings.baud = model_.settings.baud;
    settings.buffer_bytes = 300;
    settings.stop_free_bytes = 80;
    settings.go_free_bytes = 200;
    settings.speed = static_cast<double>(1 + random_() % 20);
    settings.uses_dc = kind_ != Kind::rtscts;
    settings.drives_rts = kind_ == Kind::rtscts;
    settings.faults = {fault_};
    return settings;
  }

  void step() {
    control_->tick(at_);
    std::vector<std::byte> out = control_->take_out(at_);
    line_->to_host(out);
    if (!deaf_ && !out.empty()) feed_->receive(out, now());
    show_lines();
    feed_->tick(now());
    while (!feed_->pending_out().empty()) {
      const auto bytes = feed_->pending_out();
      std::vector<std::byte> taken(bytes.begin(), bytes.end());
      for (const std::byte byte : taken) sent_ += static_cast<char>(byte);
      feed_->mark_sent(taken.size(), now());
      deliver(taken);
    }
  }

  void deliver(std::vector<std::byte>& bytes) {
    const bool ends_link = fault_.kind == FaultKind::cut || fault_.kind == FaultKind::half_open;
    if (deaf_) return;
    line_->to_control(bytes);
    control_->receive(bytes, at_, at_);
    if (!ends_link || sent_.size() < fault_.number) return;
    deaf_ = true;
    if (fault_.kind == FaultKind::cut) feed_->line(feed::LineChange::link_down, now());
  }

  void show_lines() {
    if (deaf_) return;
    const simulator::ControlLines lines = control_->lines();
    if (lines.cts != shown_.cts) feed_->line(lines.cts ? feed::LineChange::cts_on : feed::LineChange::cts_off, now());
    if (lines.dsr != shown_.dsr) feed_->line(lines.dsr ? feed::LineChange::dsr_on : feed::LineChange::dsr_off, now());
    shown_ = lines;
  }

  [[nodiscard]] std::optional<std::int64_t> next_instant() const {
    std::optional<std::int64_t> next = control_->deadline();
    if (const auto deadline = feed_->deadline()) next = std::min(next.value_or(deadline->count()), deadline->count());
    return next;
  }

  std::mt19937 random_;
  Kind kind_;
  LineModel model_;
  simulator::Fault fault_;
  std::string text_;
  std::string wire_;
  std::string sent_;
  std::unique_ptr<tape_code::SpanSource> source_;
  std::optional<feed::Feed> feed_;
  std::unique_ptr<simulator::SimulatedControl> control_;
  std::unique_ptr<simulator::LineFaults> line_;
  simulator::ControlLines shown_;
  std::int64_t at_ = 1'000'000'000;
  bool deaf_ = false;
};

class FeedFaults : public testing::TestWithParam<Kind> {};

TEST_P(FeedFaults, AThousandOfThemEndInANamedState) {
  std::map<State, int> ends;
  std::map<FaultKind, int> faults;
  std::map<std::string, int> alarms;
  for (unsigned seed = 1; seed <= 1200; ++seed) {
    FaultRun run(GetParam(), seed);
    run.run();
    run.expect_nothing_made_up();
    run.expect_a_name();
    run.expect_what_can_be_noticed();
    ASSERT_FALSE(HasFailure()) << run.where << ", fault " << simulator::name_of(run.fault());
    ++ends[run.state()];
    ++faults[run.fault()];
    ++alarms[run.report().alarm];
  }
  for (const auto& [fault, count] : faults) EXPECT_GT(count, 30) << simulator::name_of(fault);
  EXPECT_GT(ends[State::torn], 100);
  EXPECT_GT(ends[State::done], 20);
  EXPECT_GT(alarms.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(EachLine, FeedFaults, testing::Values(Kind::plain, Kind::protocol_b, Kind::rtscts));

// Without a fault the same runs end well: otherwise the ones above prove nothing.
TEST(FeedFaultsControl, ASlowButSoundControlGetsEverything) {
  for (const Kind kind : {Kind::plain, Kind::rtscts}) {
    int sound = 0;
    for (unsigned seed = 1; seed <= 400; ++seed) {
      FaultRun run(kind, seed);
      if (run.fault() != FaultKind::slow) continue;
      run.run();
      ++sound;
      // A control that drops its RTS with the last character is not distinguished from one that holds before it: the
      // stall has its name, and a person ends it.
      EXPECT_TRUE(run.state() == State::done || run.is_shut_in_the_end()) << run.where;
      EXPECT_EQ(run.report().state, ControlState::ended) << run.where;
      EXPECT_EQ(run.report().alarm, "") << run.where;
      EXPECT_FALSE(run.report().unfinished_block) << run.where;
    }
    EXPECT_GT(sound, 10);
  }
}

}  // namespace
}  // namespace dripfeed::wire
