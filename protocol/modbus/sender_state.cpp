// The sender's transition table: a cell for every state and input, states in the order of the enum, inputs within them.
#include "protocol/modbus/sender_state.h"

#include <array>

namespace dripfeed::modbus {
namespace {

using S = SenderState;
using A = SenderAction;

// clang-format off
constexpr std::array<SenderCell, kSenderStates * kSenderInputs> kCells{{
    {A::never, S::idle},  // idle, vacant
    {A::never, S::idle},  // idle, acknowledged
    {A::never, S::idle},  // idle, not_yet
    {A::never, S::idle},  // idle, refused
    {A::never, S::idle},  // idle, ended
    {A::never, S::idle},  // idle, contradiction
    {A::never, S::idle},  // idle, failed
    {A::never, S::idle},  // idle, gone
    {A::never, S::idle},  // idle, hold_due
    {A::never, S::idle},  // idle, has_block
    {A::never, S::idle},  // idle, has_end
    {A::never, S::idle},  // idle, text_lost
    {A::begin, S::looking},  // idle, start
    {A::begin, S::looking},  // idle, resume
    {A::refuse, S::idle},  // idle, hold
    {A::refuse, S::idle},  // idle, release
    {A::refuse, S::idle},  // idle, abort
    {A::refuse, S::idle},  // idle, proceed

    {A::open, S::opening},  // looking, vacant
    {A::opened, S::ready},  // looking, acknowledged
    {A::again, S::looking},  // looking, not_yet
    {A::never, S::looking},  // looking, refused
    {A::never, S::looking},  // looking, ended
    {A::stop, S::stopped},  // looking, contradiction
    {A::again, S::looking},  // looking, failed
    {A::stop, S::stopped},  // looking, gone
    {A::never, S::looking},  // looking, hold_due
    {A::never, S::looking},  // looking, has_block
    {A::never, S::looking},  // looking, has_end
    {A::stop, S::stopped},  // looking, text_lost
    {A::refuse, S::looking},  // looking, start
    {A::refuse, S::looking},  // looking, resume
    {A::refuse, S::looking},  // looking, hold
    {A::refuse, S::looking},  // looking, release
    {A::abort, S::aborting},  // looking, abort
    {A::refuse, S::looking},  // looking, proceed

    {A::never, S::opening},  // opening, vacant
    {A::opened, S::ready},  // opening, acknowledged
    {A::again, S::opening},  // opening, not_yet
    {A::never, S::opening},  // opening, refused
    {A::never, S::opening},  // opening, ended
    {A::stop, S::stopped},  // opening, contradiction
    {A::again, S::opening},  // opening, failed
    {A::stop, S::stopped},  // opening, gone
    {A::never, S::opening},  // opening, hold_due
    {A::never, S::opening},  // opening, has_block
    {A::never, S::opening},  // opening, has_end
    {A::never, S::opening},  // opening, text_lost
    {A::refuse, S::opening},  // opening, start
    {A::refuse, S::opening},  // opening, resume
    {A::refuse, S::opening},  // opening, hold
    {A::refuse, S::opening},  // opening, release
    {A::abort, S::aborting},  // opening, abort
    {A::refuse, S::opening},  // opening, proceed

    {A::never, S::ready},  // ready, vacant
    {A::never, S::ready},  // ready, acknowledged
    {A::again, S::ready},  // ready, not_yet
    {A::never, S::ready},  // ready, refused
    {A::never, S::ready},  // ready, ended
    {A::stop, S::stopped},  // ready, contradiction
    {A::again, S::ready},  // ready, failed
    {A::stop, S::stopped},  // ready, gone
    {A::hold, S::holding},  // ready, hold_due
    {A::deliver, S::delivering},  // ready, has_block
    {A::close, S::closing},  // ready, has_end
    {A::stop, S::stopped},  // ready, text_lost
    {A::refuse, S::ready},  // ready, start
    {A::refuse, S::ready},  // ready, resume
    {A::want_hold, S::ready},  // ready, hold
    {A::unwant_hold, S::ready},  // ready, release
    {A::abort, S::aborting},  // ready, abort
    {A::refuse, S::ready},  // ready, proceed

    {A::never, S::delivering},  // delivering, vacant
    {A::confirm, S::ready},  // delivering, acknowledged
    {A::again, S::delivering},  // delivering, not_yet
    {A::rewrite, S::delivering},  // delivering, refused
    {A::never, S::delivering},  // delivering, ended
    {A::stop, S::stopped},  // delivering, contradiction
    {A::again, S::delivering},  // delivering, failed
    {A::stop, S::stopped},  // delivering, gone
    {A::never, S::delivering},  // delivering, hold_due
    {A::never, S::delivering},  // delivering, has_block
    {A::never, S::delivering},  // delivering, has_end
    {A::never, S::delivering},  // delivering, text_lost
    {A::refuse, S::delivering},  // delivering, start
    {A::refuse, S::delivering},  // delivering, resume
    {A::want_hold, S::delivering},  // delivering, hold
    {A::unwant_hold, S::delivering},  // delivering, release
    {A::abort, S::aborting},  // delivering, abort
    {A::refuse, S::delivering},  // delivering, proceed

    {A::never, S::closing},  // closing, vacant
    {A::confirm, S::finishing},  // closing, acknowledged
    {A::again, S::closing},  // closing, not_yet
    {A::rewrite, S::closing},  // closing, refused
    {A::never, S::closing},  // closing, ended
    {A::stop, S::stopped},  // closing, contradiction
    {A::again, S::closing},  // closing, failed
    {A::stop, S::stopped},  // closing, gone
    {A::never, S::closing},  // closing, hold_due
    {A::never, S::closing},  // closing, has_block
    {A::never, S::closing},  // closing, has_end
    {A::never, S::closing},  // closing, text_lost
    {A::refuse, S::closing},  // closing, start
    {A::refuse, S::closing},  // closing, resume
    {A::refuse, S::closing},  // closing, hold
    {A::refuse, S::closing},  // closing, release
    {A::abort, S::aborting},  // closing, abort
    {A::refuse, S::closing},  // closing, proceed

    {A::never, S::finishing},  // finishing, vacant
    {A::never, S::finishing},  // finishing, acknowledged
    {A::again, S::finishing},  // finishing, not_yet
    {A::never, S::finishing},  // finishing, refused
    {A::change, S::done},  // finishing, ended
    {A::stop, S::stopped},  // finishing, contradiction
    {A::again, S::finishing},  // finishing, failed
    {A::stop, S::stopped},  // finishing, gone
    {A::never, S::finishing},  // finishing, hold_due
    {A::never, S::finishing},  // finishing, has_block
    {A::never, S::finishing},  // finishing, has_end
    {A::never, S::finishing},  // finishing, text_lost
    {A::refuse, S::finishing},  // finishing, start
    {A::refuse, S::finishing},  // finishing, resume
    {A::refuse, S::finishing},  // finishing, hold
    {A::refuse, S::finishing},  // finishing, release
    {A::abort, S::aborting},  // finishing, abort
    {A::refuse, S::finishing},  // finishing, proceed

    {A::never, S::done},  // done, vacant
    {A::never, S::done},  // done, acknowledged
    {A::never, S::done},  // done, not_yet
    {A::never, S::done},  // done, refused
    {A::never, S::done},  // done, ended
    {A::never, S::done},  // done, contradiction
    {A::never, S::done},  // done, failed
    {A::never, S::done},  // done, gone
    {A::never, S::done},  // done, hold_due
    {A::never, S::done},  // done, has_block
    {A::never, S::done},  // done, has_end
    {A::never, S::done},  // done, text_lost
    {A::begin, S::looking},  // done, start
    {A::begin, S::looking},  // done, resume
    {A::refuse, S::done},  // done, hold
    {A::refuse, S::done},  // done, release
    {A::refuse, S::done},  // done, abort
    {A::refuse, S::done},  // done, proceed

    {A::never, S::holding},  // holding, vacant
    {A::change, S::held},  // holding, acknowledged
    {A::again, S::holding},  // holding, not_yet
    {A::never, S::holding},  // holding, refused
    {A::never, S::holding},  // holding, ended
    {A::stop, S::stopped},  // holding, contradiction
    {A::again, S::holding},  // holding, failed
    {A::stop, S::stopped},  // holding, gone
    {A::never, S::holding},  // holding, hold_due
    {A::never, S::holding},  // holding, has_block
    {A::never, S::holding},  // holding, has_end
    {A::never, S::holding},  // holding, text_lost
    {A::refuse, S::holding},  // holding, start
    {A::refuse, S::holding},  // holding, resume
    {A::none, S::holding},  // holding, hold
    {A::release, S::releasing},  // holding, release
    {A::abort, S::aborting},  // holding, abort
    {A::refuse, S::holding},  // holding, proceed

    {A::never, S::held},  // held, vacant
    {A::never, S::held},  // held, acknowledged
    {A::again, S::held},  // held, not_yet
    {A::never, S::held},  // held, refused
    {A::never, S::held},  // held, ended
    {A::stop, S::stopped},  // held, contradiction
    {A::again, S::held},  // held, failed
    {A::stop, S::stopped},  // held, gone
    {A::never, S::held},  // held, hold_due
    {A::never, S::held},  // held, has_block
    {A::never, S::held},  // held, has_end
    {A::never, S::held},  // held, text_lost
    {A::refuse, S::held},  // held, start
    {A::refuse, S::held},  // held, resume
    {A::none, S::held},  // held, hold
    {A::release, S::releasing},  // held, release
    {A::abort, S::aborting},  // held, abort
    {A::refuse, S::held},  // held, proceed

    {A::never, S::releasing},  // releasing, vacant
    {A::change, S::ready},  // releasing, acknowledged
    {A::again, S::releasing},  // releasing, not_yet
    {A::never, S::releasing},  // releasing, refused
    {A::never, S::releasing},  // releasing, ended
    {A::stop, S::stopped},  // releasing, contradiction
    {A::again, S::releasing},  // releasing, failed
    {A::stop, S::stopped},  // releasing, gone
    {A::never, S::releasing},  // releasing, hold_due
    {A::never, S::releasing},  // releasing, has_block
    {A::never, S::releasing},  // releasing, has_end
    {A::never, S::releasing},  // releasing, text_lost
    {A::refuse, S::releasing},  // releasing, start
    {A::refuse, S::releasing},  // releasing, resume
    {A::hold, S::holding},  // releasing, hold
    {A::refuse, S::releasing},  // releasing, release
    {A::abort, S::aborting},  // releasing, abort
    {A::refuse, S::releasing},  // releasing, proceed

    {A::never, S::aborting},  // aborting, vacant
    {A::change, S::aborted},  // aborting, acknowledged
    {A::again, S::aborting},  // aborting, not_yet
    {A::never, S::aborting},  // aborting, refused
    {A::never, S::aborting},  // aborting, ended
    {A::stop, S::stopped},  // aborting, contradiction
    {A::again, S::aborting},  // aborting, failed
    {A::stop, S::stopped},  // aborting, gone
    {A::never, S::aborting},  // aborting, hold_due
    {A::never, S::aborting},  // aborting, has_block
    {A::never, S::aborting},  // aborting, has_end
    {A::never, S::aborting},  // aborting, text_lost
    {A::refuse, S::aborting},  // aborting, start
    {A::refuse, S::aborting},  // aborting, resume
    {A::refuse, S::aborting},  // aborting, hold
    {A::refuse, S::aborting},  // aborting, release
    {A::none, S::aborting},  // aborting, abort
    {A::refuse, S::aborting},  // aborting, proceed

    {A::never, S::aborted},  // aborted, vacant
    {A::never, S::aborted},  // aborted, acknowledged
    {A::never, S::aborted},  // aborted, not_yet
    {A::never, S::aborted},  // aborted, refused
    {A::never, S::aborted},  // aborted, ended
    {A::never, S::aborted},  // aborted, contradiction
    {A::never, S::aborted},  // aborted, failed
    {A::never, S::aborted},  // aborted, gone
    {A::never, S::aborted},  // aborted, hold_due
    {A::never, S::aborted},  // aborted, has_block
    {A::never, S::aborted},  // aborted, has_end
    {A::never, S::aborted},  // aborted, text_lost
    {A::begin, S::looking},  // aborted, start
    {A::begin, S::looking},  // aborted, resume
    {A::refuse, S::aborted},  // aborted, hold
    {A::refuse, S::aborted},  // aborted, release
    {A::refuse, S::aborted},  // aborted, abort
    {A::refuse, S::aborted},  // aborted, proceed

    {A::never, S::stopped},  // stopped, vacant
    {A::never, S::stopped},  // stopped, acknowledged
    {A::never, S::stopped},  // stopped, not_yet
    {A::never, S::stopped},  // stopped, refused
    {A::never, S::stopped},  // stopped, ended
    {A::never, S::stopped},  // stopped, contradiction
    {A::never, S::stopped},  // stopped, failed
    {A::never, S::stopped},  // stopped, gone
    {A::never, S::stopped},  // stopped, hold_due
    {A::never, S::stopped},  // stopped, has_block
    {A::never, S::stopped},  // stopped, has_end
    {A::never, S::stopped},  // stopped, text_lost
    {A::begin, S::looking},  // stopped, start
    {A::begin, S::looking},  // stopped, resume
    {A::refuse, S::stopped},  // stopped, hold
    {A::refuse, S::stopped},  // stopped, release
    {A::abort, S::aborting},  // stopped, abort
    {A::look_again, S::looking},  // stopped, proceed
}};
// clang-format on

}  // namespace

SenderCell cell(SenderState state, SenderInput input) {
  return kCells[static_cast<std::size_t>(state) * kSenderInputs + static_cast<std::size_t>(input)];
}

}  // namespace dripfeed::modbus
