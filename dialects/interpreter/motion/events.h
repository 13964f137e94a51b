// Motions of no length: what the control does where it stands.
#pragma once

#include <cstdint>

#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/ir/motion.h"

namespace dripfeed::interpreter {

// An event that stands where the state says (message, stop, end).
ir::Motion& emit_event(ir::MotionKind kind, const ModalState& state, MotionBuffer& out);
// Events for what is commanded and was not announced: offset, tool, spindle, coolant, comp. `orders` (ir::kOrders…) of
// a run that reports every order have an event each, whatever was announced.
void announce(ModalState& state, MotionBuffer& out, std::uint16_t orders = 0);

}  // namespace dripfeed::interpreter
