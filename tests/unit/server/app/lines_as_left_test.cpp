// How lines are left and found again: what was only armed, what was torn, whose text it is; and what a control says
// while nothing is armed or a person's stop holds.
#include <algorithm>
#include <chrono>

#include "server/app/jobs/books.h"
#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;

class LinesAsLeftTest : public ShopTest {};

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
  next.links.run_posted();
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
  EXPECT_TRUE(std::ranges::any_of(shop.published(), [](const std::string& text) {
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

// A record in memory, as another process may leave it, or as a device changes it that is plugged in later.
class Record final : public LineClaim {
 public:
  explicit Record(std::string& torn) : torn_(torn) {}
  [[nodiscard]] std::string torn() const override { return torn_; }
  std::expected<void, std::string> begin(std::string_view /*what*/) override {
    if (torn_.empty()) return {};
    return std::unexpected(torn_);
  }
  std::expected<void, std::string> end() override { return {}; }
  std::expected<void, std::string> tear(std::string_view why) override {
    torn_ = why;
    return {};
  }
  std::expected<void, std::string> confirm_reset(std::string_view /*reason*/) override {
    torn_.clear();
    return {};
  }

 private:
  std::string& torn_;
};

ClaimLine claims(std::string& torn) {
  return [&torn](const machine::LinkUrl&) -> std::expected<std::unique_ptr<LineClaim>, std::string> {
    return std::make_unique<Record>(torn);
  };
}

TEST_F(LinesAsLeftTest, WhatAnotherProcessLeftTornIsConfirmedHere) {
  std::string torn = "part.nc by dripfeed send broke off inside a block";
  Shop shop(database(), nullptr, nullptr, claims(torn));
  shop.add_machine(kLathe);
  EXPECT_EQ(shop.report(kLathe).state, LineState::torn);
  EXPECT_EQ(shop.lines.why_torn(kLathe), torn);
  const store::Job job = shop.add_job(kLathe, program(3));
  EXPECT_EQ(refusal(shop.jobs.arm(job.id, std::nullopt, "olga")).code, ErrorCode::refused);
  must(shop.jobs.confirm_reset(kLathe, "reset at the panel", "olga"));
  shop.round();
  EXPECT_EQ(torn, "");
  must(shop.jobs.arm(job.id, std::nullopt, "olga"));
}

// The port has another device than when the line was made: nothing leaves, and a person gets out of it.
TEST_F(LinesAsLeftTest, ARecordThatRefusesLaterIsConfirmedOnceTheJobIsCancelled) {
  std::string torn;
  Shop shop(database(), nullptr, nullptr, claims(torn));
  shop.add_machine(kLathe);
  const store::Job job = shop.add_job(kLathe, program(3));
  torn = "another device is at this port";
  must(shop.jobs.arm(job.id, std::nullopt, "olga"));
  shop.links.receive(url_of(kLathe), kDc1);
  shop.run(2s);
  EXPECT_EQ(shop.written(kLathe), "");
  EXPECT_EQ(shop.books.why_refused(kLathe), torn);
  EXPECT_EQ(std::ranges::count(shop.published(), "alarm lathe nothing leaves on its line: " + torn), 1);
  const Error early = refusal(shop.jobs.confirm_reset(kLathe, "the new adapter is meant", "olga"));
  EXPECT_NE(early.text.find("cancel it first"), std::string::npos) << early.text;
  must(shop.jobs.cancel(job.id, "olga"));
  EXPECT_EQ(shop.state(job.id), store::JobState::cancelled);
  EXPECT_EQ(shop.job(job.id).reason, "cancelled: nothing was sent");
  must(shop.jobs.confirm_reset(kLathe, "the new adapter is meant", "olga"));
  shop.round();
  EXPECT_EQ(torn, "");
  EXPECT_EQ(shop.books.why_refused(kLathe), "");
  shop.start_job(kLathe, "%\n(2)\n" + program(3).substr(2));
  shop.run(2s);
  EXPECT_NE(shop.written(kLathe), "");
}

}  // namespace
}  // namespace dripfeed::app
