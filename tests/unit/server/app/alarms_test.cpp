// Alarms in virtual time: folded with at most a write a second, over when their condition is, and not lost by a store
// that cannot be written; a control that asks is a state.
#include "server/app/out/alarms.h"

#include <chrono>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app::test {
namespace {

using namespace std::chrono_literals;

class AlarmsTest : public ShopTest {
 protected:
  AlarmsTest() : shop_(database()) {
    shop_.add_machine(kLathe);
    shop_.run(100ms);  // the line is seen: what was left of it is looked at once
  }
  std::vector<store::Alarm> all() { return must(shop_.store.alarms().list({.limit = 200, .after = {}}, {})).items; }
  std::vector<store::Alarm> of(AlarmKind kind) {
    std::vector<store::Alarm> found = all();
    std::erase_if(found, [&](const store::Alarm& alarm) { return alarm.kind != row_of(kind).name; });
    return found;
  }
  std::size_t published() {
    const auto events = shop_.published();
    return static_cast<std::size_t>(
        std::ranges::count_if(events, [](const std::string& text) { return text.starts_with("alarm "); }));
  }
  void wait_for_round() { ASSERT_TRUE(shop_.alarms.wait_for_round(10s)); }
  // The thread may write between any two calls of a test; what came after it then waits for its second.
  void write_all() {
    wait_for_round();
    shop_.links.advance(1s);
    wait_for_round();
  }

  Shop shop_;
};

TEST_F(AlarmsTest, AFloodIsWrittenOnceASecondAndCountsAll) {
  for (int i = 0; i < 100; ++i) {
    shop_.alarms.raise(kLathe, AlarmKind::person_called, "come");
    if (i == 0) wait_for_round();
  }
  wait_for_round();
  EXPECT_EQ(published(), 1U);
  shop_.links.advance(999ms);
  wait_for_round();
  EXPECT_EQ(all().at(0).count, 1U);
  shop_.links.advance(1ms);
  wait_for_round();
  EXPECT_EQ(all().at(0).count, 100U);
  EXPECT_EQ(published(), 2U) << "the newest count arrives";
  for (int i = 0; i < 1000; ++i) shop_.alarms.raise(kLathe, AlarmKind::person_called, "come " + std::to_string(i));
  shop_.links.advance(1s);
  wait_for_round();
  EXPECT_LE(all().size(), 20U) << "what differs is bounded, too";
  std::uint64_t sum = 0;
  for (const store::Alarm& alarm : all()) sum += alarm.count;
  EXPECT_EQ(sum, 1100U);
}

TEST_F(AlarmsTest, WhatLastsHasOneTextAndIsOverWhenItsConditionIs) {
  shop_.alarms.clear(kLathe, AlarmKind::machine_alarm);
  wait_for_round();
  EXPECT_TRUE(all().empty());
  shop_.alarms.raise(kLathe, AlarmKind::machine_alarm, "1010");
  wait_for_round();
  shop_.links.advance(1s);
  shop_.alarms.raise(kLathe, AlarmKind::machine_alarm, "1011");
  wait_for_round();
  auto rows = of(AlarmKind::machine_alarm);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].text, "1011");
  EXPECT_EQ(rows[0].cleared_at_ms, 0);
  EXPECT_NE(rows[1].cleared_at_ms, 0);
  shop_.links.advance(1s);
  // On and off within a second: each is there, and none lasts.
  shop_.alarms.clear(kLathe, AlarmKind::machine_alarm);
  shop_.alarms.raise(kLathe, AlarmKind::machine_alarm, "1012");
  shop_.alarms.clear(kLathe, AlarmKind::machine_alarm);
  write_all();
  EXPECT_TRUE(must(shop_.store.alarms().lasting()).empty());
  EXPECT_EQ(of(AlarmKind::machine_alarm).size(), 3U);
  shop_.links.advance(1s);
  shop_.alarms.raise(kLathe, AlarmKind::machine_alarm, "1013");
  shop_.alarms.raise(kLathe, AlarmKind::machine_alarm, "1014");
  write_all();
  ASSERT_EQ(must(shop_.store.alarms().lasting()).size(), 1U);
  EXPECT_EQ(must(shop_.store.alarms().lasting())[0].text, "1014");
}

TEST_F(AlarmsTest, ATornBlockIsOneAlarmOverAStopOfTheServer) {
  const store::Job job = shop_.start_job(kLathe, program(20));
  shop_.links.advance(50ms);
  while (shop_.written(kLathe).back() == '\n') shop_.links.advance(1ms);
  shop_.links.lose(url_of(kLathe));
  shop_.round();
  const auto torn = of(AlarmKind::torn_block);
  ASSERT_EQ(torn.size(), 1U);
  EXPECT_EQ(torn[0].job, job.id);
  EXPECT_EQ(of(AlarmKind::link_lost).at(0).job, job.id) << "at once: a job was on it";
  shop_.run(3s);
  EXPECT_EQ(of(AlarmKind::torn_block).at(0).count, 1U);
  Shop next(killed_copy(database()));
  ASSERT_TRUE(next.alarms.start());
  ASSERT_TRUE(next.catalog.open_lines());
  next.run(2s);
  const auto kept = must(next.store.alarms().lasting());
  ASSERT_EQ(kept.size(), 1U) << "the link is up again, the block is torn";
  EXPECT_EQ(kept[0].id, torn[0].id);
  EXPECT_EQ(kept[0].count, 1U);
  must(next.jobs.confirm_reset(kLathe, "reset at the panel", "olga"));
  next.run(2s);
  EXPECT_TRUE(must(next.store.alarms().lasting()).empty());
}

// The server ended after the block was known as torn and before its alarm was written.
TEST_F(AlarmsTest, ATornBlockThatNoOneRaisedIsFoundAtTheStart) {
  shop_.start_job(kLathe, program(20));
  shop_.run(200ms);
  Shop next(killed_copy(database()));
  ASSERT_EQ(must(next.store.jobs().interrupt_unfinished(by("server"))).size(), 1U);
  ASSERT_TRUE(must(next.store.alarms().lasting()).empty());
  ASSERT_TRUE(next.alarms.start());
  ASSERT_TRUE(next.alarms.wait_for_round(10s));
  const auto torn = must(next.store.alarms().lasting());
  ASSERT_EQ(torn.size(), 1U);
  EXPECT_EQ(torn[0].kind, "torn_block");
  EXPECT_EQ(torn[0].job, 1U);
  ASSERT_TRUE(next.alarms.start());
  next.links.advance(2s);
  ASSERT_TRUE(next.alarms.wait_for_round(10s));
  EXPECT_EQ(must(next.store.alarms().list({})).items.size(), 1U);
  // It is over by the store's word, though no line was there to say so.
  must(next.store.jobs().confirm_reset(kLathe, "reset at the panel", by("olga")));
  next.links.advance(2s);
  ASSERT_TRUE(next.alarms.wait_for_round(10s));
  EXPECT_TRUE(must(next.store.alarms().lasting()).empty());
}

TEST_F(AlarmsTest, ALinkIsMissedAfterFiveSeconds) {
  shop_.run(1s);
  shop_.links.lose(url_of(kLathe));
  shop_.run(3s);
  EXPECT_TRUE(all().empty()) << "it was plugged again";
  shop_.links.cable(url_of(kLathe)).refusal = "no such device";
  shop_.links.lose(url_of(kLathe));
  shop_.run(4900ms);
  EXPECT_TRUE(all().empty());
  shop_.run(300ms);
  ASSERT_EQ(of(AlarmKind::link_lost).size(), 1U);
  EXPECT_EQ(of(AlarmKind::link_lost)[0].text, "the link is down: no such device");
  shop_.links.cable(url_of(kLathe)).refusal.clear();
  shop_.run(10s);
  EXPECT_NE(of(AlarmKind::link_lost).at(0).cleared_at_ms, 0);
  EXPECT_EQ(of(AlarmKind::link_lost)[0].count, 1U);
}

TEST_F(AlarmsTest, ALedgerThatCannotBeWrittenIsAnAlarmUntilItCan) {
  shop_.start_job(kLathe, program(200));
  shop_.store.watched_ledger().watch(
      [](auto) { return std::optional(store::Error{store::ErrorCode::disk_full, "no room"}); });
  shop_.run(2s);
  ASSERT_EQ(of(AlarmKind::ledger_failed).size(), 1U);
  EXPECT_EQ(of(AlarmKind::ledger_failed)[0].cleared_at_ms, 0);
  EXPECT_EQ(refusal(shop_.alarms.shelve(of(AlarmKind::ledger_failed)[0].id, 5, "later", "olga")).code,
            ErrorCode::refused);
  shop_.store.watched_ledger().watch({});
  shop_.run(2s);
  EXPECT_NE(of(AlarmKind::ledger_failed)[0].cleared_at_ms, 0);
}

TEST_F(AlarmsTest, AnUnknownMachineIsReportedAndNotTriedForEver) {
  shop_.alarms.raise("nobody", AlarmKind::person_called, "come");
  wait_for_round();
  shop_.links.advance(5s);
  wait_for_round();
  EXPECT_EQ(published(), 1U);
  EXPECT_TRUE(all().empty());
}

TEST_F(AlarmsTest, AShelfEndsByItself) {
  shop_.alarms.raise(kLathe, AlarmKind::link_note, "not confirmed");
  wait_for_round();
  const store::Id id = all().at(0).id;
  must(shop_.alarms.shelve(id, 5, "known", "olga"));
  shop_.links.advance(5min - 1s);
  wait_for_round();
  EXPECT_EQ(all()[0].shelved_by, "olga");
  shop_.links.advance(2s);
  wait_for_round();
  EXPECT_EQ(all()[0].shelved_by, "");
  EXPECT_EQ(published(), 3U) << "raised, shelved, taken down";
}

TEST_F(AlarmsTest, WhoAsksWithNothingArmedIsAStateAndNoAlarm) {
  shop_.round();
  EXPECT_EQ(shop_.books.asks_of(kLathe), Asks{});
  const std::int64_t begun_ms = shop_.links.clock().wall_ms();
  for (int i = 0; i < 20; ++i) {
    shop_.links.receive(url_of(kLathe), kDc1);
    shop_.run(2s);
  }
  const Asks asks = shop_.books.asks_of(kLathe);
  EXPECT_EQ(asks.count, 20U);
  EXPECT_GE(asks.since_ms, begun_ms);
  EXPECT_LE(asks.since_ms, begun_ms + 100);
  EXPECT_TRUE(all().empty());
  EXPECT_EQ(shop_.events.snapshot().at(0).asks, asks);
  shop_.run(57s);
  EXPECT_EQ(shop_.books.asks_of(kLathe).count, 20U);
  shop_.run(2s);
  EXPECT_EQ(shop_.books.asks_of(kLathe), Asks{}) << "nothing was heard for a minute";
  shop_.links.receive(url_of(kLathe), kDc1);
  shop_.run(100ms);
  EXPECT_EQ(shop_.books.asks_of(kLathe).count, 1U);
  must(shop_.jobs.arm(shop_.add_job(kLathe, program(5)).id, std::nullopt, "olga"));
  shop_.round();
  EXPECT_EQ(shop_.books.asks_of(kLathe), Asks{});
  EXPECT_EQ(shop_.written(kLathe), "");
}

}  // namespace
}  // namespace dripfeed::app::test
