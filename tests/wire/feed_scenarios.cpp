// Thousands of seeded runs of a feed against a modelled control: the overrun budget and the line use by accounting,
// what stops and cancels leave behind, and that nothing goes out after a torn block.
#include <algorithm>
#include <array>
#include <map>
#include <memory>

#include <gtest/gtest.h>

#include "protocol/tape_code/tape_code.h"
#include "tests/wire/feed_player.h"
#include "tests/wire/virtual_line.h"

namespace dripfeed::wire {
namespace {

using feed::State;
using namespace std::chrono_literals;

struct LineCase {
  const char* name;
  const char* framing;
  std::uint32_t baud;
  std::uint32_t budget;
  std::uint32_t unsent;
  std::uint32_t latency;
  Time out_delay;
  Time in_delay;
  Time wake_delay;
};

// The latency holds DC3's own character time and both delays.
constexpr std::array<LineCase, 4> kLines{{
    {"9600 7E2, 16550", "7E2", 9600, 10, 4, 5, 0us, 4500us, 1000us},
    {"19200 8N1, USB", "8N1", 19200, 10, 4, 6, 600us, 1900us, 1000us},
    {"115200 8N1, large budget", "8N1", 115200, 64, 40, 24, 400us, 1500us, 1000us},
    {"4800 7E2, slow", "7E2", 4800, 10, 4, 3, 0us, 4000us, 1000us},
}};

LineModel model_of(const LineCase& with) {
  LineModel model;
  feed::Settings& settings = model.settings;
  settings.framing = tape_code::parse_framing(with.framing).value();
  settings.baud = with.baud;
  settings.wire.eighth_bit = eighth_bit(settings.framing, tape_code::Code::ascii, tape_code::ParityBy::software);
  settings.overrun_budget = with.budget;
  settings.unsent = with.unsent;
  settings.latency_chars = with.latency;
  model.max_out_delay = with.out_delay;
  model.max_in_delay = with.in_delay;
  model.max_wake_delay = with.wake_delay;
  return model;
}

std::string decoded(const std::string& wire, const feed::Settings& settings) {
  tape_code::WireDecoder decoder(settings.wire.eighth_bit);
  std::string text;
  decoder.decode(std::as_bytes(std::span(wire)), text);
  decoder.finish(text);
  EXPECT_EQ(decoder.parity_errors(), 0U);
  return text;
}

std::string to_final_percent(const std::string& text) { return text.substr(0, text.rfind('%') + 1); }

// The whole wire, made without the encoder.
std::string expected_wire(const std::string& text, const feed::Settings& settings) {
  std::string wire(settings.wire.leader_nuls, '\0');
  for (const char c : text) {
    const std::string one = c == '\n' ? std::string(characters(settings.wire.eob)) : std::string(1, c);
    for (const char out : one) {
      wire += static_cast<char>(tape_code::with_parity(static_cast<std::uint8_t>(out), settings.wire.eighth_bit));
    }
  }
  return wire + std::string(settings.wire.trailer_nuls, '\0');
}

// Does the wire end with a whole block here?
bool ends_with_block(const std::string& wire, std::size_t count, const feed::Settings& settings) {
  if (count <= settings.wire.leader_nuls) return true;
  const std::string eob(characters(settings.wire.eob));
  if (count < settings.wire.leader_nuls + eob.size()) return false;
  for (std::size_t i = 0; i < eob.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(wire[count - eob.size() + i]);
    if ((byte & tape_code::kLowSevenBits) != static_cast<std::uint8_t>(eob[i])) return false;
  }
  return true;
}

// The bytes that the job may be at most torn at: an offset is whole if it is behind the final '%' or ends a block.
bool is_whole(const std::string& wire, std::size_t count, const feed::Settings& settings) {
  const std::size_t final_percent =
      wire.rfind(static_cast<char>(tape_code::with_parity('%', settings.wire.eighth_bit)));
  return count > final_percent || ends_with_block(wire, count, settings);
}

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
    model.settings.wire.leader_nuls = seed % 7;
    model.settings.wire.trailer_nuls = seed % 11;
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

// One thing that goes wrong, or is wished, at a random instant.
enum class Blow { link, syn, nak, noise, dsr, abort, cancel, stop, eot };
constexpr std::array<Blow, 9> kBlows{Blow::link,  Blow::syn,    Blow::nak,  Blow::noise, Blow::dsr,
                                     Blow::abort, Blow::cancel, Blow::stop, Blow::eot};

void strike(feed::Feed& feed, Blow blow, Time now) {
  const auto in = [&](unsigned char byte) {
    const std::byte one{byte};
    feed.receive({&one, 1}, now);
  };
  switch (blow) {
    case Blow::link: feed.line(feed::LineChange::link_down, now); break;
    case Blow::syn: in(0x16); break;
    case Blow::nak: in(0x95); break;
    case Blow::noise: in(0xE1); break;
    case Blow::dsr: feed.line(feed::LineChange::dsr_off, now); break;
    case Blow::abort: static_cast<void>(feed.command(feed::Command::abort, now)); break;
    case Blow::cancel: static_cast<void>(feed.command(feed::Command::cancel, now)); break;
    case Blow::stop: static_cast<void>(feed.command(feed::Command::stop, now)); break;
    case Blow::eot: in(0x84); break;
  }
}

// Hours of everything that could tempt a feed to send, but a person's word.
void tempt(feed::Feed& feed, std::mt19937& random, Time now, const std::string& where) {
  for (int i = 0; i < 200; ++i) {
    now += Time(static_cast<std::int64_t>(random() % 200'000'000'000ULL));
    const std::byte byte{static_cast<unsigned char>(random() % 3 == 0 ? random() % 256 : 0x11)};
    switch (random() % 8) {
      case 0: feed.line(feed::LineChange::link_up, now); break;
      case 1: feed.line(feed::LineChange::cts_on, now); break;
      case 2: feed.line(feed::LineChange::dsr_on, now); break;
      case 3: feed.extend_reserve(UINT64_MAX, now); break;
      case 4: feed.report_queue(0, now); break;
      case 5: feed.tick(now); break;
      default: feed.receive({&byte, 1}, now); break;
    }
    ASSERT_TRUE(feed.pending_out().empty()) << where;
  }
}

// One run with one blow, and what must hold at its end.
struct BlowRun {
  explicit BlowRun(unsigned seed)
      : where("seed " + std::to_string(seed)), model(model_of(kLines[seed % kLines.size()])) {
    model.settings.watch_dsr = true;
    model.settings.end.eot = 0x04;
    model.settings.wire.eob = static_cast<tape_code::Eob>(seed % 4);
    model.settings.wire.leader_nuls = seed % 5;
    model.settings.wire.trailer_nuls = seed % 6;
    std::mt19937 random(seed);
    text = random_program(random, 20);
    wire = expected_wire(text, model.settings);
    blow = kBlows[random() % kBlows.size()];
    const std::size_t strike_after = random() % (wire.size() + 10);
    const bool patient = seed % 2 == 0;  // waits until a hold has let the line run empty
    const bool between = seed % 4 == 0;  // ... at the end of a block
    line = std::make_unique<VirtualLine>(model, text, seed);
    line->at_step = [=, this](VirtualLine& at) {
      if (struck_at || at.handed_count() < strike_after) return;
      if (patient && at.now() - at.last_handed_at() < 30ms) return;
      if (between && !whole_at(at.handed_count())) return;
      struck_at = at.handed_count();
      arrived_then = at.arrived_count();
      strike(at.feed(), blow, at.now());
    };
    line->run(300s);
  }

  bool whole_at(std::size_t count) const { return is_whole(wire, count, model.settings); }

  // Of what was handed, only the part that had arrived is certain, and all that was handed may arrive.
  void expect_a_true_interval(State end) {
    const feed::Interval interval = line->feed().interval();
    ASSERT_TRUE(struck_at) << where;
    EXPECT_EQ(line->handed_count(), *struck_at) << where;
    EXPECT_LE(interval.from, arrived_then) << where;
    EXPECT_EQ(interval.to, *struck_at) << where;
    bool whole = true;
    for (std::size_t at = arrived_then; at <= *struck_at; ++at) whole = whole && whole_at(at);
    if (!whole) {
      EXPECT_EQ(end, State::torn) << where;
    }
    ASSERT_TRUE(interval.to_position) << where;
    EXPECT_EQ(interval.to_position->wire_offset, *struck_at) << where;
  }

  // The block that was begun was sent whole, and not one more.
  void expect_a_block_end() {
    std::size_t block_end = struck_at.value();
    while (!whole_at(block_end)) ++block_end;
    EXPECT_EQ(line->handed_count(), block_end) << where;
    EXPECT_EQ(line->feed().counters().clocked, line->handed_count()) << where;
    EXPECT_EQ(line->arrived_count(), line->handed_count()) << where;
  }

  // A program that is done in spite of a stop or cancel was out already (or only armed, where stop is refused).
  void expect_too_late() {
    if (struck_at.value_or(0) == 0 || (blow != Blow::cancel && blow != Blow::stop)) return;
    const char percent = static_cast<char>(tape_code::with_parity('%', model.settings.wire.eighth_bit));
    EXPECT_GT(*struck_at, wire.rfind(percent)) << where;
  }

  std::string where;
  LineModel model;
  std::string text;
  std::string wire;
  Blow blow = Blow::link;
  std::optional<std::size_t> struck_at;
  std::size_t arrived_then = 0;
  std::unique_ptr<VirtualLine> line;
};

TEST(FeedScenarios, AfterABlowNothingGoesOutAndTheIntervalIsTrue) {
  std::map<State, int> ends;
  for (unsigned seed = 1; seed <= 3000; ++seed) {
    BlowRun run(seed);
    feed::Feed& feed = run.line->feed();
    const State end = feed.state();
    ++ends[end];
    ASSERT_TRUE(run.wire.starts_with(run.line->handed_bytes())) << run.where;
    if (end == State::torn || end == State::failed) run.expect_a_true_interval(end);
    if (end == State::cancelled || end == State::stopped || end == State::stopped_held) run.expect_a_block_end();
    if (end == State::done) {
      run.expect_too_late();
      continue;
    }
    std::mt19937 random(seed);
    tempt(feed, random, run.line->now(), run.where);
    if (end != State::torn) continue;
    EXPECT_EQ(feed.state(), State::torn) << run.where;
    tape_code::SpanSource source(run.text);
    EXPECT_FALSE(feed.arm({.facts = facts_of(run.text), .source = &source}, run.line->now() + 10000h)) << run.where;
  }
  EXPECT_GT(ends[State::torn], 500);
  EXPECT_GT(ends[State::failed], 15);
  EXPECT_GT(ends[State::cancelled], 100);
  EXPECT_GT(ends[State::stopped] + ends[State::stopped_held], 100);
  EXPECT_GT(ends[State::done], 20);
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
