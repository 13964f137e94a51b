// Thousands of seeded runs of a feed against a modelled control: the overrun budget and the line use by accounting, and
// the text in spite of short writes, a ledger and inputs in any order.
#include <algorithm>
#include <array>
#include <memory>

#include <gtest/gtest.h>

#include "tests/wire/feed_player.h"
#include "tests/wire/line_cases.h"

namespace dripfeed::wire {
namespace {

using feed::State;

std::string decoded(const std::string& wire, const feed::Settings& settings) {
  tape_code::WireDecoder decoder({.eighth_bit = settings.wire.eighth_bit, .eia = settings.wire.eia});
  std::string text;
  decoder.decode(std::as_bytes(std::span(wire)), text);
  decoder.finish(text);
  EXPECT_EQ(decoder.parity_errors(), 0U);
  return text;
}

std::string to_final_percent(const std::string& text) { return text.substr(0, text.rfind('%') + 1); }

TEST(FeedScenarios, AfterDc3NeverMoreThanTheBudgetAndTheLineIsUsed) {
  for (const LineCase& with : kLines) {
    std::uint64_t holds = 0;
    std::uint64_t worst = 0;
    double worst_use = 1;
    for (unsigned seed = 1; seed <= 400; ++seed) {
      const LineModel model = model_of(with);
      std::mt19937 random(seed);
      const std::string text = random_program(random, 60);
      VirtualLine line(model, text, seed);
      line.run(600s);
      ASSERT_EQ(line.feed().state(), State::done) << with.name << " seed " << seed;
      // A hold that comes when the final '%' is out is taken for the end, and then its EOB stays away.
      ASSERT_EQ(to_final_percent(decoded(line.handed_bytes(), model.settings)), to_final_percent(text))
          << with.name << " seed " << seed;
      ASSERT_LE(line.worst_after_dc3, with.unsent + with.latency) << with.name << " seed " << seed;
      ASSERT_GE(line.line_use(), 0.97) << with.name << " seed " << seed;
      ASSERT_EQ(line.feed().counters().clocked, line.feed().counters().handed);
      ASSERT_EQ(line.feed().counters().confirmed, 0U);
      holds += line.holds;
      worst = std::max(worst, line.worst_after_dc3);
      worst_use = std::min(worst_use, line.line_use());
    }
    // The scenarios do hold, and the budget is used: a test that cannot come near it proves nothing.
    EXPECT_GT(holds, 1000U) << with.name;
    EXPECT_GE(worst * 10, 8 * (with.unsent + with.latency)) << with.name;
    RecordProperty(std::string("worst after DC3, ") + with.name, static_cast<int>(worst));
    RecordProperty(std::string("worst line use in permille, ") + with.name, static_cast<int>(worst_use * 1000));
  }
}

// The stream to the control is full of 13h (a '3') and its DC codes come without parity: neither is taken for the
// other.
TEST(FeedScenarios, EiaCodeIsFedWithinTheBudget) {
  std::uint64_t holds = 0;
  std::size_t looks_like_dc3 = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    LineModel model = model_of(kLines[1]);
    model.settings.wire.eia = tape_code::EiaSpecials{};
    model.settings.wire.leader_chars = seed % 30;
    model.settings.wire.trailer_chars = seed % 20;
    model.settings.wire.pad_tv = seed % 2 == 0;
    std::mt19937 random(seed);
    const std::string text = random_program(random, 60);
    VirtualLine line(model, text, seed);
    line.run(600s);
    ASSERT_EQ(line.feed().state(), State::done) << "seed " << seed;
    const std::string wire = line.handed_bytes();
    if (!model.settings.wire.pad_tv) {
      ASSERT_EQ(to_final_percent(decoded(wire, model.settings)), to_final_percent(text)) << "seed " << seed;
    }
    ASSERT_LE(line.worst_after_dc3, kLines[1].unsent + kLines[1].latency) << "seed " << seed;
    holds += line.holds;
    looks_like_dc3 += static_cast<std::size_t>(std::ranges::count(wire, '\x13'));
  }
  EXPECT_GT(holds, 500U);
  EXPECT_GT(looks_like_dc3, 1000U);
}

TEST(FeedScenarios, AClockThatIsOffByTwoPercentStaysInTheBudget) {
  for (const double rate : {0.98, 0.99, 1.01, 1.02}) {
    for (const bool blind : {true, false}) {
      for (unsigned seed = 1; seed <= 100; ++seed) {
        LineModel model = model_of(kLines[0]);
        model.true_rate = rate;
        model.settings.blind = blind;
        model.reports_queue = !blind;
        std::mt19937 random(seed);
        const std::string text = random_program(random, 150);
        VirtualLine line(model, text, seed);
        line.run(1200s);
        ASSERT_EQ(line.feed().state(), State::done) << rate << " seed " << seed;
        ASSERT_LE(line.worst_after_dc3, model.settings.overrun_budget)
            << rate << " blind " << blind << " seed " << seed;
        ASSERT_EQ(line.feed().counters().estimated, blind);
      }
    }
  }
}

TEST(FeedScenarios, ShortWritesAndALedgerChangeNothingInTheText) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    LineModel model = model_of(kLines[seed % kLines.size()]);
    model.settings.wire.eob = seed % 3 == 0 ? tape_code::Eob::lf_cr_cr : tape_code::Eob::cr_lf;
    model.settings.wire.leader_chars = seed % 7;
    model.settings.wire.trailer_chars = seed % 11;
    model.short_writes = true;
    std::mt19937 random(seed);
    const std::string text = random_program(random, 50);
    VirtualLine line(model, text, seed);
    line.ledger_window = 1 + random() % 300;
    std::uint64_t reserve = line.ledger_window;
    line.at_step = [&](VirtualLine& at) {
      ASSERT_LE(at.handed_count(), reserve);
      reserve = std::max(reserve, at.feed().counters().handed + at.ledger_window);
    };
    line.run(3600s);
    ASSERT_EQ(line.feed().state(), State::done) << "seed " << seed;
    ASSERT_TRUE(expected_wire(text, model.settings).starts_with(line.handed_bytes())) << "seed " << seed;
    ASSERT_EQ(to_final_percent(decoded(line.handed_bytes(), model.settings)), to_final_percent(text));
    ASSERT_LE(line.worst_after_dc3, model.settings.overrun_budget) << "seed " << seed;
  }
}

// Random inputs in random order, the driver taking what it likes.
class AnyOrder {
 public:
  explicit AnyOrder(unsigned seed) : random_(seed), model_(model_of(kLines[0])) {
    feed::Settings& settings = model_.settings;
    settings.watch_cts = settings.watch_dsr = seed % 2 == 0;
    settings.start = seed % 3 == 0 ? feed::Start::at_once : feed::Start::on_dc1;
    settings.end = {.dc3 = seed % 5 != 0, .eot = 0x04, .quiet = 1s};
    text_ = random_program(random_, 4);
    wire_ = expected_wire(text_, settings);
    feed_.emplace(feed::Feed::make(settings).value());
  }

  void step() {
    now_ += Time(static_cast<std::int64_t>(random_() % 4'000'000));
    switch (random_() % 12) {
      case 0: return arm();
      case 1:
        reserve_ = std::max<std::uint64_t>(reserve_, random_() % (wire_.size() + 20));
        return feed_->extend_reserve(reserve_, now_);
      case 2:
        if (random_() % 4 == 0) static_cast<void>(feed_->command(static_cast<feed::Command>(random_() % 7), now_));
        return;
      case 3: return feed_->line(static_cast<feed::LineChange>(random_() % 3 == 0 ? random_() % 6 : 0), now_);
      case 4: return receive();
      case 5: return feed_->report_queue(random_() % 3, now_);
      default: return drive();
    }
  }

  // What was sent is the beginning of the program and within the reserve; the counters are in order.
  void check() const {
    const feed::Counters counters = feed_->counters();
    ASSERT_GE(counters.handed, counters.clocked);
    ASSERT_LE(sent_.size(), reserve_);
    ASSERT_TRUE(wire_.starts_with(sent_));
  }
  std::size_t most_sent() const { return most_sent_; }

 private:
  void arm() {
    const std::uint64_t first = random_() % 20;
    auto source = std::make_unique<tape_code::SpanSource>(text_);
    if (!feed_->arm({.facts = facts_of(text_), .source = source.get(), .reserve = first}, now_)) return;
    source_ = std::move(source);
    sent_.clear();
    reserve_ = first;
  }

  void receive() {
    constexpr std::array<unsigned char, 10> kBytes{0x11, 0x11, 0x11, 0x11, 0x93, 0x13, 0x12, 0x14, 0x84, 0x16};
    const std::byte byte{kBytes[random_() % (random_() % 8 == 0 ? 10 : 8)]};
    feed_->receive({&byte, 1}, now_);
  }

  void drive() {
    feed_->tick(now_);
    const auto out = feed_->pending_out();
    ASSERT_LE(out.size(), model_.settings.unsent);
    const std::size_t count = out.empty() ? 0 : random_() % (out.size() + 1);
    for (std::size_t k = 0; k < count; ++k) sent_ += static_cast<char>(out[k]);
    feed_->mark_sent(count, now_);
    most_sent_ = std::max(most_sent_, sent_.size());
  }

  std::mt19937 random_;
  LineModel model_;
  std::string text_;
  std::string wire_;
  std::optional<feed::Feed> feed_;
  std::unique_ptr<tape_code::SpanSource> source_;
  std::string sent_;
  std::size_t most_sent_ = 0;
  std::uint64_t reserve_ = 0;
  Time now_ = 1s;
};

TEST(FeedScenarios, AnyInputInAnyOrderKeepsTheInvariants) {
  std::size_t sent = 0;
  for (unsigned seed = 1; seed <= 1500; ++seed) {
    AnyOrder run(seed);
    for (int i = 0; i < 400; ++i) {
      run.step();
      run.check();
      ASSERT_FALSE(testing::Test::HasFatalFailure()) << "seed " << seed;
    }
    sent += run.most_sent();
  }
  EXPECT_GT(sent, 20'000U);
}

}  // namespace
}  // namespace dripfeed::wire
