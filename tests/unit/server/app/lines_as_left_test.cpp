// How lines are left and found again: what was only armed, what was torn, whose text it is; and what a control says
// while nothing is armed or a person's stop holds.
#include <algorithm>
#include <chrono>

#include "server/app/books.h"
#include "tests/unit/server/app/shop.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;

class LinesAsLeftTest : public ShopTest {};

// A control that goes on asking is one alarm a minute, with a count, and not a flood.
TEST_F(LinesAsLeftTest, StartsWithNothingArmedAreFolded) {
  Shop shop(database());
  shop.add_machine(kLathe);
  const auto alarms = [&] {
    return std::ranges::count_if(shop.told(), [](const std::string& text) { return text.starts_with("alarm lathe"); });
  };
  shop.round();
  EXPECT_EQ(alarms(), 0);
  shop.links.receive(url_of(kLathe), kDc1);
  shop.round();
  shop.round();
  EXPECT_EQ(alarms(), 1);
  EXPECT_EQ(shop.last_told(), "alarm lathe the control asked for a program (DC1); nothing is armed, nothing was sent");
  for (int i = 0; i < 20; ++i) {
    shop.links.receive(url_of(kLathe), kDc1);
    shop.links.advance(2s);
    shop.round();
  }
  EXPECT_EQ(alarms(), 1);
  shop.links.advance(20s);
  shop.round();
  EXPECT_EQ(alarms(), 2);
  EXPECT_EQ(shop.last_told(),
            "alarm lathe the control asked for a program (DC1) 20 times; nothing is armed, nothing was sent");
  EXPECT_EQ(shop.written(kLathe), "");
}

TEST_F(LinesAsLeftTest, AJobThatWasOnlyArmedIsNotTornByAKill) {
  Shop shop(database());
  shop.add_machine(kLathe);
  const store::Job job = shop.add_job(kLathe, program(20));
  must(shop.jobs.arm(job.id, std::nullopt, "olga"));
  shop.run(1s);
  Shop next(killed_copy(database()));
  const auto interrupted = must(next.store.jobs().interrupt_unfinished(by("server")));
  ASSERT_EQ(interrupted.size(), 1U);
  EXPECT_FALSE(interrupted.front().torn) << "the ledger proves that nothing left";
  EXPECT_EQ(interrupted.front().reason, "the server stopped before anything was sent");
  const store::LedgerInterval known = must(next.store.ledger().interval(job.id));
  EXPECT_EQ(known.high, 0U);
}

// The line knows of the torn block from its first moment on: what the control says to it then completes nothing.
TEST_F(LinesAsLeftTest, ALineIsMadeTornWhereTheStoreHasItSo) {
  {
    Shop shop(database());
    shop.add_machine(kLathe);
    shop.start_job(kLathe, program(20));
    shop.links.advance(50ms);
    while (shop.written(kLathe).back() == '\n') shop.links.advance(1ms);
    shop.links.lose(url_of(kLathe));
    shop.round();
  }
  Shop next(database());
  ASSERT_TRUE(next.catalog.open_lines());
  EXPECT_EQ(next.report(kLathe).state, LineState::torn);
  next.links.settle();
  const auto text = program(3);
  const auto line = next.lines.find(kLathe);
  EXPECT_FALSE(line->answer({.facts = facts_of(text), .source = std::make_shared<OwnedText>(text)}));
  EXPECT_FALSE(line->arm(order_of(9, text)));
  for (int i = 0; i < 5; ++i) next.links.receive(url_of(kLathe), kDc1);
  next.run(5s);
  EXPECT_EQ(next.written(kLathe), "");
  EXPECT_EQ(next.report(kLathe).state, LineState::torn);
  must(next.jobs.confirm_reset(kLathe, "reset at the panel", "olga"));
  EXPECT_EQ(next.report(kLathe).state, LineState::idle);
}

// What waits for its first job must not lose its text because the one before it is booked late.
TEST_F(LinesAsLeftTest, ATextBelongsToItsArmingWhateverEndsBeforeIt) {
  Shop shop(database());
  shop.add_machine(kLathe);
  const std::string text = program(20'000);  // more than what is read ahead
  const store::Job job = shop.add_job(kLathe, text);
  must(shop.jobs.arm(job.id, std::nullopt, "olga"));
  must(shop.jobs.cancel(job.id, "olga"));  // disarmed, and booked
  const std::string other = "%\n(2)\n" + text.substr(2);
  const store::Job second = shop.add_job(kLathe, other);
  must(shop.jobs.arm(second.id, std::nullopt, "olga"));
  shop.links.lose(url_of(kLathe));
  shop.round();
  shop.links.advance(1s);
  must(shop.jobs.arm(second.id, std::nullopt, "olga"));
  shop.links.receive(url_of(kLathe), kDc1);
  shop.run(feed::Time(1150us) * static_cast<std::int64_t>(other.size()) + 5s);
  EXPECT_EQ(shop.written(kLathe).size(), other.size());
}

TEST_F(LinesAsLeftTest, AStartWhileStoppedIsASuspectedResetInLedgerAndAlarm) {
  Shop shop(database());
  shop.add_machine(kLathe);
  const store::Job job = shop.start_job(kLathe, program(100));
  shop.run(300ms);
  must(shop.jobs.stop(job.id, "olga"));
  shop.run(1s);
  ASSERT_EQ(shop.report(kLathe).stall, "stopped");
  const std::string before = shop.written(kLathe);
  shop.links.receive(url_of(kLathe), kDc1);
  shop.run(1s);
  EXPECT_EQ(shop.ledger_of(job.id).back().note, kResetSuspected);
  EXPECT_TRUE(std::ranges::any_of(shop.told(), [](const std::string& text) {
    return text.starts_with("alarm lathe the control asked for a program (DC1) while the feed was stopped");
  }));
  const Error refused = refusal(shop.jobs.resume(job.id, "", "olga"));
  EXPECT_EQ(refused.code, ErrorCode::refused);
  EXPECT_NE(refused.text.find("it may have been reset"), std::string::npos) << refused.text;
  shop.run(5s);
  EXPECT_EQ(shop.written(kLathe), before);
  must(shop.jobs.cancel(job.id, "olga"));
  EXPECT_EQ(shop.state(job.id), store::JobState::cancelled);
  EXPECT_EQ(shop.written(kLathe), before);
}

}  // namespace
}  // namespace dripfeed::app
