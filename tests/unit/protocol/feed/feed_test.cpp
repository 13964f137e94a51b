// What no dialog shows: limits of buffers, allocation, long texts, the driver's view.
#include "protocol/feed/feed.h"

#include <cstdlib>
#include <new>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace {

std::size_t allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace dripfeed::feed {
namespace {

using namespace std::chrono_literals;

// The same block over and over, in pieces of 4096, from memory that does not grow with the text.
class EndlessSource final : public tape_code::TextSource {
 public:
  explicit EndlessSource(std::uint64_t blocks) : blocks_(blocks) {}
  tape_code::TextPiece next() noexcept override {
    if (!begun_) {
      begun_ = true;
      return {.status = tape_code::SourceStatus::text, .text = std::span("%\n", 2)};
    }
    if (blocks_ > 0) {
      --blocks_;
      return {.status = tape_code::SourceStatus::text, .text = std::span("G1X12.345Y1.2\n", 14)};
    }
    if (ended_) return {.status = tape_code::SourceStatus::end};
    ended_ = true;
    return {.status = tape_code::SourceStatus::text, .text = std::span("M30\n%\n", 6)};
  }

 private:
  std::uint64_t blocks_;
  bool begun_ = false;
  bool ended_ = false;
};

ProgramFacts facts_of(std::uint64_t blocks) {
  EndlessSource source(blocks);
  ProgramCheck check(kParenthesesSyntax);
  for (auto piece = source.next(); piece.status == tape_code::SourceStatus::text; piece = source.next()) {
    check.append(piece.text);
  }
  return check.finish().value();
}

void send(Feed& feed, unsigned char byte, Time now) {
  const std::byte one{byte};
  feed.receive({&one, 1}, now);
}

std::uint64_t run(Feed& feed, Time& now) {
  std::uint64_t sent = 0;
  while (feed.state() != State::wait_end) {
    const auto out = feed.pending_out();
    if (out.empty()) {
      const auto next = feed.deadline();
      if (!next) break;
      now = *next;
      feed.tick(now);
      continue;
    }
    sent += out.size();
    feed.mark_sent(out.size(), now);
    while (feed.next_event()) {
    }
  }
  return sent;
}

std::size_t allocations_for(std::uint64_t blocks) {
  const ProgramFacts facts = facts_of(blocks);
  EndlessSource source(blocks);
  Feed feed = Feed::make(Settings{}).value();
  Time now = 1s;
  feed.line(LineChange::link_up, now);
  const std::size_t before = allocations;
  EXPECT_TRUE(feed.arm({.facts = facts, .source = &source, .reserve = kNoReserve}, now));
  send(feed, 0x11, now);
  EXPECT_EQ(run(feed, now), facts.text_bytes());
  EXPECT_EQ(feed.state(), State::wait_end);
  return allocations - before;
}

TEST(Feed, AllocatesNothingHoweverLongTheText) {
  EXPECT_EQ(allocations_for(10), 0U);
  EXPECT_EQ(allocations_for(100'000), 0U);
}

TEST(Feed, EventsThatNoOneReadsAreDroppedAndCounted) {
  Feed feed = Feed::make(Settings{}).value();
  feed.line(LineChange::link_up, 1s);
  for (int i = 0; i < 1000; ++i) send(feed, 0x12, 1s);
  std::size_t count = 0;
  while (feed.next_event()) ++count;
  EXPECT_EQ(count, Feed::kMaxEvents);
  EXPECT_EQ(feed.events_dropped(), 1000 + 2 - Feed::kMaxEvents);  // link and stall came first
}

TEST(Feed, RefusesSettingsAndJobsByName) {
  Settings settings;
  settings.latency_chars = 20;
  const auto refused = Feed::make(settings);
  ASSERT_FALSE(refused);
  EXPECT_NE(message(refused.error()).find("4 unsent + 20 latency = 24"), std::string::npos);
  Feed feed = Feed::make(Settings{}).value();
  const ProgramFacts facts = facts_of(1);
  EndlessSource source(1);
  EXPECT_EQ(feed.arm({.facts = facts, .source = &source}, 1s).error(), Refusal::link_is_down);
  feed.line(LineChange::link_up, 1s);
  EXPECT_EQ(feed.arm({.facts = facts}, 1s).error(), Refusal::no_source);
  EXPECT_TRUE(feed.arm({.facts = facts, .source = &source}, 1s));
  EXPECT_EQ(feed.arm({.facts = facts, .source = &source}, 1s).error(), Refusal::not_in_this_state);
  for (const Refusal refusal : {Refusal::not_in_this_state, Refusal::link_is_down, Refusal::no_source}) {
    EXPECT_FALSE(message(refusal).empty());
  }
}

TEST(Feed, ARefusedArmingLeavesTheRunningJobAlone) {
  Feed feed = Feed::make(Settings{}).value();
  const ProgramFacts facts = facts_of(3);
  EndlessSource source(3);
  EndlessSource other(3);
  Time now = 1s;
  feed.line(LineChange::link_up, now);
  ASSERT_TRUE(feed.arm({.facts = facts, .source = &source, .reserve = kNoReserve}, now));
  send(feed, 0x11, now);
  EXPECT_FALSE(feed.arm({.facts = facts, .source = &other, .reserve = 1}, now));
  EXPECT_EQ(run(feed, now), facts.text_bytes());
}

// Whoever fed the line before broke off inside a block: nothing that a control may say, and no time, makes a byte go
// out.
TEST(Feed, ALineThatWasLeftTornSendsNothingBeforeAPersonConfirms) {
  Feed feed = Feed::make(Settings{}, LeftAs::torn).value();
  const ProgramFacts facts = facts_of(3);
  EndlessSource source(3);
  Time now = 1s;
  EXPECT_EQ(feed.state(), State::torn);
  feed.line(LineChange::link_up, now);
  EXPECT_EQ(feed.arm({.facts = facts, .source = &source, .reserve = kNoReserve}, now).error(),
            Refusal::not_in_this_state);
  for (const char byte : std::string_view("\x11\x13\x16\x15\x12G"))
    send(feed, static_cast<unsigned char>(byte), now += 1h);
  EXPECT_EQ(feed.state(), State::torn);
  EXPECT_TRUE(feed.pending_out().empty());
  ASSERT_TRUE(feed.command(Command::confirm_reset, now));
  ASSERT_TRUE(feed.arm({.facts = facts, .source = &source, .reserve = kNoReserve}, now));
  send(feed, 0x11, now);
  EXPECT_EQ(run(feed, now), facts.text_bytes());
}

TEST(Feed, AResumeAfterASuspectedResetSaysWhyItIsRefused) {
  Feed feed = Feed::make(Settings{}).value();
  const ProgramFacts facts = facts_of(300);
  EndlessSource source(300);
  Time now = 1s;
  feed.line(LineChange::link_up, now);
  ASSERT_TRUE(feed.arm({.facts = facts, .source = &source, .reserve = kNoReserve}, now));
  send(feed, 0x11, now);
  ASSERT_TRUE(feed.command(Command::stop, now));
  run(feed, now);
  ASSERT_EQ(feed.state(), State::stopped);
  send(feed, 0x11, now += 5s);
  EXPECT_EQ(feed.command(Command::resume, now).error(), Refusal::reset_suspected);
  EXPECT_EQ(feed.stall(), Stall::reset_suspected);
  EXPECT_TRUE(feed.command(Command::cancel, now));
}

TEST(Feed, ALateTimerOnlyCostsTime) {
  Feed feed = Feed::make(Settings{}).value();
  const ProgramFacts facts = facts_of(20);
  EndlessSource source(20);
  Time now = 1s;
  feed.line(LineChange::link_up, now);
  ASSERT_TRUE(feed.arm({.facts = facts, .source = &source, .reserve = kNoReserve}, now));
  send(feed, 0x11, now);
  std::uint64_t sent = 0;
  for (int i = 0; i < 1000 && sent < facts.text_bytes(); ++i) {
    const auto out = feed.pending_out();
    EXPECT_LE(out.size(), feed.settings().unsent);
    sent += out.size();
    feed.mark_sent(out.size(), now);
    now += 5s;
    feed.tick(now);
  }
  EXPECT_EQ(sent, facts.text_bytes());
}

TEST(Feed, TimeThatStepsBackIsNotBelieved) {
  Feed feed = Feed::make(Settings{}).value();
  const ProgramFacts facts = facts_of(1);
  EndlessSource source(1);
  feed.line(LineChange::link_up, 100s);
  ASSERT_TRUE(feed.arm({.facts = facts, .source = &source, .expires_after = 10s}, 100s));
  feed.tick(109s);
  feed.tick(1s);
  EXPECT_EQ(feed.state(), State::armed);
  feed.tick(110s);
  EXPECT_EQ(feed.state(), State::disarmed);
  EXPECT_EQ(feed.end_cause(), Cause::expired);
}

// What became true before the input came is acted on first, even if no timer fired.
TEST(Feed, TimePassesBeforeAnInputIsTaken) {
  Settings settings;
  settings.end.quiet = 2s;
  Feed feed = Feed::make(settings).value();
  const ProgramFacts facts = facts_of(1);
  EndlessSource source(1);
  EndlessSource other(1);
  Time now = 1s;
  feed.line(LineChange::link_up, now);
  ASSERT_TRUE(feed.arm({.facts = facts, .source = &source, .reserve = kNoReserve}, now));
  send(feed, 0x11, now);
  run(feed, now);
  ASSERT_EQ(feed.state(), State::wait_end);
  EXPECT_FALSE(feed.arm({.facts = facts, .source = &other}, now + 1s));
  EXPECT_TRUE(feed.arm({.facts = facts, .source = &other}, now + 3s));
  EXPECT_EQ(feed.state(), State::armed);
}

TEST(Feed, CountsHoldsAndLineUse) {
  Feed feed = Feed::make(Settings{}).value();
  const ProgramFacts facts = facts_of(50);
  EndlessSource source(50);
  Time now = 1s;
  feed.line(LineChange::link_up, now);
  ASSERT_TRUE(feed.arm({.facts = facts, .source = &source, .reserve = kNoReserve}, now));
  send(feed, 0x11, now);
  for (int i = 0; i < 3; ++i) {
    feed.mark_sent(feed.pending_out().size(), now);
    send(feed, 0x93, now);
    now += 10s;
    send(feed, 0x11, now);
  }
  run(feed, now);
  send(feed, 0x93, now);
  EXPECT_EQ(feed.state(), State::done);
  EXPECT_EQ(feed.counters().holds, 3U);
  EXPECT_EQ(feed.counters().held_for, 30s);
  EXPECT_GT(feed.line_use(), 0.97);
  EXPECT_LE(feed.line_use(), 1.0);
}

}  // namespace
}  // namespace dripfeed::feed
