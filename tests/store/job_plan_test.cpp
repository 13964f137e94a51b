// Jobs that are planned, chosen and confirmed, and the sums' rows of those that ended.
#include <vector>

#include <fmt/format.h>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class JobPlanTest : public StoreTest {
 protected:
  Result<Job> arm(Id job, std::int64_t at_ms = 1000, const std::string& early = "") {
    return store_->jobs().move(job, {.to = JobState::armed, .reason = "armed", .early_reason = early},
                               by("olga", at_ms));
  }
  void finish(Id job, std::int64_t from_ms, std::int64_t to_ms, const JobMove& how) {
    must(store_->jobs().move(job, {.to = JobState::feeding}, by("line", from_ms)));
    must(store_->jobs().move(job, {.to = JobState::draining}, by("line", to_ms)));
    must(store_->jobs().move(job, how, by("line", to_ms)));
  }
  Job state_of(Id job) { return must(store_->jobs().get(job)); }
  std::vector<std::string> audited(Id job) {
    std::vector<std::string> actions;
    for (const AuditRow& row : must(store_->audit().list({}, {.subject = fmt::format("job/{}", job)})).items)
      actions.push_back(row.entry.action);
    return actions;
  }
};

TEST_F(JobPlanTest, IsNotArmedBeforeItsTimeWithoutAReason) {
  const Job first = add_job(*store_, "mill-1");
  const Job job = must(store_->jobs().add(
      {.release = first.release, .link = first.link, .bytes_total = 100, .not_before_ms = 5000}, by("anna")));
  EXPECT_EQ(job.not_before_ms, 5000);
  EXPECT_EQ(refusal(arm(job.id, 4999)), ErrorCode::too_early);
  EXPECT_EQ(state_of(job.id).state, JobState::queued);
  EXPECT_EQ(arm(job.id, 4999).error().detail, fmt::format("job {} not before 1970-01-01 00:00:05 UTC", job.id));
  must(store_->jobs().schedule(job.id, 9000, by("anna")));
  reopen();
  EXPECT_EQ(state_of(job.id).not_before_ms, 9000);
  const LoggedEvent logged = must(store_->event_log().after(0, 100)).back();
  EXPECT_EQ(type_of(logged.of), "job.scheduled");
  EXPECT_EQ(logged.of.subject, job.id);
  EXPECT_EQ(logged.of.text, "not before 1970-01-01 00:00:09 UTC");
  EXPECT_EQ(refusal(arm(job.id, 8999)), ErrorCode::too_early);
  EXPECT_EQ(must(arm(job.id, 8999, "the customer waits")).state, JobState::armed);
  EXPECT_EQ(refusal(store_->jobs().schedule(job.id, 0, by("anna"))), ErrorCode::refused_transition);
  EXPECT_EQ(audited(job.id), (std::vector<std::string>{"job.move", "job.arm-early", "job.schedule", "job.add"}));
  must(store_->jobs().move(job.id, {.to = JobState::queued}, by("line")));
  must(store_->jobs().schedule(job.id, 0, by("anna")));
  must(arm(job.id, 1));
  EXPECT_EQ(audited(job.id)[0], "job.move") << "at any time needs no reason";
}

TEST_F(JobPlanTest, OnHoldItIsNotArmedAndKeepsItsPlace) {
  const Job first = add_job(*store_, "mill-1");
  const Job second =
      must(store_->jobs().add({.release = first.release, .link = first.link, .bytes_total = 100}, by("anna")));
  EXPECT_EQ(refusal(store_->jobs().end_hold(first.id, by("anna"))), ErrorCode::refused_transition);
  EXPECT_EQ(refusal(store_->jobs().hold(first.id, "", by("anna"))), ErrorCode::invalid_value);
  must(store_->jobs().hold(first.id, "no material", by("anna")));
  reopen();
  EXPECT_EQ(state_of(first.id).hold_by, "anna");
  EXPECT_EQ(state_of(first.id).hold_reason, "no material");
  EXPECT_EQ(state_of(first.id).rank, first.rank);
  EXPECT_EQ(refusal(store_->jobs().hold(first.id, "twice", by("anna"))), ErrorCode::refused_transition);
  EXPECT_EQ(refusal(arm(first.id)), ErrorCode::on_hold);
  EXPECT_EQ(arm(first.id).error().detail, fmt::format("job {}, by anna: no material", first.id));
  EXPECT_EQ(refusal(arm(first.id, 1000, "early")), ErrorCode::on_hold) << "no reason arms what is on hold";
  must(arm(second.id));
  must(store_->jobs().move(second.id, {.to = JobState::cancelled}, by("anna")));
  EXPECT_EQ(must(store_->jobs().end_hold(first.id, by("olga"))).hold_by, "");
  must(arm(first.id));
  EXPECT_EQ(refusal(store_->jobs().hold(first.id, "now", by("anna"))), ErrorCode::refused_transition);
  EXPECT_EQ(audited(first.id), (std::vector<std::string>{"job.move", "job.end-hold", "job.hold", "job.add"}));
  std::vector<std::string> types;
  for (const LoggedEvent& event : must(store_->event_log().after(0, 100)))
    if (event.of.topic == EventTopic::job && event.of.subject == first.id) types.push_back(type_of(event.of));
  EXPECT_EQ(types, (std::vector<std::string>{"job.queued", "job.on_hold", "job.off_hold", "job.armed"}));
}

TEST_F(JobPlanTest, WhatEndedIsQueuedAgain) {
  const Job job = add_job(*store_, "mill-1");
  const Job other = add_job(*store_, "mill-2");
  const auto again = [&](Id release, Id of) {
    return store_->jobs().add({.release = release, .link = job.link, .bytes_total = 100, .retry_of = of}, by("anna"));
  };
  EXPECT_EQ(refusal(again(job.release, job.id)), ErrorCode::refused_transition) << "it is queued";
  bring(*store_, job.id, JobState::failed);
  EXPECT_EQ(refusal(again(other.release, job.id)), ErrorCode::refused_transition) << "it is of another release";
  EXPECT_EQ(refusal(again(job.release, 9999)), ErrorCode::not_found);
  const Job retry = must(again(job.release, job.id));
  reopen();
  EXPECT_EQ(state_of(retry.id).retry_of, job.id);
  EXPECT_EQ(state_of(retry.id).state, JobState::queued);
  EXPECT_EQ(state_of(job.id).state, JobState::failed);
}

TEST_F(JobPlanTest, OfAChoiceOneIsArmedAndTheOthersLeave) {
  const Job one = add_job(*store_, "mill-1");
  const Job two = add_job(*store_, "mill-2");
  const Order order =
      must(store_->orders().add({.number = "A-1", .plan = {.part = "R-100", .quantity = 5}}, by("anna")));
  const auto choose = [&](const Job& like, Id choice) {
    return must(store_->jobs().add({.release = like.release,
                                    .link = like.link,
                                    .bytes_total = 100,
                                    .order = order.id,
                                    .choice = choice,
                                    .begins_choice = choice == 0},
                                   by("anna")));
  };
  const Job a = choose(one, 0);
  const Job b = choose(two, a.id);
  const Job c = choose(two, a.id);
  const Job apart = choose(one, 0);
  EXPECT_EQ(a.choice, a.id);
  EXPECT_EQ(b.choice, a.id);
  EXPECT_EQ(must(store_->jobs().list({}, {.choice = a.id})).items.size(), 3U);
  EXPECT_EQ(must(store_->orders().get(order.id)).waiting, 2U) << "a choice counts once";
  must(store_->jobs().move(c.id, {.to = JobState::cancelled, .reason = "cancelled"}, by("anna")));
  EXPECT_EQ(state_of(a.id).state, JobState::queued) << "to cancel one leaves the others";
  const std::uint64_t rows = must(store_->audit().list({.limit = 1000}, {})).items.size();
  must(arm(b.id));
  const Job gone = state_of(a.id);
  EXPECT_EQ(gone.state, JobState::cancelled);
  EXPECT_EQ(gone.reason, fmt::format("withdrawn: job {} of the same choice was armed on mill-2", b.id));
  EXPECT_EQ(gone.reason_id, "withdrawn");
  EXPECT_EQ(state_of(c.id).reason, "cancelled") << "it had left before";
  EXPECT_EQ(state_of(apart.id).state, JobState::queued);
  EXPECT_EQ(must(store_->audit().list({.limit = 1000}, {})).items.size(), rows + 2)
      << "one row for each of the two moves";
  EXPECT_EQ(must(store_->orders().get(order.id)).waiting, 1U);
}

TEST_F(JobPlanTest, ARefusedArmingLeavesTheChoice) {
  const Job one = add_job(*store_, "mill-1");
  must(arm(one.id));
  const Job two = add_job(*store_, "mill-2");
  const Job a = must(store_->jobs().add(
      {.release = one.release, .link = one.link, .bytes_total = 1, .begins_choice = true}, by("anna")));
  const Job b = must(
      store_->jobs().add({.release = two.release, .link = two.link, .bytes_total = 1, .choice = a.id}, by("anna")));
  EXPECT_EQ(refusal(arm(a.id)), ErrorCode::machine_busy);
  EXPECT_EQ(state_of(b.id).state, JobState::queued);
}

TEST_F(JobPlanTest, TheNextJobWaitsForTheConfirmationOfAnEnd) {
  const Job first = add_job(*store_, "mill-1");
  const auto add = [&](const std::string& check) {
    return must(store_->jobs().add({.release = first.release, .link = first.link, .bytes_total = 1, .end_check = check},
                                   by("anna")));
  };
  const Job job = add("part taken out");
  const Job next = add("");
  EXPECT_EQ(refusal(store_->jobs().confirm_end(job.id, "", by("olga"))), ErrorCode::refused_transition);
  must(arm(job.id));
  must(store_->jobs().move(job.id, {.to = JobState::queued}, by("line")));
  EXPECT_EQ(must(store_->jobs().end_waits_on("mill-1")), std::nullopt) << "nothing of it was sent";
  must(arm(job.id));
  finish(job.id, 2000, 3000, {.to = JobState::done});
  reopen();
  EXPECT_EQ(must(store_->jobs().end_waits_on("mill-1"))->id, job.id);
  EXPECT_TRUE(state_of(job.id).needs_end_confirmation());
  const auto refused = arm(next.id);
  EXPECT_EQ(refusal(refused), ErrorCode::end_not_confirmed);
  EXPECT_EQ(refused.error().detail, fmt::format("job {} on mill-1: part taken out", job.id));
  const Job confirmed = must(store_->jobs().confirm_end(job.id, "on the table", by("olga", 4000)));
  EXPECT_EQ(confirmed.end_confirmed_by, "olga");
  EXPECT_EQ(confirmed.end_note, "on the table");
  EXPECT_EQ(confirmed.end_confirmed_at_ms, 4000);
  EXPECT_EQ(refusal(store_->jobs().confirm_end(job.id, "", by("eve"))), ErrorCode::refused_transition);
  EXPECT_EQ(audited(job.id)[0], "job.confirm-end");
  must(arm(next.id));
  EXPECT_NE(sql(fmt::format("UPDATE job SET end_confirmed_by = 'eve' WHERE id = {}", job.id)), "");
  EXPECT_NE(sql(fmt::format("UPDATE job SET end_check = '' WHERE id = {}", job.id)), "");
}

TEST_F(JobPlanTest, EndsAreGivenInTheirOrderWithWhatTheLineDid) {
  const Job first = add_job(*store_, "mill-1");
  const Order order =
      must(store_->orders().add({.number = "A-1", .plan = {.part = "R-100", .quantity = 5}}, by("anna")));
  const auto run = [&](Id job, std::int64_t to_ms, const JobMove& how) {
    must(store_->jobs().move(job, {.to = JobState::armed, .forecast_ms = 700}, by("olga", to_ms - 500)));
    finish(job, to_ms - 400, to_ms, how);
  };
  const Job second = must(store_->jobs().add(
      {.release = first.release, .link = first.link, .bytes_total = 60, .order = order.id}, by("anna")));
  run(first.id, 5000, {.to = JobState::done, .held_ms = 7, .holds = 2, .line_ms = 300});
  run(second.id, 6000, {.to = JobState::failed, .reason = "x"});
  must(store_->orders().change(order.id, 1, {.part = "R-9", .quantity = 5}, by("anna")));
  const Job third = must(store_->jobs().add({.release = first.release, .link = "", .bytes_total = 1}, by("anna")));
  must(store_->jobs().move(third.id, {.to = JobState::cancelled}, by("anna", 7000)));
  const auto ended = [&](const EndedFilter& filter) {
    std::vector<std::string> rows;
    must(store_->jobs().each_ended(filter, [&](const EndedJob& job) {
      rows.push_back(fmt::format("{} {} {} {} {}-{} {} {} {} {}", job.machine, job.part, name_of(job.state),
                                 job.bytes_total, job.started_at_ms, job.ended_at_ms, job.held_ms.value_or(-1),
                                 job.holds ? static_cast<std::int64_t>(*job.holds) : -1, job.line_ms.value_or(-1),
                                 job.forecast_ms.value_or(-1)));
    }));
    return rows;
  };
  const std::string a = "mill-1 R-100 done 100 4600-5000 7 2 300 700";
  const std::string b = "mill-1 R-9 failed 60 5600-6000 -1 -1 -1 700";
  const std::string c = "mill-1 R-100 cancelled 1 0-7000 -1 -1 -1 -1";
  EXPECT_EQ(ended({.from_ms = 0, .to_ms = 9000}), (std::vector<std::string>{a, b, c}));
  EXPECT_EQ(ended({.from_ms = 5000, .to_ms = 6000}), (std::vector<std::string>{a}));
  EXPECT_EQ(ended({.from_ms = 0, .to_ms = 9000, .state = JobState::failed}), (std::vector<std::string>{b}));
  EXPECT_TRUE(ended({.from_ms = 0, .to_ms = 9000, .machine = "mill-2"}).empty());
  EXPECT_EQ(state_of(first.id).holds, 2U);
  EXPECT_EQ(state_of(first.id).line_ms, 300);
}

}  // namespace
}  // namespace dripfeed::store_test
