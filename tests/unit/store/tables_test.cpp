// The tables of states, names and errors against what the design says.
#include <set>

#include <gtest/gtest.h>

#include "store/store.h"

namespace dripfeed::store {
namespace {

TEST(JobStates, OnlyTheStepsOfTheDesignAreAllowed) {
  using enum JobState;
  const std::set<std::pair<JobState, JobState>> expected{
      {queued, armed},       {queued, cancelled},     {armed, queued},  {armed, feeding},    {armed, failed},
      {armed, cancelled},    {armed, interrupted},    {feeding, held},  {feeding, draining}, {feeding, failed},
      {feeding, cancelled},  {feeding, interrupted},  {held, feeding},  {held, draining},    {held, failed},
      {held, cancelled},     {held, interrupted},     {draining, held}, {draining, done},    {draining, failed},
      {draining, cancelled}, {draining, interrupted},
  };
  for (std::size_t from = 0; from < kJobStates; ++from) {
    for (std::size_t to = 0; to < kJobStates; ++to) {
      const std::pair pair{static_cast<JobState>(from), static_cast<JobState>(to)};
      EXPECT_EQ(allowed(pair.first, pair.second), expected.contains(pair))
          << name_of(pair.first) << " to " << name_of(pair.second);
    }
  }
  EXPECT_EQ(job_transitions().size(), expected.size());
}

TEST(JobStates, NothingFollowsTheEnd) {
  for (std::size_t i = 0; i < kJobStates; ++i) {
    const auto state = static_cast<JobState>(i);
    EXPECT_FALSE(ended(state) && has_line(state)) << name_of(state);
    for (const JobTransition& transition : job_transitions()) {
      EXPECT_FALSE(ended(state) && transition.from == state) << name_of(state);
    }
  }
}

TEST(ReleaseStates, NothingReachesTheControlWithoutAVerdict) {
  for (const ReleaseTransition& transition : release_transitions()) {
    const bool towards = transition.to == ReleaseState::proving || transition.to == ReleaseState::approved;
    EXPECT_TRUE(transition.needs_verdict || !towards);
    EXPECT_EQ(transition.needs_sign_off, transition.to == ReleaseState::approved);
    EXPECT_EQ(transition.needs_transfers, transition.to == ReleaseState::proving);
    EXPECT_NE(transition.from, ReleaseState::obsolete);
    EXPECT_FALSE(transition.to == ReleaseState::approved && transition.from != ReleaseState::proving);
  }
}

TEST(Verdicts, FailIsNeverClearedWarnAndUnknownOnlyByAWaiver) {
  Verdict verdict;
  const auto with = [&](Outcome outcome) {
    verdict.of.outcome = outcome;
    return clears(verdict, 10);
  };
  EXPECT_TRUE(with(Outcome::pass));
  EXPECT_FALSE(with(Outcome::warn));
  EXPECT_FALSE(with(Outcome::unknown));
  EXPECT_FALSE(with(Outcome::fail));
  verdict.waivers.push_back({"anna", "measured by hand", 1, {}, 10});
  EXPECT_FALSE(with(Outcome::warn)) << "it has ended";
  verdict.waivers.push_back({"anna", "measured by hand", 1});
  EXPECT_TRUE(with(Outcome::warn));
  EXPECT_TRUE(with(Outcome::unknown));
  EXPECT_FALSE(with(Outcome::fail));
}

TEST(Verdicts, APointWithoutAWaiverKeepsItFromClearing) {
  Verdict verdict;
  verdict.of.outcome = Outcome::unknown;
  verdict.waivers.push_back({"anna", "known", 1, "a"});
  EXPECT_FALSE(clears(verdict, 10)) << "without points it is waived as a whole";
  verdict.of.points = {"a", "b"};
  EXPECT_FALSE(clears(verdict, 10));
  verdict.waivers.push_back({"bert", "known", 1, "b"});
  EXPECT_TRUE(clears(verdict, 10));
  verdict.of.outcome = Outcome::fail;
  EXPECT_FALSE(clears(verdict, 10));
}

TEST(Names, GoInBothDirections) {
  EXPECT_EQ(name_of(JobState::interrupted), "interrupted");
  EXPECT_EQ(named<JobState>("held"), JobState::held);
  EXPECT_EQ(named<Role>("operator"), Role::operator_);
  EXPECT_EQ(named<Role>("Operator"), std::nullopt);
  EXPECT_EQ(named<Delivery>(""), std::nullopt);
  EXPECT_EQ(kNames<JobState>.size(), kJobStates);
}

TEST(Errors, EachHasItsOwnNameAndSentence) {
  std::set<std::string_view> names;
  std::set<std::string_view> texts;
  const auto last = static_cast<std::size_t>(ErrorCode::internal);
  for (std::size_t i = 0; i <= last; ++i) {
    names.insert(name_of(static_cast<ErrorCode>(i)));
    texts.insert(text_of(static_cast<ErrorCode>(i)));
  }
  EXPECT_EQ(names.size(), last + 1);
  EXPECT_EQ(texts.size(), last + 1);
  EXPECT_EQ(message_of({ErrorCode::disk_full, ""}), "the disk is full");
  EXPECT_EQ(message_of({ErrorCode::disk_full, "here"}), "the disk is full (here)");
}

}  // namespace
}  // namespace dripfeed::store
