// Verdicts and releases: what clears a text, what makes a verdict stale, every step of a release.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class ReleaseTest : public StoreTest {
 protected:
  ReleaseTest() {
    must(store_->machines().add("mill-1", "profile", by("anna")));
    program_ = add_rendered(*store_, "%\nM30\n%\n", "mill-1");
  }
  Release make_draft() {
    return must(store_->releases().add({program_.id, 1, "mill-1", Delivery::drip}, by("anna", 50)));
  }
  Result<Release> move(const Release& release, ReleaseState to, std::string note = "note",
                       std::uint64_t transfers = 2) {
    return store_->releases().move(release.id, {to, std::move(note), transfers}, by("bert", 60));
  }
  Result<Clearance> cleared() {
    return store_->releases().released_for(program_.newest.sha256, "mill-1", Delivery::drip, now_ms_);
  }

  Program program_;
  std::int64_t now_ms_ = 0;
};

TEST_F(ReleaseTest, VerdictRoundTrip) {
  NewVerdict verdict{program_.id, 1, "mill-1", 1, Delivery::memory, Outcome::warn, "a long report"};
  const Verdict made = must(store_->verdicts().add(verdict, by("anna", 5)));
  must(store_->verdicts().waive(made.id, {.reason = "known"}, by("bert", 6)));
  must(store_->verdicts().waive(made.id, {.reason = "known twice"}, by("carl", 7)));
  reopen();
  const Verdict read = must(store_->verdicts().get(made.id));
  EXPECT_EQ(read.of.program, program_.id);
  EXPECT_EQ(read.of.machine, "mill-1");
  EXPECT_EQ(read.of.delivery, Delivery::memory);
  EXPECT_EQ(read.of.outcome, Outcome::warn);
  EXPECT_EQ(read.of.report, "a long report");
  EXPECT_EQ(read.text_sha256, program_.newest.sha256);
  EXPECT_FALSE(read.stale);
  EXPECT_EQ(read.created_at_ms, 5);
  ASSERT_EQ(read.waivers.size(), 2U);
  EXPECT_EQ(read.waivers[1].name, "carl");
  EXPECT_EQ(read.waivers[1].reason, "known twice");
  EXPECT_EQ(must(store_->verdicts().list({})).items.at(0).waivers.size(), 2U);
}

TEST_F(ReleaseTest, VerdictRefusals) {
  NewVerdict verdict{program_.id, 1, "mill-1", 1, Delivery::drip, Outcome::pass, ""};
  verdict.machine_revision = 2;
  EXPECT_EQ(refusal(store_->verdicts().add(verdict, by("anna"))), ErrorCode::broken_reference);
  verdict.machine_revision = 1;
  verdict.revision = 2;
  EXPECT_EQ(refusal(store_->verdicts().add(verdict, by("anna"))), ErrorCode::broken_reference);
  EXPECT_EQ(refusal(store_->verdicts().get(1)), ErrorCode::not_found);
  EXPECT_EQ(refusal(store_->verdicts().waive(1, {.reason = "reason"}, by("anna"))), ErrorCode::not_found);
  const Verdict made = add_verdict(*store_, program_, "mill-1");
  EXPECT_EQ(refusal(store_->verdicts().waive(made.id, {.reason = ""}, by("anna"))), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(store_->verdicts().waive(made.id, {.reason = "reason"}, by(""))), ErrorCode::invalid_value);
}

TEST_F(ReleaseTest, NewestVerdictIsPerTextMachineAndDelivery) {
  must(store_->machines().add("mill-2", "profile", by("anna")));
  add_verdict(*store_, program_, "mill-1", Outcome::fail);
  const Verdict second = add_verdict(*store_, program_, "mill-1", Outcome::pass);
  add_verdict(*store_, program_, "mill-2", Outcome::fail);
  const std::string& text = program_.newest.sha256;
  EXPECT_EQ(must(store_->verdicts().newest(text, "mill-1", Delivery::drip))->id, second.id);
  EXPECT_EQ(must(store_->verdicts().newest(text, "mill-1", Delivery::memory)), std::nullopt);
  // The same text under another name is the same text.
  const Program again = add_program(*store_, "%\nM30\n%\n", "O0999");
  EXPECT_EQ(must(store_->verdicts().newest(again.newest.sha256, "mill-1", Delivery::drip))->id, second.id);
  EXPECT_EQ(must(store_->verdicts().list({}, {.program = 0, .machine = "mill-2"})).items.size(), 1U);
  EXPECT_EQ(must(store_->verdicts().list({}, {.program = program_.id, .machine = {}})).items.size(), 3U);
  EXPECT_EQ(must(store_->verdicts().list({}, {.program = again.id, .machine = {}})).items.size(), 0U);
}

TEST_F(ReleaseTest, ANewFamilyMakesTheVerdictsOfItsTextsStale) {
  const Program uploaded = add_program(*store_, "uploaded");
  const Verdict of_part = add_verdict(*store_, program_, "mill-1");
  const Verdict of_upload = add_verdict(*store_, uploaded, "mill-1");
  must(store_->families().add("ring", "other", by("anna")));
  must(store_->families().change("ring", 1, "other 2", by("anna")));
  EXPECT_FALSE(must(store_->verdicts().get(of_part.id)).stale);
  must(store_->families().change("roll", 1, "roll 2", by("anna")));
  EXPECT_TRUE(must(store_->verdicts().get(of_part.id)).stale);
  EXPECT_FALSE(must(store_->verdicts().get(of_upload.id)).stale);
  EXPECT_FALSE(add_verdict(*store_, program_, "mill-1").stale) << "a new check is fresh";
}

TEST_F(ReleaseTest, ANewMachineProfileMakesItsVerdictsStale) {
  must(store_->machines().add("mill-2", "profile", by("anna")));
  const Verdict first = add_verdict(*store_, program_, "mill-1");
  const Verdict other = add_verdict(*store_, program_, "mill-2");
  must(store_->machines().change("mill-1", 1, "profile 2", by("anna")));
  EXPECT_TRUE(must(store_->verdicts().get(first.id)).stale);
  EXPECT_FALSE(must(store_->verdicts().get(other.id)).stale);
  NewVerdict late{program_.id, 1, "mill-1", 1, Delivery::drip, Outcome::pass, ""};
  EXPECT_TRUE(must(store_->verdicts().add(late, by("anna"))).stale) << "made for a profile that is gone";
}

TEST_F(ReleaseTest, OtherRulesThanThoseOfTheVerdictMakeItStale) {
  const Verdict unstated = add_verdict(*store_, program_, "mill-1");
  EXPECT_EQ(unstated.rules, "");
  EXPECT_FALSE(unstated.stale) << "a program that states no rules compares none";
  store_->verdicts().judge_by("rules 1");
  EXPECT_TRUE(must(store_->verdicts().get(unstated.id)).stale);
  const Verdict first = add_verdict(*store_, program_, "mill-1");
  EXPECT_EQ(first.rules, "rules 1");
  EXPECT_FALSE(first.stale);
  reopen({.own = true});
  store_->verdicts().judge_by("rules 2");
  const Verdict read = must(store_->verdicts().get(first.id));
  EXPECT_EQ(read.rules, "rules 1");
  EXPECT_TRUE(read.stale);
  EXPECT_TRUE(must(store_->verdicts().list({})).items.at(0).stale);
  const Release release =
      must(store_->releases().add({program_.id, program_.newest.revision, "mill-1", Delivery::drip}, by("anna")));
  const ReleaseMove hand_in{ReleaseState::in_review, "", 0};
  EXPECT_EQ(refusal(store_->releases().move(release.id, hand_in, by("anna"))), ErrorCode::verdict_stale);
  EXPECT_FALSE(add_verdict(*store_, program_, "mill-1").stale);
  must(store_->releases().move(release.id, hand_in, by("anna")));
  store_->verdicts().judge_by("rules 3");
  const ReleaseMove prove{ReleaseState::proving, "", 1};
  EXPECT_EQ(refusal(store_->releases().move(release.id, prove, by("bert"))), ErrorCode::verdict_stale);
  EXPECT_EQ(sql("UPDATE verdict SET rules = 'rules 2'"), "append-only");
}

TEST_F(ReleaseTest, ANewTextOfACalledProgramMakesTheVerdictStale) {
  const Program called = add_program(*store_, "called");
  NewVerdict verdict{program_.id, 1, "mill-1", 1, Delivery::drip, Outcome::pass, ""};
  verdict.calls = {{"O9000", called.id, called.newest.revision}};
  const Verdict made = must(store_->verdicts().add(verdict, by("anna")));
  const Verdict other = add_verdict(*store_, program_, "mill-1");
  EXPECT_FALSE(made.stale);
  const Content text = must(store_->contents().put("another"));
  must(store_->programs().add_revision(called.id, 1, {.sha256 = text.sha256}, by("anna")));
  EXPECT_TRUE(must(store_->verdicts().get(made.id)).stale);
  EXPECT_FALSE(must(store_->verdicts().get(other.id)).stale);
}

TEST_F(ReleaseTest, AnOperatorSignsTheProvingOffBeforeItIsApproved) {
  add_verdict(*store_, program_, "mill-1");
  const Release release = make_draft();
  const auto sign_off = [&](std::string_view note) {
    return store_->releases().sign_off(release.id, note, by("olga", 40));
  };
  const auto transfer = [&](JobState to) {
    bring(*store_, must(store_->jobs().add({release.id, "link", 1}, by("olga"))).id, to);
  };
  EXPECT_EQ(refusal(sign_off("good")), ErrorCode::refused_transition) << "it is a draft";
  must(move(release, ReleaseState::in_review));
  EXPECT_EQ(refusal(sign_off("good")), ErrorCode::refused_transition);
  must(move(release, ReleaseState::proving));
  EXPECT_EQ(refusal(sign_off("good")), ErrorCode::not_proved) << "nothing was transferred";
  transfer(JobState::failed);
  EXPECT_EQ(refusal(sign_off("good")), ErrorCode::not_proved) << "it broke off";
  EXPECT_EQ(refusal(move(release, ReleaseState::approved, "measured")), ErrorCode::not_signed_off);
  transfer(JobState::done);
  EXPECT_EQ(refusal(sign_off("")), ErrorCode::sign_off_missing);
  EXPECT_EQ(refusal(move(release, ReleaseState::approved, "measured")), ErrorCode::not_signed_off);
  EXPECT_EQ(must(sign_off("all sizes good")).state, ReleaseState::proving);
  reopen();
  const Release signed_off = must(store_->releases().get(release.id));
  EXPECT_EQ(signed_off.proved_by, "olga");
  EXPECT_EQ(signed_off.proof, "all sizes good");
  EXPECT_EQ(must(store_->releases().list({})).items.front().proof, "all sizes good");
  const Release approved = must(move(release, ReleaseState::approved, "measured"));
  EXPECT_EQ(approved.proved_by, "olga");
  EXPECT_EQ(must(store_->releases().get(release.id)).proved_by, "olga");
  EXPECT_EQ(refusal(sign_off("again")), ErrorCode::refused_transition);
  EXPECT_EQ(must(store_->releases().history(release.id)).size(), 4U) << "the sign-off is a step";
}

TEST_F(ReleaseTest, ASignOffIsOfItsOwnProving) {
  add_verdict(*store_, program_, "mill-1");
  const Release release = make_draft();
  must(move(release, ReleaseState::in_review));
  must(move(release, ReleaseState::proving));
  bring(*store_, must(store_->jobs().add({release.id, "link", 1}, by("olga"))).id, JobState::done);
  must(store_->releases().sign_off(release.id, "good", by("olga")));
  must(move(release, ReleaseState::in_review, "the fixture changed"));
  EXPECT_EQ(must(store_->releases().get(release.id)).proved_by, "");
  must(store_->releases().move(release.id, {ReleaseState::proving, "", 2}, by("bert", 9000)));
  EXPECT_EQ(must(store_->releases().get(release.id)).proved_by, "");
  EXPECT_EQ(refusal(store_->releases().sign_off(release.id, "good", by("olga", 9001))), ErrorCode::not_proved)
      << "the transfer was of the proving before";
  EXPECT_EQ(refusal(move(release, ReleaseState::approved, "measured")), ErrorCode::not_signed_off);
}

TEST_F(ReleaseTest, TheWholePath) {
  waive_operators(*store_, "mill-1");
  const Verdict verdict = add_verdict(*store_, program_, "mill-1");
  const Release release = make_draft();
  EXPECT_EQ(release.state, ReleaseState::draft);
  EXPECT_EQ(release.text_sha256, program_.newest.sha256);
  EXPECT_EQ(refusal(cleared()), ErrorCode::not_released);
  must(move(release, ReleaseState::in_review));
  EXPECT_EQ(refusal(cleared()), ErrorCode::not_released);
  must(move(release, ReleaseState::proving));
  EXPECT_EQ(must(cleared()).release.transfers_allowed, 2U);
  must(move(release, ReleaseState::approved, "measured"));
  reopen();
  const Clearance clearance = must(cleared());
  EXPECT_EQ(clearance.release.state, ReleaseState::approved);
  EXPECT_EQ(clearance.release.approved_by, "bert");
  EXPECT_EQ(clearance.release.sign_off, "measured");
  EXPECT_EQ(clearance.verdict.id, verdict.id);
  EXPECT_EQ(refusal(store_->releases().released_for(program_.newest.sha256, "mill-1", Delivery::memory, 0)),
            ErrorCode::not_released);
  EXPECT_EQ(refusal(store_->releases().released_for(program_.newest.sha256, "mill-2", Delivery::drip, 0)),
            ErrorCode::not_released);
  EXPECT_EQ(refusal(store_->releases().released_for(std::string(64, 'b'), "mill-1", Delivery::drip, 0)),
            ErrorCode::not_released);
  must(move(release, ReleaseState::obsolete));
  EXPECT_EQ(refusal(cleared()), ErrorCode::not_released);
  const auto history = must(store_->releases().history(release.id));
  ASSERT_EQ(history.size(), 4U);
  EXPECT_EQ(history[0].from, ReleaseState::draft);
  EXPECT_EQ(history[3].to, ReleaseState::obsolete);
  EXPECT_EQ(history[2].note, "measured");
  EXPECT_EQ(history[2].actor, "bert");
}

// Each pair of states, from a release that is in the first one.
TEST_F(ReleaseTest, EveryOtherStepIsRefused) {
  using enum ReleaseState;
  const std::array<std::vector<ReleaseState>, 5> steps_to{
      {{}, {in_review}, {in_review, proving}, {in_review, proving, approved}, {obsolete}}};
  waive_operators(*store_, "mill-1");
  add_verdict(*store_, program_, "mill-1");
  for (std::size_t from = 0; from < steps_to.size(); ++from) {
    for (std::size_t to = 0; to < steps_to.size(); ++to) {
      const Release release = make_draft();
      for (const ReleaseState step : steps_to.at(from)) must(move(release, step));
      const auto target = static_cast<ReleaseState>(to);
      bool listed = false;
      for (const ReleaseTransition& transition : release_transitions()) {
        listed = listed || (static_cast<std::size_t>(transition.from) == from && transition.to == target);
      }
      const auto moved = move(release, target);
      if (listed) {
        EXPECT_TRUE(moved) << from << " to " << to;
      } else {
        EXPECT_EQ(refusal(moved), ErrorCode::refused_transition) << from << " to " << to;
        EXPECT_EQ(must(store_->releases().get(release.id)).state, static_cast<ReleaseState>(from));
        EXPECT_EQ(must(store_->releases().history(release.id)).size(), steps_to.at(from).size());
      }
      const auto end = must(store_->releases().get(release.id)).state;
      if (end != obsolete) must(move(release, obsolete));
    }
  }
}

TEST_F(ReleaseTest, TheVerdictGuardsEachStep) {
  waive_operators(*store_, "mill-1");
  const Release release = make_draft();
  EXPECT_EQ(refusal(move(release, ReleaseState::in_review)), ErrorCode::no_verdict);
  add_verdict(*store_, program_, "mill-1", Outcome::fail);
  EXPECT_EQ(refusal(move(release, ReleaseState::in_review)), ErrorCode::verdict_not_passed);
  const Verdict unknown = add_verdict(*store_, program_, "mill-1", Outcome::unknown);
  EXPECT_EQ(refusal(move(release, ReleaseState::in_review)), ErrorCode::verdict_not_passed);
  must(store_->verdicts().waive(unknown.id, {.reason = "the probe is not simulated"}, by("anna")));
  must(move(release, ReleaseState::in_review));
  must(store_->families().change("roll", 1, "roll 2", by("anna")));
  EXPECT_EQ(refusal(move(release, ReleaseState::proving)), ErrorCode::verdict_stale);
  const Verdict warn = add_verdict(*store_, program_, "mill-1", Outcome::warn);
  EXPECT_EQ(refusal(move(release, ReleaseState::proving)), ErrorCode::verdict_not_passed);
  must(store_->verdicts().waive(warn.id, {.reason = "the dwell is meant"}, by("anna")));
  EXPECT_EQ(refusal(move(release, ReleaseState::proving, "", 0)), ErrorCode::invalid_value);
  must(move(release, ReleaseState::proving));
  EXPECT_EQ(refusal(move(release, ReleaseState::approved, "")), ErrorCode::sign_off_missing);
  add_verdict(*store_, program_, "mill-1", Outcome::fail);
  EXPECT_EQ(refusal(move(release, ReleaseState::approved)), ErrorCode::verdict_not_passed);
  EXPECT_EQ(refusal(cleared()), ErrorCode::verdict_not_passed) << "a later failed check takes the clearance back";
}

TEST_F(ReleaseTest, EachPointIsWaivedByItselfAndAWaiverEnds) {
  NewVerdict verdict{program_.id, 1, "mill-1", 1, Delivery::drip, Outcome::warn, ""};
  verdict.points = {"line 3: a dwell", "line 7: a stop"};
  const Verdict made = must(store_->verdicts().add(verdict, by("anna")));
  const auto waive = [&](const NewWaiver& waiver) { return store_->verdicts().waive(made.id, waiver, by("bert", 10)); };
  EXPECT_EQ(refusal(waive({.reason = "known", .point = "line 4: a dwell"})), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(waive({.reason = "known", .point = {}, .expires_at_ms = 10})), ErrorCode::invalid_value);
  const Release release = make_draft();
  must(waive({.reason = "it is meant", .point = "line 3: a dwell"}));
  EXPECT_EQ(refusal(move(release, ReleaseState::in_review)), ErrorCode::verdict_not_passed) << "one of two";
  must(waive({.reason = "for this lot", .point = "line 7: a stop", .expires_at_ms = 100}));
  must(move(release, ReleaseState::in_review));
  must(move(release, ReleaseState::proving));
  reopen();
  const Verdict read = must(store_->verdicts().get(made.id));
  EXPECT_EQ(read.of.points, verdict.points);
  ASSERT_EQ(read.waivers.size(), 2U);
  EXPECT_EQ(read.waivers[1].point, "line 7: a stop");
  EXPECT_EQ(read.waivers[1].expires_at_ms, 100);
  now_ms_ = 99;
  EXPECT_TRUE(cleared());
  now_ms_ = 100;
  const auto over = cleared();
  ASSERT_EQ(refusal(over), ErrorCode::verdict_not_passed) << "what was waived for a time is not for ever";
  EXPECT_NE(over.error().detail.find("a waiver of bert has ended"), std::string::npos) << over.error().detail;
}

TEST_F(ReleaseTest, AStaleVerdictDoesNotTakeAnApprovalBackButIsReported) {
  add_verdict(*store_, program_, "mill-1");
  approve(*store_, program_, "mill-1");
  must(store_->families().change("roll", 1, "roll 2", by("anna")));
  EXPECT_TRUE(must(cleared()).verdict.stale);
}

TEST_F(ReleaseTest, OneValidReleaseAText) {
  add_verdict(*store_, program_, "mill-1");
  const Release first = make_draft();
  EXPECT_EQ(refusal(store_->releases().add(first.of, by("anna"))), ErrorCode::exists);
  NewRelease memory = first.of;
  memory.delivery = Delivery::memory;
  must(store_->releases().add(memory, by("anna")));
  must(move(first, ReleaseState::obsolete));
  must(store_->releases().add(first.of, by("anna")));
  EXPECT_EQ(must(store_->releases().list({.limit = 2, .after = {}})).items.size(), 2U);
  EXPECT_EQ(must(store_->releases().list({}, {.program = program_.id, .machine = "mill-1"})).items.size(), 3U);
  EXPECT_EQ(must(store_->releases().list({}, {.program = 99, .machine = {}})).items.size(), 0U);
  NewRelease nowhere = first.of;
  nowhere.machine = "mill-9";
  EXPECT_EQ(refusal(store_->releases().add(nowhere, by("anna"))), ErrorCode::broken_reference);
  nowhere = first.of;
  nowhere.revision = 9;
  EXPECT_EQ(refusal(store_->releases().add(nowhere, by("anna"))), ErrorCode::broken_reference);
  EXPECT_EQ(refusal(store_->releases().get(99)), ErrorCode::not_found);
  EXPECT_EQ(refusal(store_->releases().history(99)), ErrorCode::not_found);
}

class RestartTest : public ReleaseTest {
 protected:
  RestartTest() {
    add_verdict(*store_, program_, "mill-1");
    of_ = make_draft();
    rest_ = add_program(*store_, "%\nM5\nM30\n%\n", "O2");
    add_verdict(*store_, rest_, "mill-1");
  }
  Result<Release> add_restart() {
    return store_->releases().add(
        {.program = rest_.id, .revision = 1, .machine = "mill-1", .restart = {.release = of_.id, .line = 40}},
        by("anna", 70));
  }
  Result<Release> prove(const Release& restart, std::string sha256, std::uint64_t transfers = 1) {
    return store_->releases().move(
        restart.id,
        {.to = ReleaseState::proving, .note = "read it", .transfers = transfers, .shown_sha256 = std::move(sha256)},
        by("bert", 80));
  }

  Release of_;
  Program rest_;
};

TEST_F(RestartTest, IsOfAReleaseThatMayBeFed) {
  EXPECT_EQ(refusal(add_restart()), ErrorCode::broken_reference) << "of a draft";
  must(move(of_, ReleaseState::in_review));
  must(move(of_, ReleaseState::proving));
  const Release made = must(add_restart());
  reopen();
  const Release read = must(store_->releases().get(made.id));
  EXPECT_EQ(read.of.restart.release, of_.id);
  EXPECT_EQ(read.of.restart.line, 40U);
  EXPECT_EQ(sql("UPDATE text_release SET restart_line = 41 WHERE restart_line = 40"), "append-only");
  EXPECT_NE(sql("UPDATE text_release SET restart_line = 41 WHERE restart_of IS NULL"), "");
}

TEST_F(RestartTest, GoesOnceAndOnlyAsItWasShown) {
  must(move(of_, ReleaseState::in_review));
  must(move(of_, ReleaseState::proving));
  const Release made = must(add_restart());
  must(move(made, ReleaseState::in_review));
  EXPECT_EQ(refusal(prove(made, "")), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(prove(made, of_.text_sha256)), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(prove(made, made.text_sha256, 2)), ErrorCode::invalid_value);
  const Release released = must(prove(made, made.text_sha256));
  EXPECT_EQ(released.approved_by, "bert");
  EXPECT_EQ(refusal(move(made, ReleaseState::approved)), ErrorCode::refused_transition);
  const Job job = must(store_->jobs().add({.release = made.id}, by("olga", 90)));
  EXPECT_EQ(job.restart.release, of_.id);
  EXPECT_EQ(must(store_->jobs().get(job.id)).restart.line, 40U);
  const auto audit = must(store_->audit().list({})).items;
  EXPECT_TRUE(std::ranges::any_of(audit, [](const AuditRow& row) {
    return row.entry.action == "job.add" && row.entry.detail.contains("continues release 1 at line 40");
  }));
}

TEST_F(RestartTest, FourEyesLookAtItBeforeItGoes) {
  must(store_->users().put_group({.name = "mills", .machines = {"mill-1"}, .four_eyes = true}, by("anna")));
  must(move(of_, ReleaseState::in_review));
  must(move(of_, ReleaseState::proving));
  const Release made = must(add_restart());
  must(move(made, ReleaseState::in_review));
  EXPECT_EQ(refusal(store_->releases().move(
                made.id, {.to = ReleaseState::proving, .transfers = 1, .shown_sha256 = made.text_sha256}, by("anna"))),
            ErrorCode::four_eyes);
  must(prove(made, made.text_sha256));
}

}  // namespace
}  // namespace dripfeed::store_test
