// What a feed's states mean to those who watch its line: the line's state, and how a job ended. One row a state.
#pragma once

#include <array>

#include "protocol/feed/feed.h"
#include "protocol/feed/state_groups.h"
#include "server/app/lines/line.h"

namespace dripfeed::app {

struct FeedStateRow {
  feed::State feed;
  LineState line;
  JobEnd end;
};
// One row a state of the feed, in its order.
inline constexpr std::array<FeedStateRow, feed::kStates> kFeedStateRows = {{
    {feed::State::idle, LineState::idle, JobEnd::none},
    {feed::State::armed, LineState::armed, JobEnd::none},
    {feed::State::sending, LineState::feeding, JobEnd::none},
    {feed::State::held, LineState::held, JobEnd::none},
    {feed::State::stopping, LineState::feeding, JobEnd::none},
    {feed::State::stopping_held, LineState::held, JobEnd::none},
    {feed::State::stopped, LineState::held, JobEnd::none},
    {feed::State::stopped_held, LineState::held, JobEnd::none},
    {feed::State::reset_suspected, LineState::held, JobEnd::none},
    {feed::State::cancelling, LineState::feeding, JobEnd::none},
    {feed::State::cancelling_held, LineState::held, JobEnd::none},
    {feed::State::trailer, LineState::draining, JobEnd::none},
    {feed::State::trailer_held, LineState::held, JobEnd::none},
    {feed::State::draining, LineState::draining, JobEnd::none},
    {feed::State::wait_end, LineState::draining, JobEnd::none},
    {feed::State::ending, LineState::draining, JobEnd::none},
    {feed::State::next_round, LineState::held, JobEnd::none},
    {feed::State::done, LineState::idle, JobEnd::done},
    {feed::State::failed, LineState::idle, JobEnd::failed},
    {feed::State::torn, LineState::torn, JobEnd::failed},
    {feed::State::cancelled, LineState::idle, JobEnd::cancelled},
    {feed::State::disarmed, LineState::idle, JobEnd::disarmed},
}};

inline constexpr std::array kFeedStopStates = {feed::State::stopping, feed::State::stopping_held, feed::State::stopped,
                                               feed::State::stopped_held, feed::State::reset_suspected};

constexpr bool feed_state_rows_in_order() {
  for (std::size_t i = 0; i < kFeedStateRows.size(); ++i) {
    if (static_cast<std::size_t>(kFeedStateRows[i].feed) != i) return false;
  }
  return true;
}
static_assert(feed_state_rows_in_order());

// Where an answer is that the feed has, or had last.
inline AnswerStage answer_stage_of(feed::State state) {
  if (state == feed::State::armed) return AnswerStage::waiting;
  if (feed::has_job(state)) return AnswerStage::sending;
  return state == feed::State::torn ? AnswerStage::torn : AnswerStage::whole;
}

}  // namespace dripfeed::app
