// Thousands of seeded transfers over a bad line: what a protocol can detect is detected, what it cannot is counted and
// found by comparing the text; nothing stands still without a name; every transfer ends in a named state.
#include <map>

#include <gtest/gtest.h>

#include "tests/wire/packet_pair.h"

namespace dripfeed::wire {
namespace {

using namespace std::chrono_literals;
using packet::Cause;
using packet::Protocol;
using packet::ReceiveState;
using packet::State;

constexpr std::array kXmodems{Protocol::xmodem, Protocol::xmodem_crc, Protocol::xmodem_1k, Protocol::ymodem};

packet::Settings settings_of(Protocol protocol) {
  packet::Settings settings{.protocol = protocol};
  settings.answer_patience = 150s;  // longer than a receiver waits, so that every run ends
  settings.counted = protocol == Protocol::s3964r;
  return settings;
}

struct Ends {
  int whole = 0;        // both say so and the text is the same
  int broken = 0;       // not whole, and named
  int undetected = 0;   // both say whole and the text differs
  int unconfirmed = 0;  // the text is there, and the sender was not informed
  int forgotten = 0;    // acknowledged, and lost with the memory of the receiver
  std::map<Cause, int> causes;
  std::uint64_t faults = 0;
};

// One transfer and its judgement: torn exactly where the control may have an unfinished block.
void judge(PacketPair& run, Ends& ends) {
  const packet::Sender& sender = run.sender();
  const auto known = sender.interval();
  ends.faults += run.faults_made();
  const auto inside = [&](std::uint64_t offset) {
    return offset > 0 && offset < run.text().size() && run.text()[offset - 1] != '\n';
  };
  if (sender.state() == State::done) {
    // A receiver that was switched off after its last acknowledgement: no protocol shows it, an empty memory does.
    const bool forgotten = run.receiver_restarted() && run.received().empty();
    forgotten ? ++ends.forgotten : run.same() ? ++ends.whole : ++ends.undetected;
    return;
  }
  ++ends.broken;
  ++ends.causes[sender.end_cause()];
  const bool torn = inside(known.from) || inside(known.to);
  EXPECT_EQ(sender.state() == State::torn, torn) << name(sender.state()) << " " << known.from << ".." << known.to;
  if (run.receiver().state() == ReceiveState::done) ++ends.unconfirmed;
}

Ends play_all(Protocol protocol, const LineFaults& faults, unsigned seeds) {
  Ends ends;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    PacketPair run(settings_of(protocol), faults, seed);
    run.play();
    judge(run, ends);
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << name(protocol) << " seed " << seed;
      return ends;
    }
  }
  return ends;
}

TEST(XmodemScenarios, AGoodLineCarriesEveryText) {
  for (const Protocol protocol : kXmodems) EXPECT_EQ(play_all(protocol, {}, 50).whole, 50) << name(protocol);
}

TEST(XmodemScenarios, WhatASumCanSeeIsRepeatedUntilItIsRight) {
  // A flipped bit never passes a sum or a CRC; answers are single bytes without any check. A character that is lost or
  // doubled shifts those after it, and what then stands in the place of the sum is right once in 256 times.
  for (const Protocol protocol : kXmodems) {
    for (const LineFaults& faults : {LineFaults{.flip = 60}, LineFaults{.lose = 60}, LineFaults{.twice = 60},
                                     LineFaults{.delay = 60}, LineFaults{.silence = 20}}) {
      Ends ends = play_all(protocol, faults, 100);
      EXPECT_GT(ends.faults, 40U);
      const bool shifts = faults.lose > 0 || faults.twice > 0;
      const int chance = protocol == Protocol::xmodem && shifts ? 1 + static_cast<int>(ends.faults / 64) : 0;
      EXPECT_LE(ends.undetected, chance) << name(protocol) << " of " << ends.faults;
      EXPECT_GE(ends.whole, 90) << name(protocol);
    }
  }
}

TEST(XmodemScenarios, HoldsOfTheMachineAndStopsOfAPersonBreakNothing) {
  for (const Protocol protocol : kXmodems) {
    Ends ends = play_all(protocol, {.full = 30, .stop = 20}, 100);
    EXPECT_EQ(ends.whole, 100) << name(protocol);
  }
}

TEST(XmodemScenarios, ACancelEndsWithABlock) {
  for (const Protocol protocol : kXmodems) {
    Ends ends = play_all(protocol, {.cancel = 40}, 100);
    EXPECT_EQ(ends.undetected, 0);
    EXPECT_EQ(ends.whole + ends.causes[Cause::person], 100) << name(protocol);
    EXPECT_GT(ends.causes[Cause::person], 20);
  }
}

TEST(XmodemScenarios, ALostLinkAndARestartedReceiverEndTheJob) {
  for (const Protocol protocol : kXmodems) {
    Ends lost = play_all(protocol, {.link_down = 100}, 100);
    EXPECT_EQ(lost.whole + lost.causes[Cause::link_lost], 100);
    EXPECT_GT(lost.causes[Cause::link_lost], 10);
    Ends again = play_all(protocol, {.restart = 100}, 100);
    EXPECT_EQ(again.undetected, 0) << name(protocol);
    EXPECT_EQ(again.whole + again.broken, 100);
    EXPECT_GT(again.broken, 10);
  }
}

// A burst passes a sum of 8 bits with one chance in 256, a CRC of 16 with one in 65,536.
TEST(XmodemScenarios, WhatNoSumSeesIsAsRareAsTheorySays) {
  for (const Protocol protocol : kXmodems) {
    Ends ends = play_all(protocol, {.insert = 100, .burst = 300}, 300);
    EXPECT_GT(ends.faults, 300U);
    const int most = protocol == Protocol::xmodem ? 20 : 4;
    EXPECT_LE(ends.undetected, most) << name(protocol);
    RecordProperty(std::string(name(protocol)), ends.undetected);
  }
}

TEST(S3964Scenarios, AGoodLineCarriesEveryText) {
  for (const Protocol protocol : {Protocol::s3964, Protocol::s3964r})
    EXPECT_EQ(play_all(protocol, {}, 50).whole, 50) << name(protocol);
}

// A single fault never passes the exclusive or; two in one block may, where they hit the same bit.
TEST(S3964Scenarios, NumberedBlocksWithACheckArriveOnceOrNotAtAll) {
  for (const LineFaults& faults : {LineFaults{.flip = 40}, LineFaults{.lose = 40}, LineFaults{.twice = 40},
                                   LineFaults{.delay = 40}, LineFaults{.silence = 5}}) {
    const Ends ends = play_all(Protocol::s3964r, faults, 150);
    EXPECT_GT(ends.faults, 10U);
    EXPECT_EQ(ends.undetected, 0);
    EXPECT_GE(ends.whole, faults.silence > 0 ? 75 : 140);
  }
}

TEST(S3964Scenarios, HoldsStopsCancelsAndLossesEndByName) {
  EXPECT_EQ(play_all(Protocol::s3964r, {.full = 30, .stop = 20}, 100).whole, 100);
  Ends cancelled = play_all(Protocol::s3964r, {.cancel = 40}, 100);
  EXPECT_EQ(cancelled.whole + cancelled.causes[Cause::person], 100);
  Ends lost = play_all(Protocol::s3964r, {.link_down = 100}, 100);
  EXPECT_EQ(lost.whole + lost.causes[Cause::link_lost], 100);
  Ends again = play_all(Protocol::s3964r, {.restart = 100}, 100);
  EXPECT_EQ(again.undetected, 0);
  EXPECT_GT(again.broken, 10);
}

// Without a number a lost acknowledgement makes a block come twice, without a check a flipped bit stays: comparing the
// text finds both, and nothing else does.
TEST(S3964Scenarios, WhatThePlainProtocolCannotSeeIsFoundByComparing) {
  const Ends flipped = play_all(Protocol::s3964, {.flip = 40}, 1000);
  EXPECT_GT(flipped.undetected, 60);
  packet::Settings foreign = settings_of(Protocol::s3964r);
  foreign.counted = false;
  Ends ends;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    PacketPair run(foreign, {.lose = 200}, seed);
    run.play();
    judge(run, ends);
  }
  EXPECT_GT(ends.undetected, 2);
  EXPECT_EQ(ends.undetected + ends.whole + ends.broken, 150);
}

TEST(RemoteBufferScenarios, AGoodLineCarriesEveryText) {
  EXPECT_EQ(play_all(Protocol::remote_buffer_a, {}, 100).whole, 100);
  EXPECT_EQ(play_all(Protocol::remote_buffer_a, {.full = 30, .stop = 20}, 100).whole, 100);
}

// A lost message is an open line and ends the job; a damaged one is repeated. Nothing arrives twice or not at all.
TEST(RemoteBufferScenarios, WhatASumCanSeeIsRepeatedOrEndsTheJobByName) {
  for (const LineFaults& faults : {LineFaults{.flip = 40}, LineFaults{.lose = 40}, LineFaults{.twice = 40},
                                   LineFaults{.delay = 40}, LineFaults{.silence = 5}, LineFaults{.insert = 40}}) {
    const Ends ends = play_all(Protocol::remote_buffer_a, faults, 150);
    EXPECT_GT(ends.faults, 10U);
    EXPECT_EQ(ends.undetected, 0);
    EXPECT_EQ(ends.whole + ends.broken, 150);
    EXPECT_GT(ends.whole, 60);
  }
}

TEST(RemoteBufferScenarios, CancelsLossesAndRestartsEndByName) {
  Ends cancelled = play_all(Protocol::remote_buffer_a, {.cancel = 40}, 100);
  EXPECT_EQ(cancelled.whole + cancelled.causes[Cause::person], 100);
  Ends lost = play_all(Protocol::remote_buffer_a, {.link_down = 100}, 100);
  EXPECT_EQ(lost.whole + lost.causes[Cause::link_lost], 100);
  Ends again = play_all(Protocol::remote_buffer_a, {.restart = 100}, 100);
  EXPECT_EQ(again.undetected, 0);
  EXPECT_GT(again.causes[Cause::peer_reset], 10);
}

}  // namespace
}  // namespace dripfeed::wire
