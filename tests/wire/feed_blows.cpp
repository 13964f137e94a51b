// Thousands of seeded runs in which one thing goes wrong, or is wished, at a random instant: what stops and cancels
// leave, that the interval of what is known is true, and that nothing goes out after it.
#include <array>
#include <map>
#include <memory>

#include <gtest/gtest.h>

#include "tests/wire/feed_player.h"
#include "tests/wire/line_cases.h"

namespace dripfeed::wire {
namespace {

using feed::State;

// Does the wire end with a whole block here?
bool ends_with_block(const std::string& wire, std::size_t count, const feed::Settings& settings) {
  if (count <= settings.wire.leader_chars) return true;
  const std::string eob(characters(settings.wire.eob));
  if (count < settings.wire.leader_chars + eob.size()) return false;
  for (std::size_t i = 0; i < eob.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(wire[count - eob.size() + i]);
    if ((byte & tape_code::kLowSevenBits) != static_cast<std::uint8_t>(eob[i])) return false;
  }
  return true;
}

// The bytes that the job may be at most torn at: an offset is whole if it is after the final '%' or ends a block.
bool is_whole(const std::string& wire, std::size_t count, const feed::Settings& settings) {
  const std::size_t final_percent =
      wire.rfind(static_cast<char>(tape_code::with_parity('%', settings.wire.eighth_bit)));
  return count > final_percent || ends_with_block(wire, count, settings);
}

// One thing that goes wrong, or is wished, at a random instant.
enum class Blow { link, syn, nak, noise, dsr, abort, cancel, stop, eot };
constexpr std::array kEobs{tape_code::Eob::lf, tape_code::Eob::cr_lf, tape_code::Eob::lf_cr_cr, tape_code::Eob::cr};
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
    model.settings.blind = seed % 3 == 0;
    model.settings.wire.eob = kEobs[seed % kEobs.size()];
    model.settings.wire.leader_chars = seed % 5;
    model.settings.wire.trailer_chars = seed % 6;
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
      // A device server that goes with the link takes what it held, up to its whole buffer.
      const bool loses = model.settings.blind && blow == Blow::link;
      const auto held_chars = static_cast<std::int64_t>(loses ? at.random()() % (feed::kBlindHold + 1) : 0);
      arrived_then = at.arrived_count(at.now() - at.feed().paced_char_time() * held_chars);
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

TEST(FeedBlows, AfterABlowNothingGoesOutAndTheIntervalIsTrue) {
  std::map<State, int> ends;
  for (unsigned seed = 1; seed <= 4000; ++seed) {
    BlowRun run(seed);
    feed::Feed& feed = run.line->feed();
    const State end = feed.state();
    ++ends[end];
    ASSERT_TRUE(run.wire.starts_with(run.line->handed_bytes())) << run.where;
    if (end == State::torn || end == State::failed) run.expect_a_true_interval(end);
    const bool stops = end == State::stopped || end == State::stopped_held || end == State::reset_suspected;
    if (end == State::cancelled || stops) run.expect_a_block_end();
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
  // The modelled control asks again when it starves, which a stop cannot distinguish from a reset.
  EXPECT_GT(ends[State::stopped] + ends[State::stopped_held] + ends[State::reset_suspected], 100);
  EXPECT_GT(ends[State::done], 20);
}

}  // namespace
}  // namespace dripfeed::wire
