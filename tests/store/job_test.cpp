// Jobs: every pair of states, the line that feeds one job, torn blocks, proving, and the start after a crash.
#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class JobTest : public StoreTest {
 protected:
  Result<Job> move(Id job, JobState to, bool torn = false) {
    return store_->jobs().move(job, {to, "because", torn}, by("olga", 77));
  }
  Job next_job(const Job& job) { return must(store_->jobs().add({job.release, job.link, 100}, by("anna"))); }
};

TEST_F(JobTest, RoundTrip) {
  const Job made = add_job(*store_, "mill-1");
  EXPECT_EQ(made.state, JobState::queued);
  must(store_->jobs().move(made.id, {JobState::armed, "shift 2", false, 620}, by("olga", 20)));
  EXPECT_EQ(must(store_->jobs().get(made.id)).expires_at_ms, 620);
  must(store_->jobs().move(made.id, {JobState::feeding, "DC1", false}, by("line", 30)));
  must(store_->jobs().move(made.id, {JobState::held, "DC3", false}, by("line", 31)));
  must(store_->jobs().move(made.id, {JobState::feeding, "DC1", false}, by("line", 32)));
  must(store_->jobs().move(made.id, {JobState::draining, "", false}, by("line", 40)));
  must(store_->jobs().move(made.id, {JobState::done, "DC3", false}, by("line", 50)));
  reopen();
  const Job job = must(store_->jobs().get(made.id));
  EXPECT_EQ(job.state, JobState::done);
  EXPECT_EQ(job.machine, "mill-1");
  EXPECT_EQ(job.link, "serial:/dev/ttyS0");
  EXPECT_EQ(job.bytes_total, 100U);
  EXPECT_EQ(job.revision, 1U);
  EXPECT_EQ(job.armed_by, "olga");
  EXPECT_EQ(job.armed_at_ms, 20);
  EXPECT_EQ(job.expires_at_ms, 0) << "only while it is armed";
  EXPECT_EQ(job.started_at_ms, 30) << "the first time it fed";
  EXPECT_EQ(job.ended_at_ms, 50);
  EXPECT_EQ(job.reason, "DC3");
  EXPECT_EQ(job.created_by, "tester");
  EXPECT_FALSE(job.torn);
}

TEST_F(JobTest, QueuedJobsHaveAnOrderThatPeopleChange) {
  const Job a = add_job(*store_, "mill-1");
  const Job b = next_job(a);
  const Job c = next_job(a);
  const Job other = add_job(*store_, "mill-2");
  const auto order = [&] {
    std::vector<Job> jobs = must(store_->jobs().list({}, {.machine = "mill-1", .state = JobState::queued})).items;
    std::ranges::sort(jobs, {}, [](const Job& job) { return std::pair(job.rank, job.id); });
    std::vector<Id> ids;
    for (const Job& job : jobs) ids.push_back(job.id);
    return ids;
  };
  EXPECT_EQ(order(), (std::vector<Id>{a.id, b.id, c.id}));
  const auto changed = must(store_->jobs().move_before(c.id, b.id, by("olga")));
  ASSERT_EQ(changed.size(), 2U);
  EXPECT_EQ(changed[0].id, c.id);
  EXPECT_EQ(changed[1].id, b.id);
  EXPECT_EQ(order(), (std::vector<Id>{a.id, c.id, b.id}));
  must(store_->jobs().move_before(a.id, 0, by("olga")));
  EXPECT_EQ(order(), (std::vector<Id>{c.id, b.id, a.id}));
  EXPECT_TRUE(must(store_->jobs().move_before(a.id, 0, by("olga"))).empty()) << "it is there";
  const Job d = next_job(a);
  EXPECT_EQ(order(), (std::vector<Id>{c.id, b.id, a.id, d.id})) << "a new one is the last";
  must(move(b.id, JobState::armed));
  EXPECT_EQ(order(), (std::vector<Id>{c.id, a.id, d.id}));
  EXPECT_EQ(refusal(store_->jobs().move_before(b.id, 0, by("olga"))), ErrorCode::refused_transition);
  EXPECT_EQ(refusal(store_->jobs().move_before(99, 0, by("olga"))), ErrorCode::not_found);
  for (const Id wrong : {b.id, c.id, other.id, Id{99}})
    EXPECT_EQ(refusal(store_->jobs().move_before(c.id, wrong, by("olga"))), ErrorCode::invalid_value) << wrong;
  must(move(b.id, JobState::queued));
  EXPECT_EQ(order(), (std::vector<Id>{c.id, b.id, a.id, d.id})) << "a disarmed one keeps its place";
  EXPECT_EQ(must(store_->jobs().get(other.id)).rank, 1U);
  std::vector<std::string> audited;
  for (const AuditRow& row : must(store_->audit().list({}, {.subject = "job/" + std::to_string(a.id)})).items)
    if (row.entry.action == "job.reorder") audited.push_back(row.by.actor + ": " + row.entry.detail);
  EXPECT_EQ(audited, (std::vector<std::string>{"olga: to the end"}));
}

TEST_F(JobTest, WhatWasUsedInATime) {
  const Job model = add_job(*store_, "mill-1");
  const auto run = [&](std::int64_t from_ms, std::int64_t to_ms) {
    const Job job = must(store_->jobs().add({model.release, model.link, 100}, by("anna", from_ms)));
    must(store_->jobs().move(job.id, {JobState::armed, "", false, 620}, by("olga", from_ms)));
    must(store_->jobs().move(job.id, {JobState::feeding, "", false}, by("line", from_ms)));
    const NewLedgerRow row{job.id, {90, 80, 0, 96}, ""};
    must(store_->ledger().append(std::span(&row, 1), from_ms + 1));
    if (to_ms == 0) return job.id;
    must(store_->jobs().move(
        job.id, {.to = JobState::failed, .reason = "nak: between 1 and 2", .reason_id = "nak", .held_ms = 7},
        by("line", to_ms)));
    return job.id;
  };
  const Id before = run(2000, 3000);
  const Id across = run(3500, 4500);
  const Id after = run(6000, 7000);
  const Id on = run(7500, 0);
  const auto ids = [&](std::int64_t from_ms, std::int64_t to_ms) {
    std::vector<Id> found;
    for (const JobUse& use : must(store_->jobs().used("mill-1", from_ms, to_ms))) found.push_back(use.job.id);
    return found;
  };
  EXPECT_EQ(ids(4000, 5000), (std::vector<Id>{across}));
  EXPECT_EQ(ids(0, 9000), (std::vector<Id>{before, across, after, on}));
  EXPECT_EQ(ids(8000, 9000), (std::vector<Id>{on}));
  EXPECT_TRUE(must(store_->jobs().used("mill-2", 0, 9000)).empty());
  const JobUse use = must(store_->jobs().used("mill-1", 4000, 5000)).at(0);
  EXPECT_EQ(use.clocked, 80U);
  EXPECT_EQ(use.ledger_at_ms, 3501);
  EXPECT_EQ(use.job.held_ms, 7);
  EXPECT_EQ(use.job.reason_id, "nak");
  EXPECT_EQ(must(store_->jobs().get(on)).held_ms, std::nullopt);
}

TEST_F(JobTest, EveryOtherStepIsRefused) {
  const Job model = add_job(*store_, "mill-1");
  for (std::size_t from = 0; from < kJobStates; ++from) {
    for (std::size_t to = 0; to < kJobStates; ++to) {
      const Job job = next_job(model);
      const auto start = static_cast<JobState>(from);
      const auto target = static_cast<JobState>(to);
      bring(*store_, job.id, start);
      const auto moved = move(job.id, target);
      if (allowed(start, target)) {
        EXPECT_TRUE(moved) << name_of(start) << " to " << name_of(target);
      } else {
        EXPECT_EQ(refusal(moved), ErrorCode::refused_transition) << name_of(start) << " to " << name_of(target);
        EXPECT_EQ(must(store_->jobs().get(job.id)).state, start);
      }
      if (has_line(must(store_->jobs().get(job.id)).state)) must(move(job.id, JobState::failed));
    }
  }
}

TEST_F(JobTest, ALineFeedsOneJob) {
  const Job first = add_job(*store_, "mill-1");
  const Job second = next_job(first);
  const Job elsewhere = add_job(*store_, "mill-2");
  EXPECT_EQ(must(store_->jobs().on_line("mill-1")), std::nullopt);
  must(move(first.id, JobState::armed));
  EXPECT_EQ(must(store_->jobs().on_line("mill-1"))->id, first.id);
  for (const JobState state : {JobState::armed, JobState::feeding, JobState::held, JobState::draining}) {
    if (state != JobState::armed) must(move(first.id, state));
    EXPECT_EQ(refusal(move(second.id, JobState::armed)), ErrorCode::machine_busy) << name_of(state);
  }
  must(move(elsewhere.id, JobState::armed));
  must(move(first.id, JobState::done));
  must(move(second.id, JobState::armed));
}

TEST_F(JobTest, ATornLineWaitsForAPerson) {
  const Job first = add_job(*store_, "mill-1");
  const Job second = next_job(first);
  bring(*store_, first.id, JobState::feeding);
  const Job failed = must(move(first.id, JobState::failed, true));
  EXPECT_TRUE(failed.needs_confirmation());
  EXPECT_EQ(must(store_->jobs().torn_on("mill-1"))->id, first.id);
  EXPECT_EQ(must(store_->jobs().torn_on("mill-2")), std::nullopt);
  EXPECT_EQ(refusal(move(second.id, JobState::armed)), ErrorCode::machine_torn);
  reopen();
  EXPECT_EQ(refusal(move(second.id, JobState::armed)), ErrorCode::machine_torn);
  EXPECT_EQ(refusal(store_->jobs().confirm_reset("mill-1", "", by("olga"))), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(store_->jobs().confirm_reset("mill-1", "reset", by(""))), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(store_->jobs().confirm_reset("mill-2", "reset", by("olga"))), ErrorCode::not_found);
  const Job confirmed = must(store_->jobs().confirm_reset("mill-1", "pressed RESET", by("olga", 99)));
  EXPECT_EQ(confirmed.id, first.id);
  EXPECT_EQ(confirmed.confirmed_by, "olga");
  EXPECT_EQ(confirmed.confirm_reason, "pressed RESET");
  EXPECT_EQ(confirmed.confirmed_at_ms, 99);
  EXPECT_TRUE(confirmed.torn);
  EXPECT_FALSE(confirmed.needs_confirmation());
  EXPECT_EQ(refusal(store_->jobs().confirm_reset("mill-1", "again", by("olga"))), ErrorCode::not_found);
  must(move(second.id, JobState::armed));
}

TEST_F(JobTest, OnlyABrokenJobIsTorn) {
  const Job job = add_job(*store_, "mill-1");
  EXPECT_EQ(refusal(move(job.id, JobState::armed, true)), ErrorCode::invalid_value);
  bring(*store_, job.id, JobState::draining);
  EXPECT_EQ(refusal(move(job.id, JobState::done, true)), ErrorCode::invalid_value);
  must(move(job.id, JobState::cancelled, true));
}

TEST_F(JobTest, OnlyAReleasedTextGetsAJob) {
  const Job model = add_job(*store_, "mill-1");
  const Job queued = next_job(model);
  EXPECT_EQ(refusal(store_->jobs().add({99, "link", 1}, by("anna"))), ErrorCode::broken_reference);
  must(store_->releases().move(model.release, {ReleaseState::obsolete, "", 0}, by("anna")));
  EXPECT_EQ(refusal(store_->jobs().add({model.release, "link", 1}, by("anna"))), ErrorCode::not_released);
  EXPECT_EQ(refusal(move(queued.id, JobState::armed)), ErrorCode::not_released) << "the release went meanwhile";
  must(move(queued.id, JobState::cancelled));
}

TEST_F(JobTest, AFailedCheckStopsAQueuedJob) {
  const Job job = add_job(*store_, "mill-1");
  add_verdict(*store_, must(store_->programs().get(job.program)), "mill-1", Outcome::fail);
  EXPECT_EQ(refusal(move(job.id, JobState::armed)), ErrorCode::verdict_not_passed);
}

TEST_F(JobTest, ProvingHasSoManyTransfers) {
  must(store_->machines().add("mill-1", "profile", by("anna")));
  const Program program = add_program(*store_, "text");
  add_verdict(*store_, program, "mill-1");
  const Release release = must(store_->releases().add({program.id, 1, "mill-1", Delivery::drip}, by("anna")));
  must(store_->releases().move(release.id, {ReleaseState::in_review, "", 0}, by("anna")));
  must(store_->releases().move(release.id, {ReleaseState::proving, "", 2}, by("anna")));
  const auto add = [&] { return store_->jobs().add({release.id, "link", 1}, by("anna")); };
  const auto done = [&] { return must(store_->releases().get(release.id)).transfers_done; };

  const Job disarmed = must(add());
  must(move(disarmed.id, JobState::armed));
  must(move(disarmed.id, JobState::queued));
  EXPECT_EQ(done(), 0U) << "nothing of it was sent";
  bring(*store_, disarmed.id, JobState::held);
  must(move(disarmed.id, JobState::feeding));
  EXPECT_EQ(done(), 1U) << "a hold is no second transfer";
  must(move(disarmed.id, JobState::cancelled));
  const Job second = must(add());
  const Job third = must(add());
  bring(*store_, second.id, JobState::done);
  EXPECT_EQ(done(), 2U);
  EXPECT_EQ(refusal(move(third.id, JobState::armed)), ErrorCode::transfers_used_up);
  EXPECT_EQ(refusal(add()), ErrorCode::transfers_used_up);
  must(store_->releases().sign_off(release.id, "good", by("olga")));
  must(store_->releases().move(release.id, {ReleaseState::approved, "good", 0}, by("anna")));
  bring(*store_, third.id, JobState::done);
  EXPECT_EQ(done(), 2U) << "an approved text is not counted";
}

TEST_F(JobTest, ListsByMachineAndState) {
  const Job first = add_job(*store_, "mill-1");
  const Job second = next_job(first);
  add_job(*store_, "mill-2");
  bring(*store_, first.id, JobState::done);
  const auto ids = [&](const JobFilter& filter) {
    std::vector<Id> found;
    for (const Job& job : must(store_->jobs().list({}, filter)).items) found.push_back(job.id);
    return found;
  };
  EXPECT_EQ(ids({.machine = "mill-1", .state = {}}), (std::vector<Id>{second.id, first.id}));
  EXPECT_EQ(ids({.machine = {}, .state = JobState::done}), std::vector<Id>{first.id});
  EXPECT_EQ(ids({.machine = "mill-2", .state = JobState::done}), std::vector<Id>{});
  EXPECT_EQ(ids({}).size(), 3U);
  EXPECT_EQ(refusal(store_->jobs().get(99)), ErrorCode::not_found);
  EXPECT_EQ(refusal(move(99, JobState::armed)), ErrorCode::not_found);
}

TEST_F(JobTest, AStartInterruptsWhatRan) {
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < kJobStates; ++i) {
    jobs.push_back(add_job(*store_, fmt::format("mill-{}", i)));
    bring(*store_, jobs.back().id, static_cast<JobState>(i));
  }
  // Armed with a window reserved: it may have begun after the last commit.
  const Job reserved = add_job(*store_, "mill-reserved");
  must(move(reserved.id, JobState::armed));
  const std::array rows{NewLedgerRow{reserved.id, {0, 0, 0, 64}, ""}};
  EXPECT_TRUE(must(store_->ledger().append(rows, 5)).empty());

  reopen();
  const auto interrupted = must(store_->jobs().interrupt_unfinished(by("server", 500)));
  std::vector<Id> ids;
  for (const Job& job : interrupted) {
    ids.push_back(job.id);
    EXPECT_EQ(job.state, JobState::interrupted);
    EXPECT_EQ(job.ended_at_ms, 500);
    EXPECT_EQ(job.torn, job.machine != "mill-1") << job.machine << ": only the armed one without a window is whole";
    EXPECT_EQ(must(store_->jobs().get(job.id)).torn, job.torn);
  }
  EXPECT_EQ(ids, (std::vector<Id>{jobs[1].id, jobs[2].id, jobs[3].id, jobs[4].id, reserved.id}));
  for (const std::size_t i : {0U, 5U, 6U, 7U, 8U}) {
    EXPECT_EQ(must(store_->jobs().get(jobs[i].id)).state, static_cast<JobState>(i));
  }
  EXPECT_TRUE(must(store_->jobs().interrupt_unfinished(by("server"))).empty());
  const auto audit = must(store_->audit().list({}, {.subject = fmt::format("job/{}", reserved.id)}));
  EXPECT_EQ(audit.items.at(0).by.actor, "server");
  EXPECT_NE(audit.items.at(0).entry.detail.find("armed to interrupted, torn"), std::string::npos);
}

}  // namespace
}  // namespace dripfeed::store_test
