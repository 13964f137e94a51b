// The table itself: complete, unambiguous, and never letting bytes out where it must not.
#include "protocol/feed/state.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/feed/state_groups.h"

namespace dripfeed::feed {
namespace {

std::vector<Reaction> rows_of(State state, Input input) {
  std::vector<Reaction> rows;
  for (const Reaction& row : reactions()) {
    if (row.from == state && row.input == input) rows.push_back(row);
  }
  return rows;
}

std::vector<State> states() {
  std::vector<State> all;
  for (std::size_t i = 0; i < kStates; ++i) all.push_back(static_cast<State>(i));
  return all;
}

TEST(StateTable, EveryStateAnswersEveryInputOnce) {
  for (const State state : states()) {
    for (std::size_t i = 0; i < kInputs; ++i) {
      const auto input = static_cast<Input>(i);
      std::set<Guard> guards;
      for (const Reaction& row : rows_of(state, input)) EXPECT_TRUE(guards.insert(row.guard).second);
      const bool complete = guards == std::set{Guard::always} ||
                            guards == std::set{Guard::in_block, Guard::between_blocks} ||
                            guards == std::set{Guard::dc3_ends, Guard::dc3_holds} ||
                            guards == std::set{Guard::dc1_starts, Guard::dc1_is_no_start};
      EXPECT_TRUE(complete) << name(state) << " " << name(input);
    }
  }
}

TEST(StateTable, NothingButAConfirmedResetLeavesTorn) {
  for (const Reaction& row : reactions()) {
    if (row.from == State::torn && row.input != Input::confirm_reset) {
      EXPECT_EQ(row.to, State::torn) << name(row.input);
    }
  }
  for (const Progress& row : progress()) EXPECT_NE(row.from, State::torn);
}

TEST(StateTable, OnlyDc1AndAPersonMakeBytesGoOut) {
  for (const Reaction& row : reactions()) {
    if (!may_hand(row.to) || may_hand(row.from)) continue;
    EXPECT_TRUE(row.input == Input::dc1 || row.input == Input::resume || row.input == Input::resume_as_dc1)
        << name(row.from) << " " << name(row.input);
    EXPECT_TRUE(has_job(row.from)) << name(row.from);
  }
  for (const Progress& row : progress()) {
    if (may_hand(row.to) && !may_hand(row.from)) {
      EXPECT_EQ(row.condition, Condition::starts_open);
    }
  }
}

TEST(StateTable, ResumeAsDc1WorksOnlyWhereDc3Holds) {
  for (const State state : states()) {
    const Action action = rows_of(state, Input::resume_as_dc1).at(0).action;
    EXPECT_EQ(action == Action::stand_in, is_held(state)) << name(state);
    EXPECT_EQ(action == Action::refuse, !is_held(state)) << name(state);
  }
}

TEST(StateTable, BreakingInABlockTearsTheLineWhereverBytesWereOut) {
  for (const State state : states()) {
    for (const Input input : {Input::broken, Input::abort}) {
      for (const Reaction& row : rows_of(state, input)) {
        if (row.guard == Guard::in_block) {
          EXPECT_EQ(row.to, State::torn);
        }
        if (row.guard == Guard::between_blocks) {
          EXPECT_EQ(row.to, State::failed);
        }
      }
    }
    const bool split = rows_of(state, Input::broken).size() == 2;
    const bool nothing_begun = state == State::next_round;
    EXPECT_EQ(split, is_on_the_line(state) && !nothing_begun) << name(state);
  }
}

TEST(StateTable, EveryStateIsNamedAndReached) {
  std::set<std::string_view> names;
  std::set<State> reached{State::idle};
  for (const Reaction& row : reactions()) reached.insert(row.to);
  for (const Progress& row : progress()) reached.insert(row.to);
  for (const State state : states()) names.insert(name(state));
  EXPECT_EQ(names.size(), kStates);
  EXPECT_EQ(reached.size(), kStates);
}

}  // namespace
}  // namespace dripfeed::feed
