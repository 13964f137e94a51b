// Groups of states that the machine treats alike outside the table: who may hand bytes, who counts as held.
#pragma once

#include "protocol/feed/state.h"

namespace dripfeed::feed {

// Bytes may go out, if pacing, CTS, ledger, text and a wanted block end allow.
constexpr bool may_hand(State state) {
  return state == State::sending || state == State::stopping || state == State::cancelling || state == State::trailer;
}
// Bytes may go out only up to the end of the present block.
constexpr bool ends_with_block(State state) { return state == State::stopping || state == State::cancelling; }
// DC3 holds.
constexpr bool is_held(State state) {
  return state == State::held || state == State::stopping_held || state == State::stopped_held ||
         state == State::cancelling_held || state == State::trailer_held;
}
// A program is between its start and its end.
constexpr bool is_on_the_line(State state) {
  return may_hand(state) || is_held(state) || state == State::stopped || state == State::reset_suspected ||
         state == State::draining || state == State::wait_end || state == State::ending || state == State::next_round;
}
// The control's own start is waited for.
constexpr bool awaits_start(State state) { return state == State::armed || state == State::next_round; }
// A job is taken and not over.
constexpr bool has_job(State state) { return state == State::armed || is_on_the_line(state); }

}  // namespace dripfeed::feed
