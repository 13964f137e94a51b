// The doorbell: a ring is reported once, only where it was seen to come, and answered whatever is restarted in between.
#include "protocol/modbus/doorbell.h"

#include <random>
#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace dripfeed::modbus {
namespace {

using namespace std::chrono_literals;

class DoorbellTest : public testing::Test {
 protected:
  // The PLC as it is read, 0.5 s later.
  void see(std::uint16_t bell, std::uint16_t request = 1, std::uint32_t program = 42) {
    now += 500ms;
    bells.seen(boot, {.bell = bell, .request = request, .requested = program}, now);
  }
  // The host writes what it wants to write; the PLC keeps it.
  void write_answer() {
    ASSERT_EQ(bells.want(), Doorbell::Want::write_answer);
    kept = bells.image();
    bells.answer_written();
  }
  static BellAnswer armed(std::uint16_t bell) { return {.bell = bell, .outcome = BellOutcome::armed, .job = 7}; }

  Doorbell bells;
  Doorbell::Time now{};
  std::uint16_t boot = 3;
  AnswerImage kept{};
};

TEST_F(DoorbellTest, ARingIsReportedOnceAndAnswered) {
  see(0);
  EXPECT_FALSE(bells.take_ring());
  see(1, 2, 70'000);
  const auto ring = bells.take_ring();
  ASSERT_TRUE(ring);
  EXPECT_EQ(ring->bell, 1);
  EXPECT_EQ(ring->request, 2);
  EXPECT_EQ(ring->program, 70'000U);
  see(1, 2, 70'000);
  EXPECT_FALSE(bells.take_ring());
  EXPECT_EQ(bells.want(), Doorbell::Want::nothing);
  bells.answer(armed(1));
  write_answer();
  EXPECT_EQ(kept, (AnswerImage{1, 2, 0, 0, 7, kept[5], kept[6]}));
  EXPECT_EQ(answered_bell(kept), 1);
  see(1);
  EXPECT_EQ(bells.want(), Doorbell::Want::nothing);
  see(2);
  EXPECT_EQ(bells.take_ring()->bell, 2);
}

TEST_F(DoorbellTest, AnAnswerIsWrittenAgainUntilItIsThere) {
  see(0);
  see(1);
  static_cast<void>(bells.take_ring());
  bells.answer(armed(1));
  for (int i = 0; i < 3; ++i) see(1);
  write_answer();
  EXPECT_EQ(bells.want(), Doorbell::Want::nothing);
}

TEST_F(DoorbellTest, ARingThatNoOneSawComeIsMissed) {
  see(5);
  EXPECT_FALSE(bells.take_ring());
  ASSERT_EQ(bells.want(), Doorbell::Want::read_answer);
  bells.answer_read(kept);
  write_answer();
  EXPECT_EQ(answered_bell(kept), 5);
  EXPECT_EQ(kept[1], static_cast<std::uint16_t>(BellOutcome::refused));
  EXPECT_EQ(kept[2], static_cast<std::uint16_t>(BellReason::missed));
  see(6);
  EXPECT_EQ(bells.take_ring()->bell, 6);
}

TEST_F(DoorbellTest, AnAnsweredRingStaysSoAfterARestartOfTheHost) {
  encode(armed(5), kept);
  see(5);
  bells.answer_read(kept);
  EXPECT_EQ(bells.want(), Doorbell::Want::nothing);
  EXPECT_FALSE(bells.take_ring());
}

TEST_F(DoorbellTest, ARestartOfThePlcIsNoRing) {
  see(0);
  see(4);
  EXPECT_TRUE(bells.take_ring());
  bells.answer(armed(4));
  write_answer();
  ++boot;
  see(3);
  EXPECT_FALSE(bells.take_ring());
  EXPECT_EQ(bells.want(), Doorbell::Want::read_answer);
  bells.answer_read({});  // it has no such registers any more
  write_answer();
  ++boot;
  see(0);
  EXPECT_EQ(bells.want(), Doorbell::Want::nothing);
  see(1);
  EXPECT_TRUE(bells.take_ring());
}

TEST_F(DoorbellTest, ARingAfterASilenceIsMissedAndAnUnchangedBellIsNone) {
  see(0);
  see(1);
  static_cast<void>(bells.take_ring());
  bells.answer(armed(1));
  now += Doorbell::kFresh * 10;
  see(1);
  write_answer();  // still the answer to that ring
  EXPECT_EQ(kept[1], static_cast<std::uint16_t>(BellOutcome::armed));
  now += Doorbell::kFresh;
  see(2);
  EXPECT_FALSE(bells.take_ring());
  EXPECT_EQ(bells.want(), Doorbell::Want::read_answer);
}

TEST_F(DoorbellTest, TheAnswerToAnEarlierRingIsDropped) {
  see(0);
  see(1);
  static_cast<void>(bells.take_ring());
  see(2);
  bells.answer(armed(1));
  EXPECT_EQ(bells.want(), Doorbell::Want::nothing);
  EXPECT_EQ(bells.take_ring()->bell, 2);
  bells.answer(armed(2));
  write_answer();
  EXPECT_EQ(answered_bell(kept), 2);
}

TEST_F(DoorbellTest, DamagedAnswerRegistersAreNone) {
  encode(armed(5), kept);
  kept[4] ^= 1;
  EXPECT_FALSE(answered_bell(kept));
  EXPECT_FALSE(answered_bell(std::span<const std::uint16_t>(kept).first(6)));
}

// A PLC and a host over many restarts of either, silences and lost writes: each ring is reported once at the most, and
// only where the host was there; the last one is answered in the end.
class RestartsTest : public testing::TestWithParam<unsigned> {
 protected:
  void ring() {
    if (answered_bell(answer) != bell && bell != 0) return;  // the rule: the one before is answered
    bell = successor(bell);
    ++rung;
    bell_at = now;
  }
  void restart_plc(bool keeps) {
    ++boot;
    if (keeps) return;
    bell = 0;
    answer = {};
  }
  void poll(bool lost) {
    if (lost) return;
    host.seen(boot, {.bell = bell, .request = 1, .requested = rung}, now);
    if (const auto one = host.take_ring()) {
      EXPECT_TRUE(reported.insert(one->program).second) << "ring " << one->program << " is reported twice";
      EXPECT_EQ(one->program, rung);
      EXPECT_LE(now - bell_at, Doorbell::kFresh) << "told late";
      EXPECT_GE(bell_at, host_since) << "rung before the host was there";
      host.answer({.bell = one->bell, .outcome = BellOutcome::answered});
    }
  }
  void serve(bool lost) {
    if (lost) return;
    if (host.want() == Doorbell::Want::read_answer) host.answer_read(answer);
    if (host.want() != Doorbell::Want::write_answer) return;
    answer = host.image();
    host.answer_written();
  }

  Doorbell host;
  Doorbell::Time now{};
  Doorbell::Time host_since{};
  Doorbell::Time bell_at{};
  std::uint16_t bell = 0;
  std::uint16_t boot = 1;
  std::uint32_t rung = 0;
  AnswerImage answer{};
  std::set<std::uint32_t> reported;
};

TEST_P(RestartsTest, ReportEachRingOnceAtTheMost) {
  std::minstd_rand random(GetParam());
  for (int step = 0; step < 2000; ++step) {
    now += 100ms;
    switch (random() % 40) {
      case 0: restart_plc(random() % 2 == 0); break;
      case 1:
        host = Doorbell();
        host_since = now;
        break;
      case 2: now += 20s; break;
      case 3:
      case 4:
      case 5: ring(); break;
      default: break;
    }
    poll(random() % 4 == 0);
    serve(random() % 3 == 0);
  }
  for (int i = 0; i < 4; ++i) {
    poll(false);
    serve(false);
  }
  EXPECT_GT(reported.size(), 10U);
  if (bell != 0) {
    EXPECT_EQ(answered_bell(answer), bell);
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, RestartsTest, testing::Range(1U, 65U));

// Every transition from every state, and no other.
TEST_F(DoorbellTest, TakesEveryCellOfTheTable) {
  using Cell = std::pair<BellState, BellInput>;
  std::set<Cell> taken;
  const auto make = [&](BellState state) {
    bells = Doorbell();
    bells.observe_cells([](void* to, BellState s, BellInput i) { static_cast<std::set<Cell>*>(to)->insert({s, i}); },
                        &taken);
    boot = 3;
    if (state == BellState::unmet) return;
    see(state == BellState::checking ? 1 : 0);
    if (state == BellState::rung || state == BellState::answering) see(1);
    if (state == BellState::answering) bells.answer(armed(1));
    ASSERT_EQ(bells.state(), state);
  };
  for (std::size_t i = 0; i < kBellStates; ++i) {
    const auto state = static_cast<BellState>(i);
    const std::uint16_t bell = state == BellState::quiet || state == BellState::unmet ? 0 : 1;
    make(state);
    bells.answer(armed(bell));
    make(state);
    see(0);
    make(state);
    see(2);
    make(state);
    ++boot;
    see(1);
    make(state);
    if (state == BellState::quiet) see(2);  // a quiet bell that is not 0
    if (state == BellState::quiet) bells.answer(armed(2));
    if (state == BellState::quiet) bells.answer_written();
    if (state != BellState::unmet) see(state == BellState::quiet ? std::uint16_t{2} : bell);
    make(state);
    bells.answer_read(kept);
    make(state);
    encode(armed(1), kept);
    bells.answer_read(kept);
    make(state);
    bells.answer_written();
    kept = {};
  }
  for (std::size_t state = 0; state < kBellStates; ++state) {
    for (std::size_t input = 0; input < kBellInputs; ++input) {
      const Cell one{static_cast<BellState>(state), static_cast<BellInput>(input)};
      const bool never = cell(one.first, one.second).action == BellAction::never;
      EXPECT_EQ(taken.contains(one), !never) << "state " << state << ", input " << input;
    }
  }
}

TEST(DoorbellNames, AreAllThere) {
  EXPECT_EQ(name(BellRequest::call), "call");
  EXPECT_EQ(name(BellRequest::scrap), "scrap");
  EXPECT_EQ(name(BellOutcome::refused), "refused");
  EXPECT_EQ(name(BellReason::unknown), "unknown request");
  EXPECT_EQ(name(BellReason::no_order), "no order");
}

}  // namespace
}  // namespace dripfeed::modbus
