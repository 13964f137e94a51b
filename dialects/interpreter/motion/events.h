// Motions of no length: what the control does where it stands.
#pragma once

#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/ir/motion.h"

namespace dripfeed::interpreter {

// An event that stands where the state says (message, stop, end).
ir::Motion& emit_event(ir::MotionKind kind, const ModalState& state, MotionBuffer& out);
// Events for what is commanded and was not announced: offset, tool, spindle, coolant, comp.
void announce(ModalState& state, MotionBuffer& out);

}  // namespace dripfeed::interpreter
