// Queueing, arming, stopping and confirming, over a real store and fake links: nothing goes out that a person did not
// arm for this line now, and what did not go out is in the queue again.
#include "server/app/jobs/jobs.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;
using store::JobState;

constexpr std::string_view kNak = "\x15";

class JobsTest : public ShopTest {
 protected:
  JobsTest() : shop_(database()) { shop_.add_machine(kLathe); }

  store::Job arm(const std::string& text) {
    const store::Job job = shop_.add_job(kLathe, text);
    return must(shop_.jobs.arm(job.id, std::nullopt, "olga"));
  }
  // Started and inside a block.
  store::Job feed_into_a_block() {
    const store::Job job = shop_.start_job(kLathe, text_);
    shop_.run(50ms);
    while (shop_.written(kLathe).back() == '\n') shop_.links.advance(1ms);
    return job;
  }
  // The control asks; whether anything goes out.
  bool sends_on_dc1() {
    const std::size_t before = shop_.written(kLathe).size();
    shop_.links.receive(url_of(kLathe), kDc1);
    shop_.run(2s);
    return shop_.written(kLathe).size() != before;
  }

  const std::string text_ = program(20);
  Shop shop_;
};

TEST_F(JobsTest, AJobTakesItsCourse) {
  const store::Job queued = shop_.add_job(kLathe, text_);
  EXPECT_EQ(queued.state, JobState::queued);
  EXPECT_EQ(queued.link, "pty:/machine/lathe");
  EXPECT_EQ(queued.bytes_total, text_.size());
  EXPECT_FALSE(sends_on_dc1()) << "queued is not armed";
  const store::Job armed = must(shop_.jobs.arm(queued.id, std::nullopt, "olga"));
  EXPECT_EQ(armed.state, JobState::armed);
  EXPECT_EQ(armed.armed_by, "olga");
  EXPECT_EQ(armed.expires_at_ms, armed.armed_at_ms + 600'000);
  shop_.run(1s);
  EXPECT_EQ(shop_.written(kLathe), "") << "armed is not started";
  shop_.links.receive(url_of(kLathe), kDc1);
  shop_.run(50ms);
  EXPECT_EQ(shop_.state(queued.id), JobState::feeding);
  EXPECT_EQ(shop_.job(queued.id).expires_at_ms, 0);
  shop_.links.receive(url_of(kLathe), kDc3);
  shop_.round();
  EXPECT_EQ(shop_.state(queued.id), JobState::held);
  shop_.links.receive(url_of(kLathe), kDc1);
  shop_.round();
  EXPECT_EQ(shop_.state(queued.id), JobState::feeding);
  shop_.run(2s);
  EXPECT_EQ(shop_.state(queued.id), JobState::draining);
  EXPECT_EQ(shop_.written(kLathe), text_);
  shop_.links.receive(url_of(kLathe), kDc3);
  shop_.round();
  EXPECT_EQ(shop_.state(queued.id), JobState::done);
  const std::vector<std::string> audited = shop_.audited(queued.id);
  ASSERT_EQ(audited.size(), 4U) << "holds are in the ledger, not in the audit";
  EXPECT_NE(audited[1].find("queued to armed"), std::string::npos);
  EXPECT_NE(audited[2].find("armed to feeding"), std::string::npos);
  EXPECT_NE(audited[3].find("draining to done"), std::string::npos);
}

TEST_F(JobsTest, AQueueNeverArmsItsNextJob) {
  const store::Job first = arm(text_);
  const store::Job second = must(shop_.jobs.add(first.release, "anna"));
  const Error busy = refusal(shop_.jobs.arm(second.id, std::nullopt, "olga"));
  EXPECT_EQ(busy.code, ErrorCode::refused);
  EXPECT_EQ(shop_.state(second.id), JobState::queued);
  ASSERT_TRUE(sends_on_dc1());
  shop_.links.receive(url_of(kLathe), kDc3);
  shop_.run(10min);
  ASSERT_EQ(shop_.state(first.id), JobState::done);
  EXPECT_EQ(shop_.state(second.id), JobState::queued);
  EXPECT_FALSE(sends_on_dc1());
  EXPECT_EQ(shop_.books.asks_of(kLathe).count, 1U);
  must(shop_.jobs.arm(second.id, std::nullopt, "olga"));
  EXPECT_TRUE(sends_on_dc1());
}

TEST_F(JobsTest, AnArmingExpiresAfterTenMinutes) {
  const store::Job job = arm(text_);
  shop_.links.advance(10min - 1ms);
  shop_.round();
  EXPECT_EQ(shop_.state(job.id), JobState::armed);
  shop_.links.advance(1ms);
  shop_.round();
  EXPECT_EQ(shop_.state(job.id), JobState::queued);
  EXPECT_EQ(shop_.job(job.id).reason, "disarmed, nothing was sent: expired");
  EXPECT_FALSE(sends_on_dc1());
  must(shop_.jobs.arm(job.id, 0.5, "olga"));
  shop_.links.advance(30s);
  shop_.round();
  EXPECT_EQ(shop_.state(job.id), JobState::queued) << "half a minute was given";
  must(shop_.jobs.arm(job.id, 60.0, "olga"));
  shop_.links.advance(59min);
  shop_.round();
  EXPECT_TRUE(sends_on_dc1());
}

TEST_F(JobsTest, OnlyAnArmingOfAtMostAnHourIsTaken) {
  const store::Job job = shop_.add_job(kLathe, text_);
  for (const double minutes : {0.0, -1.0, 60.1, 1e300, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Error error = refusal(shop_.jobs.arm(job.id, minutes, "olga"));
    EXPECT_EQ(error.code, ErrorCode::invalid) << minutes;
    ASSERT_EQ(error.places.size(), 1U);
    EXPECT_EQ(error.places.front().pointer, "/minutes");
    EXPECT_EQ(shop_.state(job.id), JobState::queued);
  }
  EXPECT_FALSE(sends_on_dc1());
}

TEST_F(JobsTest, WhateverMeansThatTheControlIsNotAsItWasSeenDisarms) {
  struct Row {
    std::string_view input;
    std::string cause;
  };
  const Row rows[] = {{kSyn, "syn"}, {kNak, "nak"}, {"X", "unexpected_input"}, {"", "link_lost"}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.cause);
    const store::Job job = arm("%\n(" + row.cause + ")\n" + text_.substr(2));
    if (row.input.empty()) {
      shop_.links.lose(url_of(kLathe));
    } else {
      shop_.links.receive(url_of(kLathe), row.input);
    }
    shop_.round();
    const store::Job after = shop_.job(job.id);
    EXPECT_EQ(after.state, JobState::queued);
    EXPECT_EQ(after.reason, "disarmed, nothing was sent: " + row.cause);
    EXPECT_FALSE(after.torn);
    shop_.links.advance(1s);  // a lost link is opened again
    EXPECT_FALSE(sends_on_dc1());
    EXPECT_EQ(shop_.written(kLathe), "");
    must(shop_.jobs.cancel(job.id, "olga"));
  }
}

TEST_F(JobsTest, ALineThatIsDownTakesNoArming) {
  const store::Job job = shop_.add_job(kLathe, text_);
  shop_.links.cable(url_of(kLathe)).comes_up = false;
  shop_.links.lose(url_of(kLathe));
  shop_.links.advance(1s);
  const Error error = refusal(shop_.jobs.arm(job.id, std::nullopt, "olga"));
  EXPECT_EQ(error.code, ErrorCode::refused);
  EXPECT_EQ(error.text, "lathe cannot be armed: the link is down (the line is idle)");
  EXPECT_EQ(shop_.state(job.id), JobState::queued);
  shop_.links.up(url_of(kLathe));
  EXPECT_FALSE(sends_on_dc1());
  must(shop_.jobs.arm(job.id, std::nullopt, "olga"));
  EXPECT_TRUE(sends_on_dc1());
}

TEST_F(JobsTest, NothingIsArmedWithoutItsFirstLedgerRow) {
  const store::Job job = shop_.add_job(kLathe, text_);
  shop_.store.watched_ledger().watch([](auto) { return store::Error{store::ErrorCode::disk_full, "no room"}; });
  const Error error = refusal(shop_.jobs.arm(job.id, std::nullopt, "olga"));
  EXPECT_NE(error.text.find("no room"), std::string::npos) << error.text;
  EXPECT_EQ(shop_.state(job.id), JobState::queued);
  EXPECT_FALSE(sends_on_dc1());
}

TEST_F(JobsTest, OnlyAReleasedTextIsQueued) {
  EXPECT_EQ(refusal(shop_.jobs.add(99, "anna")).code, ErrorCode::not_found);
  EXPECT_EQ(refusal(shop_.jobs.arm(99, std::nullopt, "olga")).code, ErrorCode::not_found);
  EXPECT_EQ(refusal(shop_.jobs.stop(99, "olga")).code, ErrorCode::not_found);
  const store::Release release = release_text(shop_.store, kLathe, text_);
  const store::Job queued = must(shop_.jobs.add(release.id, "anna"));
  must(shop_.store.releases().move(release.id, {store::ReleaseState::obsolete, "wrong", 0}, by("boris")));
  EXPECT_EQ(refusal(shop_.jobs.add(release.id, "anna")).code, ErrorCode::refused);
  EXPECT_EQ(refusal(shop_.jobs.arm(queued.id, std::nullopt, "olga")).code, ErrorCode::refused)
      << "what was taken back after it was queued";
  EXPECT_EQ(shop_.state(queued.id), JobState::queued);
}

TEST_F(JobsTest, ATextThatCannotBeFedIsRefusedWithItsPlace) {
  struct Row {
    const char* text;
    std::uint32_t line;
  };
  const Row rows[] = {
      {"O1\nG0X1.\nM30\n%\n", 1}, {"%\nO1\nG0X1.\n%\n", 3}, {"%\nO1\nM30\n", 4}, {"%\nO1\n(50%)\nM30\n%\n", 3}};
  for (const Row& row : rows) {
    const Error error = refusal(shop_.jobs.add(release_text(shop_.store, kLathe, row.text).id, "anna"));
    EXPECT_EQ(error.code, ErrorCode::refused) << row.text;
    ASSERT_EQ(error.places.size(), 1U);
    EXPECT_EQ(error.places.front().line, row.line) << row.text << error.text;
  }
}

TEST_F(JobsTest, AnEobOfTwoCharactersCountsOnceOnTheWire) {
  std::string windows;
  for (const char c : text_) windows += c == '\n' ? "\r\n" : std::string(1, c);
  const store::Job job = arm(windows);
  EXPECT_EQ(job.bytes_total, text_.size());
  ASSERT_TRUE(sends_on_dc1());
  EXPECT_EQ(shop_.written(kLathe), text_);
}

TEST_F(JobsTest, StopAndResumeAtABlockEnd) {
  const store::Job job = feed_into_a_block();
  must(shop_.jobs.stop(job.id, "olga"));
  shop_.run(10s);
  EXPECT_EQ(shop_.state(job.id), JobState::held);
  const std::string stopped = shop_.written(kLathe);
  EXPECT_EQ(stopped.back(), '\n');
  EXPECT_LT(stopped.size(), text_.size());
  must(shop_.jobs.resume(job.id, "", "olga"));
  shop_.run(2s);
  EXPECT_EQ(shop_.written(kLathe), text_);
  const std::vector<std::string> audited = shop_.audited(job.id);
  EXPECT_TRUE(std::ranges::count(audited, "job.stop: ") == 1);
  EXPECT_TRUE(std::ranges::count(audited, "job.resume: ") == 1);
}

TEST_F(JobsTest, WhatEndsSendingTakesEffectWithoutItsAuditAndWhatStartsItDoesNot) {
  const store::Job job = feed_into_a_block();
  shop_.store.closable_audit().close(true);
  must(shop_.jobs.stop(job.id, "olga"));
  shop_.run(10s);
  const std::string stopped = shop_.written(kLathe);
  EXPECT_LT(stopped.size(), text_.size());
  EXPECT_FALSE(shop_.jobs.resume(job.id, "", "olga"));
  shop_.run(10s);
  EXPECT_EQ(shop_.written(kLathe), stopped);
  must(shop_.jobs.cancel(job.id, "olga"));
  EXPECT_EQ(shop_.state(job.id), JobState::cancelled);
}

TEST_F(JobsTest, AStopIsTakenBackWhileTheControlHolds) {
  const store::Job job = feed_into_a_block();
  must(shop_.jobs.stop(job.id, "olga"));
  shop_.links.receive(url_of(kLathe), kDc3);
  shop_.round();
  ASSERT_EQ(shop_.report(kLathe).stall, "held by DC3");
  must(shop_.jobs.resume(job.id, "", "olga"));
  const std::string held = shop_.written(kLathe);
  shop_.run(1s);
  EXPECT_EQ(shop_.written(kLathe), held) << "the control holds still";
  shop_.links.receive(url_of(kLathe), kDc1);
  shop_.run(2s);
  EXPECT_EQ(shop_.written(kLathe), text_);
}

TEST_F(JobsTest, GoingOnAsIfDc1HadComeNeedsAReasonThatStandsInTheLedger) {
  const store::Job job = feed_into_a_block();
  EXPECT_FALSE(shop_.jobs.resume(job.id, "it runs", "olga")) << "nothing is held";
  shop_.links.receive(url_of(kLathe), kDc3);
  shop_.round();
  const std::string held = shop_.written(kLathe);
  const Error error = refusal(shop_.jobs.resume(job.id, "", "olga"));
  EXPECT_EQ(error.code, ErrorCode::invalid);
  EXPECT_EQ(error.places.at(0).pointer, "/reason");
  shop_.run(1s);
  EXPECT_EQ(shop_.written(kLathe), held);
  must(shop_.jobs.resume(job.id, "the DC1 was lost", "olga"));
  const auto rows = shop_.ledger_of(job.id);
  EXPECT_TRUE(std::ranges::any_of(rows, [](const store::LedgerRow& row) {
    return row.note.find("olga resumes as if DC1 had come: the DC1 was lost") != std::string::npos;
  }));
  EXPECT_EQ(std::ranges::count(shop_.audited(job.id), "job.resume-as-if-dc1: the DC1 was lost"), 1);
  shop_.run(2s);
  EXPECT_EQ(shop_.written(kLathe), text_);
}

TEST_F(JobsTest, CancelEndsAJobInAnyState) {
  const store::Job queued = shop_.add_job(kLathe, text_);
  EXPECT_EQ(must(shop_.jobs.cancel(queued.id, "olga")).state, JobState::cancelled);
  EXPECT_EQ(refusal(shop_.jobs.cancel(queued.id, "olga")).code, ErrorCode::refused);
  EXPECT_EQ(refusal(shop_.jobs.arm(queued.id, std::nullopt, "olga")).code, ErrorCode::refused);

  const store::Job armed = must(shop_.jobs.add(queued.release, "anna"));
  must(shop_.jobs.arm(armed.id, std::nullopt, "olga"));
  EXPECT_EQ(must(shop_.jobs.cancel(armed.id, "olga")).state, JobState::cancelled);
  EXPECT_FALSE(sends_on_dc1());

  const store::Job fed = must(shop_.jobs.add(queued.release, "anna"));
  must(shop_.jobs.arm(fed.id, std::nullopt, "olga"));
  shop_.links.receive(url_of(kLathe), kDc1);
  shop_.run(50ms);
  must(shop_.jobs.cancel(fed.id, "olga"));
  shop_.run(5s);
  EXPECT_EQ(shop_.state(fed.id), JobState::cancelled);
  EXPECT_FALSE(shop_.job(fed.id).torn);
  EXPECT_EQ(shop_.written(kLathe).back(), '\n');
  EXPECT_EQ(shop_.written(kLathe).find('%', 1), std::string::npos);
  EXPECT_FALSE(sends_on_dc1());
}

// The row still says armed when the first bytes have gone out.
TEST_F(JobsTest, CancelReachesAJobThatTheControlHasJustAskedFor) {
  const store::Job job = shop_.add_job(kLathe, text_);
  for (int i = 0; i < 20; ++i) {
    const store::Job asked = must(shop_.jobs.add(job.release, "anna"));
    must(shop_.jobs.arm(asked.id, std::nullopt, "olga"));
    shop_.links.receive(url_of(kLathe), kDc1);
    must(shop_.jobs.cancel(asked.id, "olga"));
    shop_.run(1s);
    EXPECT_EQ(shop_.state(asked.id), JobState::cancelled);
    EXPECT_FALSE(shop_.job(asked.id).torn);
  }
}

TEST_F(JobsTest, CommandsForAJobThatIsNotOnTheLineAreRefused) {
  const store::Job job = shop_.add_job(kLathe, text_);
  const Error error = refusal(shop_.jobs.stop(job.id, "olga"));
  EXPECT_EQ(error.code, ErrorCode::refused);
  EXPECT_NE(error.text.find("is not on the line"), std::string::npos) << error.text;
  EXPECT_FALSE(shop_.jobs.resume(job.id, "go", "olga"));
}

TEST_F(JobsTest, ATornBlockLocksTheLineUntilAPersonConfirms) {
  EXPECT_EQ(refusal(shop_.jobs.confirm_reset(kLathe, "why not", "olga")).code, ErrorCode::not_found) << "nothing waits";
  const store::Job job = feed_into_a_block();
  shop_.links.receive(url_of(kLathe), kSyn);
  shop_.round();
  ASSERT_EQ(shop_.state(job.id), JobState::failed);
  ASSERT_TRUE(shop_.job(job.id).torn);
  const std::string torn = shop_.written(kLathe);
  const store::Job next = must(shop_.jobs.add(job.release, "anna"));
  EXPECT_EQ(refusal(shop_.jobs.arm(next.id, std::nullopt, "olga")).code, ErrorCode::refused);
  EXPECT_FALSE(shop_.jobs.resume(job.id, "go on", "olga"));
  EXPECT_FALSE(sends_on_dc1());
  EXPECT_EQ(refusal(shop_.jobs.confirm_reset(kLathe, "", "olga")).code, ErrorCode::invalid);
  EXPECT_EQ(refusal(shop_.jobs.confirm_reset("mill", "reset", "olga")).code, ErrorCode::not_found);
  EXPECT_EQ(shop_.report(kLathe).state, LineState::torn);
  EXPECT_EQ(shop_.written(kLathe), torn);

  const store::Job confirmed = must(shop_.jobs.confirm_reset(kLathe, "RESET pressed, tool free", "olga"));
  EXPECT_EQ(confirmed.id, job.id);
  EXPECT_EQ(confirmed.confirmed_by, "olga");
  EXPECT_EQ(shop_.report(kLathe).state, LineState::idle);
  EXPECT_FALSE(sends_on_dc1()) << "the confirmation arms nothing";
  must(shop_.jobs.arm(next.id, std::nullopt, "olga"));
  EXPECT_TRUE(sends_on_dc1());
  EXPECT_EQ(shop_.written(kLathe), torn + text_);
}

// The line is torn before the books know it: what a person sees and what the store says may be a round apart.
TEST_F(JobsTest, ALineThatIsTornIsNotArmedBeforeTheBooksKnowIt) {
  const store::Job job = feed_into_a_block();
  const store::Job next = must(shop_.jobs.add(job.release, "anna"));
  shop_.store.watched_ledger().watch([](auto) { return store::Error{store::ErrorCode::busy, ""}; });
  shop_.links.lose(url_of(kLathe));
  const std::string torn = shop_.written(kLathe);
  EXPECT_FALSE(shop_.jobs.arm(next.id, std::nullopt, "olga"));
  shop_.run(2s);
  EXPECT_FALSE(sends_on_dc1());
  EXPECT_EQ(shop_.written(kLathe), torn);
}

TEST_F(JobsTest, MachinesDoNotKnowOfEachOther) {
  shop_.add_machine("mill");
  const store::Job here = feed_into_a_block();
  const store::Job there = shop_.start_job("mill", "%\n(MILL)\n" + text_.substr(2));
  shop_.links.lose(url_of(kLathe));
  shop_.run(2s);
  EXPECT_EQ(shop_.state(here.id), JobState::failed);
  EXPECT_EQ(shop_.state(there.id), JobState::draining);
  EXPECT_EQ(shop_.written("mill"), "%\n(MILL)\n" + text_.substr(2));
}

}  // namespace
}  // namespace dripfeed::app
