// 3964R with two partners that both send, in virtual time: one has priority, the other yields, receives first and
// then sends its own. Calls cross, bytes are lost, flipped, doubled and late; no telegram is lost without a name.
#include <deque>
#include <memory>
#include <optional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/wire/packet_player.h"

namespace dripfeed::wire {
namespace {

using namespace std::chrono_literals;
using packet::ReceiveState;
using packet::State;
using packet::Time;

constexpr Time kLatency = 5ms;
constexpr Time kLongest = 1h;

// Chances in a hundred thousand for each byte.
struct Faults {
  int lose = 0;
  int flip = 0;
  int twice = 0;
  int late = 0;
};

packet::Settings settings_of(bool yields_on_collision) {
  return {.protocol = packet::Protocol::s3964r,
          .answer_patience = 60s,
          .counted = yields_on_collision,
          .yields_on_collision = yields_on_collision};
}

bool is_over(State state) { return !packet::is_on_the_line(state) && state != State::armed; }

// Ours sends a program in numbered blocks; the partner takes them, and now and then has a telegram of its own.
class Partners {
 public:
  Partners(const Faults& faults, unsigned seed) : faults_(faults), random_(seed) {
    while (text_.size() < 600 + random_() % 600) text_ += "G1X" + std::to_string(random_() % 100'000) + "\n";
    text_ += "M30\n%\n";
  }

  void play() {
    ours_->link(true, now_);
    theirs_->link(true, now_);
    reader_->link(true, now_);
    tape_code::SpanSource source(text_);
    ASSERT_TRUE(ours_->arm({.facts = facts_of(text_), .source = &source, .reserve = feed::kNoReserve}, now_));
    ASSERT_TRUE(reader_->start(now_));
    for (const Time until = now_ + kLongest; !is_over(ours_->state()) || !is_over(theirs_->state());) {
      ASSERT_LT(now_, until) << name(ours_->state()) << ", " << name(theirs_->state());
      call_now_and_then();
      pump();
      now_ = next_time();
      arrive();
      ours_->tick(now_);
      theirs_->tick(now_);
      reader_->tick(now_);
      look();
    }
  }

  int given = 0;    // telegrams that the partner knows as delivered
  int came = 0;     // ... that we have, and that are as they were sent
  int spoiled = 0;  // ... and that are not
  int yielded = 0;  // times that we yielded
  int refused = 0;  // telegrams that the partner gave up, by name
  bool whole() const { return ours_->state() == State::done && sink_.text == text_; }
  bool wrong() const { return ours_->state() == State::done && sink_.text != text_; }

 private:
  struct Arrival {
    Time at;
    std::byte byte;
  };
  using Wire = std::deque<Arrival>;

  bool chance(int parts, unsigned of) { return static_cast<int>(random_() % of) < parts; }

  void put(Wire& wire, std::byte byte) {
    Time at = std::max(now_ + kLatency, wire.empty() ? Time() : wire.back().at);
    if (chance(faults_.late, 100'000)) at += 300ms;
    if (chance(faults_.lose, 100'000)) return;
    if (chance(faults_.flip, 100'000)) byte ^= static_cast<std::byte>(1U << random_() % 8);
    wire.push_back({at, byte});
    if (chance(faults_.twice, 100'000)) wire.push_back({at, byte});
  }

  template <class Side>
  void pump_side(Side& side, Wire& wire) {
    while (true) {
      const auto out = side.pending_out();
      if (out.empty()) return;
      for (const std::byte byte : out) put(wire, byte);
      side.mark_sent(out.size(), now_);
    }
  }
  void pump() {
    pump_side(*ours_, to_partner_);
    pump_side(*reader_, to_us_);
    pump_side(*theirs_, to_us_);
  }

  // A partner does not call while a block comes in or its answer goes out.
  void call_now_and_then() {
    const ReceiveState reading = reader_->state();
    const bool may = (reading == ReceiveState::inviting || reading == ReceiveState::waiting) &&
                     reader_->pending_out().empty() && is_over(theirs_->state()) && !is_over(ours_->state());
    if (!may || !chance(30, 100)) return;
    telegram_ = "%\nE" + std::to_string(random_() % 1000) + "\nM30\n%\n";
    telegram_source_ = std::make_unique<tape_code::SpanSource>(telegram_);
    const feed::Job job{.facts = facts_of(telegram_), .source = telegram_source_.get(), .reserve = feed::kNoReserve};
    if (theirs_->state() == State::torn) static_cast<void>(theirs_->command(feed::Command::confirm_reset, now_));
    ASSERT_TRUE(theirs_->arm(job, now_));
    calls_ = true;
  }

  void arrive() {
    for (; !to_us_.empty() && to_us_.front().at <= now_; to_us_.pop_front())
      ours_->receive(std::span(&to_us_.front().byte, 1), now_), look();
    for (; !to_partner_.empty() && to_partner_.front().at <= now_; to_partner_.pop_front()) {
      const auto byte = std::span(&to_partner_.front().byte, 1);
      is_over(theirs_->state()) ? reader_->receive(byte, now_) : theirs_->receive(byte, now_);
    }
  }

  void look() {
    while (const auto event = ours_->next_event()) {
      if (event->kind == packet::EventKind::state_changed && event->to == State::receiving) ++yielded;
      if (event->kind != packet::EventKind::telegram) continue;
      std::string have;
      for (const std::byte byte : ours_->telegram()) have += static_cast<char>(byte);
      ours_->take_telegram();
      have == telegram_ ? ++came : ++spoiled;
    }
    while (theirs_->next_event()) {
    }
    while (reader_->next_event()) {
    }
    if (!calls_ || !is_over(theirs_->state())) return;
    calls_ = false;
    theirs_->state() == State::done ? ++given : ++refused;
    EXPECT_TRUE(theirs_->state() == State::done || theirs_->end_cause() != packet::Cause::none);
  }

  Time next_time() const {
    Time next = now_ + 10s;
    const auto at = [&](std::optional<Time> instant) {
      if (instant && *instant > now_) next = std::min(next, *instant);
    };
    at(ours_->deadline());
    at(theirs_->deadline());
    at(reader_->deadline());
    if (!to_us_.empty()) at(to_us_.front().at);
    if (!to_partner_.empty()) at(to_partner_.front().at);
    return std::max(next, now_ + 1us);
  }

  Faults faults_;
  std::mt19937 random_;
  std::string text_ = "%\nO1\n";
  std::string telegram_;
  std::unique_ptr<tape_code::SpanSource> telegram_source_;
  RoomySink sink_;
  std::optional<packet::Sender> ours_ = std::move(packet::Sender::make(settings_of(true)).value());
  std::optional<packet::Sender> theirs_ = std::move(packet::Sender::make(settings_of(false)).value());
  std::optional<packet::Receiver> reader_ = std::move(packet::Receiver::make(settings_of(true), sink_).value());
  Wire to_us_;
  Wire to_partner_;
  Time now_{1'000'000'000};
  bool calls_ = false;
};

struct Sums {
  int whole = 0;
  int wrong = 0;
  int given = 0;
  int came = 0;
  int spoiled = 0;
  int yielded = 0;
  int refused = 0;
};

Sums play_all(const Faults& faults, unsigned seeds) {
  Sums sums;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    Partners run(faults, seed);
    run.play();
    EXPECT_GE(run.came + run.spoiled, run.given) << "a telegram that was acknowledged is not here: seed " << seed;
    if (testing::Test::HasFailure()) return sums;
    sums.whole += run.whole() ? 1 : 0;
    sums.wrong += run.wrong() ? 1 : 0;
    sums.given += run.given;
    sums.came += run.came;
    sums.spoiled += run.spoiled;
    sums.yielded += run.yielded;
    sums.refused += run.refused;
  }
  return sums;
}

TEST(S3964Partners, WhereBothCallBothTextsArrive) {
  const Sums sums = play_all({}, 200);
  EXPECT_EQ(sums.whole, 200);
  EXPECT_EQ(sums.spoiled, 0);
  EXPECT_EQ(sums.came, sums.given);
  EXPECT_EQ(sums.refused, 0);
  EXPECT_GT(sums.yielded, 200);
  EXPECT_GT(sums.came, 200);
}

// A single fault in a block never passes the exclusive or. Two may: of equal characters lost, of the same bit flipped.
TEST(S3964Partners, NothingIsLostOrWrongOnABadLine) {
  for (const Faults& faults : {Faults{.lose = 25}, Faults{.flip = 25}, Faults{.twice = 25}, Faults{.late = 100}}) {
    const Sums sums = play_all(faults, 250);
    EXPECT_EQ(sums.wrong, 0);
    EXPECT_EQ(sums.spoiled, 0);
    EXPECT_GT(sums.whole, 240);
    EXPECT_GT(sums.came, 200);
  }
}

}  // namespace
}  // namespace dripfeed::wire
