// The sender's transition table: a cell for every state and input, states in the order of the enum, inputs within them.
#include "protocol/packet/state.h"

#include <array>

namespace dripfeed::packet {
namespace {

using S = State;
using A = Action;

// clang-format off
constexpr std::array<Cell, kStates * kInputs> kCells{{
    {A::take, S::armed},  // idle, arm
    {A::refuse, S::idle},  // idle, disarm
    {A::refuse, S::idle},  // idle, stop
    {A::refuse, S::idle},  // idle, resume
    {A::refuse, S::idle},  // idle, cancel
    {A::refuse, S::idle},  // idle, abort
    {A::refuse, S::idle},  // idle, confirm_reset
    {A::unarmed, S::idle},  // idle, asked
    {A::never, S::idle},  // idle, granted
    {A::never, S::idle},  // idle, accepted
    {A::never, S::idle},  // idle, again
    {A::none, S::idle},  // idle, broken
    {A::never, S::idle},  // idle, frame_out
    {A::never, S::idle},  // idle, frame_ready
    {A::never, S::idle},  // idle, finished
    {A::never, S::idle},  // idle, cut
    {A::never, S::idle},  // idle, expired
    {A::never, S::idle},  // idle, yielded

    {A::refuse, S::armed},  // armed, arm
    {A::end, S::disarmed},  // armed, disarm
    {A::refuse, S::armed},  // armed, stop
    {A::refuse, S::armed},  // armed, resume
    {A::end, S::disarmed},  // armed, cancel
    {A::end, S::disarmed},  // armed, abort
    {A::refuse, S::armed},  // armed, confirm_reset
    {A::start, S::ready},  // armed, asked
    {A::never, S::armed},  // armed, granted
    {A::never, S::armed},  // armed, accepted
    {A::never, S::armed},  // armed, again
    {A::end, S::disarmed},  // armed, broken
    {A::never, S::armed},  // armed, frame_out
    {A::never, S::armed},  // armed, frame_ready
    {A::never, S::armed},  // armed, finished
    {A::never, S::armed},  // armed, cut
    {A::end, S::disarmed},  // armed, expired
    {A::never, S::armed},  // armed, yielded

    {A::refuse, S::calling},  // calling, arm
    {A::refuse, S::calling},  // calling, disarm
    {A::want_stop, S::calling},  // calling, stop
    {A::unwant_stop, S::calling},  // calling, resume
    {A::want_cancel, S::calling},  // calling, cancel
    {A::fail, S::failed},  // calling, abort
    {A::refuse, S::calling},  // calling, confirm_reset
    {A::never, S::calling},  // calling, asked
    {A::send, S::sending},  // calling, granted
    {A::never, S::calling},  // calling, accepted
    {A::call, S::calling},  // calling, again
    {A::fail, S::failed},  // calling, broken
    {A::wait, S::calling},  // calling, frame_out
    {A::never, S::calling},  // calling, frame_ready
    {A::never, S::calling},  // calling, finished
    {A::never, S::calling},  // calling, cut
    {A::never, S::calling},  // calling, expired
    {A::give_way, S::receiving},  // calling, yielded

    {A::refuse, S::receiving},  // receiving, arm
    {A::refuse, S::receiving},  // receiving, disarm
    {A::want_stop, S::receiving},  // receiving, stop
    {A::unwant_stop, S::receiving},  // receiving, resume
    {A::want_cancel, S::receiving},  // receiving, cancel
    {A::fail, S::failed},  // receiving, abort
    {A::refuse, S::receiving},  // receiving, confirm_reset
    {A::never, S::receiving},  // receiving, asked
    {A::never, S::receiving},  // receiving, granted
    {A::never, S::receiving},  // receiving, accepted
    {A::call, S::calling},  // receiving, again
    {A::fail, S::failed},  // receiving, broken
    {A::never, S::receiving},  // receiving, frame_out
    {A::never, S::receiving},  // receiving, frame_ready
    {A::never, S::receiving},  // receiving, finished
    {A::never, S::receiving},  // receiving, cut
    {A::never, S::receiving},  // receiving, expired
    {A::never, S::receiving},  // receiving, yielded

    {A::refuse, S::sending},  // sending, arm
    {A::refuse, S::sending},  // sending, disarm
    {A::want_stop, S::sending},  // sending, stop
    {A::unwant_stop, S::sending},  // sending, resume
    {A::want_cancel, S::sending},  // sending, cancel
    {A::fail, S::failed},  // sending, abort
    {A::refuse, S::sending},  // sending, confirm_reset
    {A::never, S::sending},  // sending, asked
    {A::never, S::sending},  // sending, granted
    {A::never, S::sending},  // sending, accepted
    {A::call, S::calling},  // sending, again
    {A::fail, S::failed},  // sending, broken
    {A::sent, S::waiting},  // sending, frame_out
    {A::never, S::sending},  // sending, frame_ready
    {A::never, S::sending},  // sending, finished
    {A::never, S::sending},  // sending, cut
    {A::never, S::sending},  // sending, expired
    {A::never, S::sending},  // sending, yielded

    {A::refuse, S::waiting},  // waiting, arm
    {A::refuse, S::waiting},  // waiting, disarm
    {A::want_stop, S::waiting},  // waiting, stop
    {A::unwant_stop, S::waiting},  // waiting, resume
    {A::want_cancel, S::waiting},  // waiting, cancel
    {A::fail, S::failed},  // waiting, abort
    {A::refuse, S::waiting},  // waiting, confirm_reset
    {A::accept_asked, S::ready},  // waiting, asked
    {A::never, S::waiting},  // waiting, granted
    {A::accept, S::ready},  // waiting, accepted
    {A::call, S::calling},  // waiting, again
    {A::fail, S::failed},  // waiting, broken
    {A::never, S::waiting},  // waiting, frame_out
    {A::never, S::waiting},  // waiting, frame_ready
    {A::never, S::waiting},  // waiting, finished
    {A::never, S::waiting},  // waiting, cut
    {A::never, S::waiting},  // waiting, expired
    {A::never, S::waiting},  // waiting, yielded

    {A::refuse, S::ready},  // ready, arm
    {A::refuse, S::ready},  // ready, disarm
    {A::want_stop, S::ready},  // ready, stop
    {A::unwant_stop, S::ready},  // ready, resume
    {A::want_cancel, S::ready},  // ready, cancel
    {A::fail, S::failed},  // ready, abort
    {A::refuse, S::ready},  // ready, confirm_reset
    {A::note_asked, S::ready},  // ready, asked
    {A::never, S::ready},  // ready, granted
    {A::never, S::ready},  // ready, accepted
    {A::repeat, S::sending},  // ready, again
    {A::fail, S::failed},  // ready, broken
    {A::never, S::ready},  // ready, frame_out
    {A::call, S::calling},  // ready, frame_ready
    {A::close, S::closing},  // ready, finished
    {A::part, S::cancelled},  // ready, cut
    {A::never, S::ready},  // ready, expired
    {A::never, S::ready},  // ready, yielded

    {A::refuse, S::closing},  // closing, arm
    {A::refuse, S::closing},  // closing, disarm
    {A::refuse, S::closing},  // closing, stop
    {A::refuse, S::closing},  // closing, resume
    {A::refuse, S::closing},  // closing, cancel
    {A::fail, S::failed},  // closing, abort
    {A::refuse, S::closing},  // closing, confirm_reset
    {A::never, S::closing},  // closing, asked
    {A::never, S::closing},  // closing, granted
    {A::end, S::done},  // closing, accepted
    {A::close, S::closing},  // closing, again
    {A::fail, S::failed},  // closing, broken
    {A::wait, S::closing},  // closing, frame_out
    {A::never, S::closing},  // closing, frame_ready
    {A::never, S::closing},  // closing, finished
    {A::never, S::closing},  // closing, cut
    {A::never, S::closing},  // closing, expired
    {A::never, S::closing},  // closing, yielded

    {A::take, S::armed},  // done, arm
    {A::refuse, S::done},  // done, disarm
    {A::refuse, S::done},  // done, stop
    {A::refuse, S::done},  // done, resume
    {A::refuse, S::done},  // done, cancel
    {A::refuse, S::done},  // done, abort
    {A::refuse, S::done},  // done, confirm_reset
    {A::unarmed, S::done},  // done, asked
    {A::never, S::done},  // done, granted
    {A::never, S::done},  // done, accepted
    {A::never, S::done},  // done, again
    {A::none, S::done},  // done, broken
    {A::never, S::done},  // done, frame_out
    {A::never, S::done},  // done, frame_ready
    {A::never, S::done},  // done, finished
    {A::never, S::done},  // done, cut
    {A::never, S::done},  // done, expired
    {A::never, S::done},  // done, yielded

    {A::take, S::armed},  // failed, arm
    {A::refuse, S::failed},  // failed, disarm
    {A::refuse, S::failed},  // failed, stop
    {A::refuse, S::failed},  // failed, resume
    {A::refuse, S::failed},  // failed, cancel
    {A::refuse, S::failed},  // failed, abort
    {A::refuse, S::failed},  // failed, confirm_reset
    {A::unarmed, S::failed},  // failed, asked
    {A::never, S::failed},  // failed, granted
    {A::never, S::failed},  // failed, accepted
    {A::never, S::failed},  // failed, again
    {A::none, S::failed},  // failed, broken
    {A::never, S::failed},  // failed, frame_out
    {A::never, S::failed},  // failed, frame_ready
    {A::never, S::failed},  // failed, finished
    {A::never, S::failed},  // failed, cut
    {A::never, S::failed},  // failed, expired
    {A::never, S::failed},  // failed, yielded

    {A::refuse, S::torn},  // torn, arm
    {A::refuse, S::torn},  // torn, disarm
    {A::refuse, S::torn},  // torn, stop
    {A::refuse, S::torn},  // torn, resume
    {A::refuse, S::torn},  // torn, cancel
    {A::refuse, S::torn},  // torn, abort
    {A::clear, S::idle},  // torn, confirm_reset
    {A::unarmed, S::torn},  // torn, asked
    {A::never, S::torn},  // torn, granted
    {A::never, S::torn},  // torn, accepted
    {A::never, S::torn},  // torn, again
    {A::none, S::torn},  // torn, broken
    {A::never, S::torn},  // torn, frame_out
    {A::never, S::torn},  // torn, frame_ready
    {A::never, S::torn},  // torn, finished
    {A::never, S::torn},  // torn, cut
    {A::never, S::torn},  // torn, expired
    {A::never, S::torn},  // torn, yielded

    {A::take, S::armed},  // cancelled, arm
    {A::refuse, S::cancelled},  // cancelled, disarm
    {A::refuse, S::cancelled},  // cancelled, stop
    {A::refuse, S::cancelled},  // cancelled, resume
    {A::refuse, S::cancelled},  // cancelled, cancel
    {A::refuse, S::cancelled},  // cancelled, abort
    {A::refuse, S::cancelled},  // cancelled, confirm_reset
    {A::unarmed, S::cancelled},  // cancelled, asked
    {A::never, S::cancelled},  // cancelled, granted
    {A::never, S::cancelled},  // cancelled, accepted
    {A::never, S::cancelled},  // cancelled, again
    {A::none, S::cancelled},  // cancelled, broken
    {A::never, S::cancelled},  // cancelled, frame_out
    {A::never, S::cancelled},  // cancelled, frame_ready
    {A::never, S::cancelled},  // cancelled, finished
    {A::never, S::cancelled},  // cancelled, cut
    {A::never, S::cancelled},  // cancelled, expired
    {A::never, S::cancelled},  // cancelled, yielded

    {A::take, S::armed},  // disarmed, arm
    {A::refuse, S::disarmed},  // disarmed, disarm
    {A::refuse, S::disarmed},  // disarmed, stop
    {A::refuse, S::disarmed},  // disarmed, resume
    {A::refuse, S::disarmed},  // disarmed, cancel
    {A::refuse, S::disarmed},  // disarmed, abort
    {A::refuse, S::disarmed},  // disarmed, confirm_reset
    {A::unarmed, S::disarmed},  // disarmed, asked
    {A::never, S::disarmed},  // disarmed, granted
    {A::never, S::disarmed},  // disarmed, accepted
    {A::never, S::disarmed},  // disarmed, again
    {A::none, S::disarmed},  // disarmed, broken
    {A::never, S::disarmed},  // disarmed, frame_out
    {A::never, S::disarmed},  // disarmed, frame_ready
    {A::never, S::disarmed},  // disarmed, finished
    {A::never, S::disarmed},  // disarmed, cut
    {A::never, S::disarmed},  // disarmed, expired
    {A::never, S::disarmed},  // disarmed, yielded
}};
// clang-format on

constexpr std::array<std::string_view, kStates> kStateNames = {
    "idle",    "armed", "calling", "receiving", "sending",   "waiting", "ready",
    "closing", "done",  "failed",  "torn",      "cancelled", "disarmed"};
constexpr std::array<std::string_view, kInputs> kInputNames = {
    "arm",      "disarm", "stop",   "resume",    "cancel",      "abort",    "confirm_reset", "asked",   "granted",
    "accepted", "again",  "broken", "frame_out", "frame_ready", "finished", "cut",           "expired", "yielded"};

}  // namespace

Cell cell(State state, Input input) {
  return kCells[static_cast<std::size_t>(state) * kInputs + static_cast<std::size_t>(input)];
}

std::string_view name(State state) { return kStateNames[static_cast<std::size_t>(state)]; }
std::string_view name(Input input) { return kInputNames[static_cast<std::size_t>(input)]; }

}  // namespace dripfeed::packet
