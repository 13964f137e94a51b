// The receiver's transition table, states in the order of the enum, inputs within them.
#include "protocol/packet/receive_state.h"

#include <array>

namespace dripfeed::packet {
namespace {

using S = ReceiveState;
using A = ReceiveAction;

// clang-format off
constexpr std::array<ReceiveCell, kReceiveStates * kReceiveInputs> kCells{{
    {A::begin, S::inviting},  // idle, start
    {A::refuse, S::idle},  // idle, stop
    {A::never, S::idle},  // idle, header
    {A::never, S::idle},  // idle, good
    {A::never, S::idle},  // idle, repeated
    {A::never, S::idle},  // idle, bad
    {A::never, S::idle},  // idle, out_of_step
    {A::never, S::idle},  // idle, first_end
    {A::never, S::idle},  // idle, end
    {A::never, S::idle},  // idle, cancelled
    {A::never, S::idle},  // idle, silent
    {A::never, S::idle},  // idle, gave_up
    {A::never, S::idle},  // idle, room
    {A::none, S::idle},  // idle, lost
    {A::never, S::idle},  // idle, nothing
    {A::never, S::idle},  // idle, aside

    {A::refuse, S::inviting},  // inviting, start
    {A::cancel, S::failed},  // inviting, stop
    {A::take, S::framing},  // inviting, header
    {A::never, S::inviting},  // inviting, good
    {A::never, S::inviting},  // inviting, repeated
    {A::never, S::inviting},  // inviting, bad
    {A::never, S::inviting},  // inviting, out_of_step
    {A::ask_again, S::waiting},  // inviting, first_end
    {A::never, S::inviting},  // inviting, end
    {A::fail, S::failed},  // inviting, cancelled
    {A::invite, S::inviting},  // inviting, silent
    {A::never, S::inviting},  // inviting, gave_up
    {A::never, S::inviting},  // inviting, room
    {A::fail, S::failed},  // inviting, lost
    {A::never, S::inviting},  // inviting, nothing
    {A::never, S::inviting},  // inviting, aside

    {A::refuse, S::waiting},  // waiting, start
    {A::cancel, S::failed},  // waiting, stop
    {A::take, S::framing},  // waiting, header
    {A::never, S::waiting},  // waiting, good
    {A::never, S::waiting},  // waiting, repeated
    {A::never, S::waiting},  // waiting, bad
    {A::cancel, S::failed},  // waiting, out_of_step
    {A::ask_again, S::waiting},  // waiting, first_end
    {A::finish, S::done},  // waiting, end
    {A::fail, S::failed},  // waiting, cancelled
    {A::ask_again, S::waiting},  // waiting, silent
    {A::cancel, S::failed},  // waiting, gave_up
    {A::never, S::waiting},  // waiting, room
    {A::fail, S::failed},  // waiting, lost
    {A::never, S::waiting},  // waiting, nothing
    {A::note, S::waiting},  // waiting, aside

    {A::refuse, S::framing},  // framing, start
    {A::cancel, S::failed},  // framing, stop
    {A::never, S::framing},  // framing, header
    {A::keep, S::waiting},  // framing, good
    {A::acknowledge, S::waiting},  // framing, repeated
    {A::purge, S::purging},  // framing, bad
    {A::cancel, S::failed},  // framing, out_of_step
    {A::never, S::framing},  // framing, first_end
    {A::finish, S::done},  // framing, end
    {A::never, S::framing},  // framing, cancelled
    {A::ask_again, S::waiting},  // framing, silent
    {A::cancel, S::failed},  // framing, gave_up
    {A::never, S::framing},  // framing, room
    {A::fail, S::failed},  // framing, lost
    {A::listen, S::waiting},  // framing, nothing
    {A::note, S::waiting},  // framing, aside

    {A::refuse, S::purging},  // purging, start
    {A::cancel, S::failed},  // purging, stop
    {A::never, S::purging},  // purging, header
    {A::never, S::purging},  // purging, good
    {A::never, S::purging},  // purging, repeated
    {A::never, S::purging},  // purging, bad
    {A::never, S::purging},  // purging, out_of_step
    {A::never, S::purging},  // purging, first_end
    {A::never, S::purging},  // purging, end
    {A::never, S::purging},  // purging, cancelled
    {A::ask_again, S::waiting},  // purging, silent
    {A::cancel, S::failed},  // purging, gave_up
    {A::never, S::purging},  // purging, room
    {A::fail, S::failed},  // purging, lost
    {A::never, S::purging},  // purging, nothing
    {A::never, S::purging},  // purging, aside

    {A::refuse, S::full},  // full, start
    {A::cancel, S::failed},  // full, stop
    {A::never, S::full},  // full, header
    {A::never, S::full},  // full, good
    {A::never, S::full},  // full, repeated
    {A::never, S::full},  // full, bad
    {A::never, S::full},  // full, out_of_step
    {A::never, S::full},  // full, first_end
    {A::never, S::full},  // full, end
    {A::fail, S::failed},  // full, cancelled
    {A::never, S::full},  // full, silent
    {A::never, S::full},  // full, gave_up
    {A::acknowledge, S::waiting},  // full, room
    {A::fail, S::failed},  // full, lost
    {A::never, S::full},  // full, nothing
    {A::never, S::full},  // full, aside

    {A::begin, S::inviting},  // done, start
    {A::refuse, S::done},  // done, stop
    {A::never, S::done},  // done, header
    {A::never, S::done},  // done, good
    {A::never, S::done},  // done, repeated
    {A::never, S::done},  // done, bad
    {A::never, S::done},  // done, out_of_step
    {A::never, S::done},  // done, first_end
    {A::never, S::done},  // done, end
    {A::never, S::done},  // done, cancelled
    {A::never, S::done},  // done, silent
    {A::never, S::done},  // done, gave_up
    {A::never, S::done},  // done, room
    {A::none, S::done},  // done, lost
    {A::never, S::done},  // done, nothing
    {A::never, S::done},  // done, aside

    {A::begin, S::inviting},  // failed, start
    {A::refuse, S::failed},  // failed, stop
    {A::never, S::failed},  // failed, header
    {A::never, S::failed},  // failed, good
    {A::never, S::failed},  // failed, repeated
    {A::never, S::failed},  // failed, bad
    {A::never, S::failed},  // failed, out_of_step
    {A::never, S::failed},  // failed, first_end
    {A::never, S::failed},  // failed, end
    {A::never, S::failed},  // failed, cancelled
    {A::never, S::failed},  // failed, silent
    {A::never, S::failed},  // failed, gave_up
    {A::never, S::failed},  // failed, room
    {A::none, S::failed},  // failed, lost
    {A::never, S::failed},  // failed, nothing
    {A::never, S::failed},  // failed, aside
}};
// clang-format on

constexpr std::array<std::string_view, kReceiveStates> kStateNames = {"idle",    "inviting", "waiting", "framing",
                                                                      "purging", "full",     "done",    "failed"};
constexpr std::array<std::string_view, kReceiveInputs> kInputNames = {
    "start", "stop",      "header", "good",    "repeated", "bad",  "out_of_step", "first_end",
    "end",   "cancelled", "silent", "gave_up", "room",     "lost", "nothing"};

}  // namespace

ReceiveCell cell(ReceiveState state, ReceiveInput input) {
  return kCells[static_cast<std::size_t>(state) * kReceiveInputs + static_cast<std::size_t>(input)];
}

std::string_view name(ReceiveState state) { return kStateNames[static_cast<std::size_t>(state)]; }
std::string_view name(ReceiveInput input) { return kInputNames[static_cast<std::size_t>(input)]; }

}  // namespace dripfeed::packet
